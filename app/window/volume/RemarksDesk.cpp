// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/volume/RemarksDesk.h"

#include "app/document/DocumentText.h"
#include "app/document/OpenDocument.h"
#include "app/opening/OpeningDesk.h"
#include "app/window/MessageBar.h"
#include "app/window/volume/OrientationDesk.h"

namespace limn {

RemarksDesk::RemarksDesk(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
  connect(&m_parts.session, &Session::sceneChanged, this, &RemarksDesk::followScene);
}

void RemarksDesk::show(const std::vector<Message>& notes) {
  m_notes = notes;
  m_volume = m_parts.session.scene().volume;
  say();
}

void RemarksDesk::say() {
  const QStringList remarks = remarksOn(*m_volume, m_notes);
  m_said = remarks.value(0);
  if (remarks.isEmpty())
    return;
  const MessageBar::Action setSpacing{tr("Set spacing…"), [this] {
                                        const auto& open = m_parts.session.scene().volume;
                                        m_parts.opening.askForSpacing(m_parts.document.request(),
                                                                      open ? open->grid().spacingMm
                                                                           : glm::dvec3(1.0));
                                      }};
  const MessageBar::Action setOrientation{tr("Set orientation…"), [this] { m_parts.orientation.ask(); }};
  const VolumeInfo& info = m_volume->info();
  m_parts.messages.show(MessageBar::Kind::warning, m_said, remarks.mid(1),
                        !info.spacingKnown       ? setSpacing
                        : !info.orientationKnown ? setOrientation
                                                 : MessageBar::Action{});
}

// The same voxels, placed otherwise: a person said how they lie.
void RemarksDesk::followScene(const Scene& scene) {
  if (!m_volume || scene.volume == m_volume)
    return;
  const bool isPlacedAnew = scene.volume && scene.volume->sharesVoxelsWith(*m_volume);
  m_volume = isPlacedAnew ? scene.volume : nullptr;
  if (!isPlacedAnew || m_said.isEmpty() || m_parts.messages.sentence() != m_said ||
      m_parts.messages.isHidden())
    return;
  m_parts.messages.hide();
  say();
}

} // namespace limn
