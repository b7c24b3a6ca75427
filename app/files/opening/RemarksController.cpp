// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/RemarksController.h"

#include "app/core/sources/LookSource.h"
#include "app/document/DocumentText.h"
#include "app/files/opening/OpeningController.h"
#include "app/window/WindowContext.h"
#include "widgets/controls/MessageBar.h"

namespace limn {

RemarksController::RemarksController(WindowContext& context, OpeningController& opening)
    : QObject(&context.window), m_context(context), m_opening(opening) {
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene& scene) { followScene(scene); });
  // Queued: what was loaded is shown first, or left.
  connect(&opening, &OpeningController::loaded, this,
          [this](const LoadedScene& loaded, const Histogram&, const Request& request) {
            QMetaObject::invokeMethod(
                this, [this, loaded, request] { lookForLooks(loaded, request); }, Qt::QueuedConnection);
          });
}

void RemarksController::show(const std::vector<Message>& notes) {
  m_notes = notes;
  m_volume = m_context.session.scene().volume;
  say();
}

void RemarksController::say() {
  const QStringList remarks = remarksOn(*m_volume, m_notes);
  m_said = remarks.value(0);
  if (remarks.isEmpty())
    return;
  const MessageBar::Action setSpacing{tr("Set spacing…"), [this] {
                                        const auto& open = m_context.session.scene().volume;
                                        m_opening.askForSpacing(m_context.document.request(),
                                                                open ? open->grid().spacingMm
                                                                     : glm::dvec3(1.0));
                                      }};
  const MessageBar::Action setOrientation{tr("Set orientation…"),
                                          [this] { m_context.actions.find("setOrientation").trigger(); }};
  const VolumeInfo& info = m_volume->info();
  m_context.messages.show(MessageBar::Kind::warning, m_said, remarks.mid(1),
                          !info.spacingKnown       ? setSpacing
                          : !info.orientationKnown ? setOrientation
                                                   : MessageBar::Action{});
}

// The same voxels, placed otherwise: a person said how they lie.
void RemarksController::followScene(const Scene& scene) {
  if (!m_volume || scene.volume == m_volume)
    return;
  const bool isPlacedAnew = scene.volume && scene.volume->sharesVoxelsWith(*m_volume);
  m_volume = isPlacedAnew ? scene.volume : nullptr;
  if (!isPlacedAnew || m_said.isEmpty() || m_context.messages.sentence() != m_said ||
      m_context.messages.isHidden())
    return;
  m_context.messages.hide();
  say();
}

// Only of a series that was opened itself, not of what names one.
void RemarksController::lookForLooks(const LoadedScene& loaded, const Request& request) {
  m_searching.cancel();
  if (loaded.scene.volume != m_context.document.scene().volume || !loaded.dicom || loaded.session ||
      request.source.toStdString() != loaded.volumePath)
    return;
  m_searching.start([this, volume = loaded.scene.volume, dicom = loaded.dicom,
                     series = loaded.read.series](const Effort& effort) -> BackgroundWork::Deliver {
    Progress progress;
    progress.isCancelled = effort.isCancelled;
    const std::vector<std::filesystem::path> found = looksBeside(*dicom, series, progress);
    return [this, volume, found] {
      if (found.empty() || m_context.document.scene().volume != volume)
        return;
      QStringList looks;
      for (const std::filesystem::path& look : found)
        looks << QString::fromStdString(look.string());
      offer(looks);
    };
  });
}

// Nobody is named: a file may be called after its patient.
void RemarksController::offer(const QStringList& looks) {
  QStringList details;
  if (!m_context.messages.isHidden()) // what was said of the series stays to be read
    details << m_context.messages.sentence();
  const QString sentence =
      looks.size() == 1
          ? tr("Beside this series lies a look that belongs to it.")
          : tr("Beside this series lie %1 looks that belong to it; this is the newest.").arg(looks.size());
  m_context.messages.show(MessageBar::Kind::question, sentence, details,
                          {tr("Show the look"), [this, look = looks.first()] { m_opening.open(look); }},
                          {tr("Not now"), {}});
}

} // namespace limn
