// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/EarlierLook.h"

#include "app/document/OpenDocument.h"
#include "app/window/MessageBar.h"
#include "scene/presets/PresetFit.h"

#include <QAction>

namespace limn {

EarlierLook::EarlierLook(const Partners& with, QObject* parent) : QObject(parent), m_with(with) {
  with.use.setEnabled(false);
  connect(&with.session, &Session::sceneChanged, this, &EarlierLook::follow);
  connect(&with.use, &QAction::triggered, this, &EarlierLook::use);
}

void EarlierLook::follow(const Scene& scene) {
  const std::shared_ptr<const Volume> before = m_volume.lock();
  // Where the voxels of one volume lie may change: orientation can be set by hand.
  const bool isSame = before && scene.volume && before->sharesVoxelsWith(*scene.volume);
  std::optional<Landmarks> landmarks;
  if (isSame) {
    landmarks = m_present->look.landmarks;
  } else {
    if (m_present)
      m_earlier = std::move(m_present);
    m_present.reset();
    if (scene.volume)
      landmarks = landmarksOf(m_with.document.histogram());
  }
  m_volume = scene.volume;
  if (scene.volume) {
    m_present = {presetOf(scene, tr("Earlier look").toStdString()), looksLikeHounsfield(*scene.volume)};
    m_present->look.landmarks = landmarks;
  }
  m_with.use.setEnabled(m_earlier && scene.volume);
}

void EarlierLook::use() {
  const std::shared_ptr<const Volume>& volume = m_with.session.scene().volume;
  if (!m_earlier || !volume)
    return;
  Preset look = m_earlier->look;
  const bool haveOneScale = m_earlier->isHounsfield && looksLikeHounsfield(*volume);
  if (haveOneScale)
    look.landmarks.reset();
  m_with.session.usePreset(fittedTo(look, m_with.document.histogram(), volume->grid()),
                           {nextGestureId(), tr("use the look of the volume before")});
  if (!haveOneScale)
    m_with.messages.show(
        MessageBar::Kind::warning,
        tr("The look of the volume before was fitted to the values of this one: not both are in "
           "Hounsfield units."));
}

} // namespace limn
