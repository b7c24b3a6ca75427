// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom/DicomDesk.h"

#include "app/Settings.h"
#include "app/dicom/DicomDialog.h"
#include "app/dicom/DicomSaving.h"
#include "app/dicom/LooksBeside.h"
#include "app/document/DocumentText.h"
#include "app/document/Session.h"
#include "app/engines/PictureMaker.h"
#include "app/saving/SaveDialog.h"
#include "app/saving/SaveNotes.h"
#include "app/window/MessageBar.h"
#include "app/window/picture/EngineDesk.h"
#include "io/looks/dicom/Losses.h"
#include "widgets/Translated.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/SideText.h"

#include <QAction>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Of a picture for an archive, pixels.
constexpr double leastSide = 1024.0;

bool isSeries(const Scene& scene) {
  return scene.volume && scene.volume->info().format == "DICOM";
}

} // namespace

DicomDesk::DicomDesk(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
  parts.saveDicom.setEnabled(false);
  connect(&parts.saveDicom, &QAction::triggered, this, &DicomDesk::show);
  connect(&parts.session, &Session::sceneChanged, this, [this](const Scene& scene) {
    m_parts.saveDicom.setEnabled(isSeries(scene));
    if (m_dialog && !isSeries(scene))
      m_dialog->close();
  });
  // Queued: the view has the scene by then.
  connect(&parts.session, &Session::sceneChanged, this, &DicomDesk::showLosses, Qt::QueuedConnection);
  // Queued: what was loaded is shown first, or left.
  connect(&parts.opening, &OpeningDesk::loaded, this,
          [this](const LoadedScene& loaded, const Histogram&, const Request& request) {
            QMetaObject::invokeMethod(
                this, [this, loaded, request] { lookForLooks(loaded, request); }, Qt::QueuedConnection);
          });
}

// What is on the left, in the shape that it is seen in, and large enough to be read in an archive.
Scene DicomDesk::sceneToSave() const {
  Scene scene = m_parts.view.sceneOfSide(0);
  const QRectF picture = m_parts.view.logicalRect(0);
  const double density = m_parts.window.devicePixelRatioF();
  const double shorter = std::max(1.0, std::min(picture.width(), picture.height()) * density);
  const double scale = density * std::max(1.0, leastSide / shorter);
  scene.image.width = std::max(1, static_cast<int>(std::lround(picture.width() * scale)));
  scene.image.height = std::max(1, static_cast<int>(std::lround(picture.height() * scale)));
  return scene;
}

void DicomDesk::show() {
  if (!isSeries(m_parts.document.scene()))
    return;
  if (!m_dialog) {
    m_dialog = new DicomDialog(&m_parts.window);
    m_dialog->follow(m_saving);
    connect(m_dialog, &DicomDialog::saveRequested, this, &DicomDesk::save);
    connect(m_dialog, &DicomDialog::cancelled, this, [this] {
      m_saving.cancel();
      m_dialog->endProgress(tr("Cancelled; nothing was written."));
    });
  }
  m_dialog->show();
  m_dialog->raise();
  m_dialog->activateWindow();
  showLosses();
}

void DicomDesk::showLosses() {
  if (!m_dialog || !m_dialog->isVisible() || !isSeries(m_parts.document.scene()))
    return;
  const Scene scene = sceneToSave();
  m_dialog->setPicture(tr("The picture: %1, %2 × %3 pixels, without marks on it.")
                           .arg(sideTitle(scene))
                           .arg(scene.image.width)
                           .arg(scene.image.height));
  QStringList losses;
  for (const Message& loss : lossesOf(scene))
    losses << translated(loss);
  m_dialog->setLosses(losses);
}

void DicomDesk::save() {
  const QString path = askWhereToSave(m_dialog,
                                      {tr("Save picture and look in a new folder"),
                                       suggestedName(m_parts.document) + QStringLiteral(".dicom"),
                                       {tr("Folder with picture.dcm and look.dcm (*.dicom)")},
                                       QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)},
                                      m_parts.settings);
  if (path.isEmpty())
    return;
  const MakingOptions order = drawnLike(m_parts.view);
  m_dialog->showProgress(0.0);
  m_saving.start([this, path, scene = sceneToSave(), order, isAnonymous = m_dialog->isAnonymous(),
                  source = m_parts.document.volumePath(),
                  series = m_parts.document.request().options.read.series](
                     const Effort& effort) -> BackgroundWork::Deliver {
    Progress reading;
    reading.isCancelled = effort.isCancelled;
    const SeriesImages images = shownSeries(*scene.volume, source, series, reading);
    MakingOptions told = order;
    told.effort = effort;
    makeEach({scene}, {scene.image.width, scene.image.height}, told,
             [&](std::size_t, const MadePicture& picture) {
               saveToDicom(path.toStdString(), scene, picture.image, images, isAnonymous);
             });
    return [this, path] {
      if (m_dialog)
        m_dialog->endProgress(tr("Saved %1.").arg(QFileInfo(path).fileName()));
      m_parts.notes.attempt([] {}, path);
    };
  });
}

// Only of a series that was opened itself, not of what names one.
void DicomDesk::lookForLooks(const LoadedScene& loaded, const Request& request) {
  m_searching.cancel();
  if (loaded.scene.volume != m_parts.document.scene().volume || !isSeries(loaded.scene) || loaded.session ||
      request.source.toStdString() != loaded.volumePath)
    return;
  m_searching.start([this, volume = loaded.scene.volume, path = loaded.volumePath,
                     series = loaded.read.series](const Effort& effort) -> BackgroundWork::Deliver {
    Progress progress;
    progress.isCancelled = effort.isCancelled;
    const std::vector<std::filesystem::path> found = looksBeside(path, series, progress);
    return [this, volume, found] {
      if (found.empty() || m_parts.document.scene().volume != volume)
        return;
      QStringList looks;
      for (const std::filesystem::path& look : found)
        looks << QString::fromStdString(look.string());
      offer(looks);
    };
  });
}

// Nobody is named: a file may be called after its patient.
void DicomDesk::offer(const QStringList& looks) {
  QStringList details;
  if (!m_parts.messages.isHidden()) // what was said of the series stays to be read
    details << m_parts.messages.sentence();
  const QString sentence =
      looks.size() == 1
          ? tr("Beside this series lies a look that belongs to it.")
          : tr("Beside this series lie %1 looks that belong to it; this is the newest.").arg(looks.size());
  m_parts.messages.show(MessageBar::Kind::question, sentence, details,
                        {tr("Show the look"), [this, look = looks.first()] { m_parts.opening.open(look); }},
                        {tr("Not now"), {}});
}

} // namespace limn
