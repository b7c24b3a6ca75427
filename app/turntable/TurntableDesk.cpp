// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/turntable/TurntableDesk.h"

#include "app/Settings.h"
#include "app/document/DocumentText.h"
#include "app/document/OpenDocument.h"
#include "app/saving/SaveDialog.h"
#include "app/saving/SaveNotes.h"
#include "app/saving/SavingDesk.h"
#include "app/turntable/Turntable.h"
#include "app/turntable/TurntableDialog.h"
#include "app/window/picture/EngineDesk.h"
#include "io/scenefile/SceneFile.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/SideText.h"

#include <QAction>
#include <QFileInfo>
#include <QStandardPaths>

namespace limn {

TurntableDesk::TurntableDesk(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
  connect(&parts.saveTurntable, &QAction::triggered, this, &TurntableDesk::show);
}

void TurntableDesk::show() {
  if (!m_parts.document.scene().volume)
    return;
  if (!m_dialog) {
    m_dialog = new TurntableDialog(!videoProgram().empty(), &m_parts.window);
    m_dialog->follow(m_work);
    connect(m_dialog, &TurntableDialog::saveRequested, this, &TurntableDesk::save);
    connect(m_dialog, &TurntableDialog::cancelled, this, [this] {
      m_work.cancel();
      m_dialog->endProgress(tr("Cancelled; frames that were drawn stay."));
    });
    const QRectF picture = m_parts.view.logicalRect(0);
    m_dialog->setSize({static_cast<int>(picture.width()), static_cast<int>(picture.height())});
  }
  m_dialog->setPictures(pictures(), m_parts.view.ownSide());
  m_dialog->show();
  m_dialog->raise();
  m_dialog->activateWindow();
}

QStringList TurntableDesk::pictures() const {
  const std::vector<Scene> scenes = m_parts.view.scenesOfSides();
  if (scenes.size() < 2)
    return {sideTitle(scenes.front())};
  return {tr("Left: %1").arg(sideTitle(scenes[0])), tr("Right: %1").arg(sideTitle(scenes[1]))};
}

void TurntableDesk::save() {
  const QString name = suggestedName(m_parts.document) + QStringLiteral("-turntable");
  const bool isVideoWanted = m_dialog->wantsVideo();
  const QString path =
      askWhereToSave(m_dialog,
                     {isVideoWanted ? tr("Save the video") : tr("Save the frames in a new folder"),
                      isVideoWanted ? name + QStringLiteral(".mp4") : name + QStringLiteral(".frames"),
                      {isVideoWanted ? tr("Video (*.mp4)") : tr("Folder of frames (*.frames)")},
                      QStandardPaths::writableLocation(QStandardPaths::MoviesLocation)},
                     m_parts.settings);
  if (path.isEmpty())
    return;
  Turntable turntable;
  turntable.scene = m_parts.view.sceneOfSide(m_dialog->picture());
  turntable.size = m_dialog->size();
  turntable.frames = m_dialog->frames();
  turntable.framesPerSecond = m_dialog->framesPerSecond();
  turntable.scene.keep.source = m_parts.saving.labelsInPicture();
  const MakingOptions order = drawnLike(m_parts.view);
  m_dialog->showProgress(0.0);
  m_work.start([this, path, turntable, order,
                volume = m_parts.saving.volumeInPicture()](const Effort& effort) -> BackgroundWork::Deliver {
    MakingOptions told = order;
    told.effort = effort;
    writeTurntable(path.toStdString(), turntable, told,
                   [&](const Scene& scene) { return sceneToJson(scene, volume); });
    return [this, path] {
      if (m_dialog)
        m_dialog->endProgress(tr("Saved %1.").arg(QFileInfo(path).fileName()));
      m_parts.notes.attempt([] {}, path);
    };
  });
}

} // namespace limn
