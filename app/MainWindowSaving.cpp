// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/MessageBar.h"
#include "app/SaveDialog.h"
#include "app/renderers/PictureMaker.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/Error.h"

#include <QFileInfo>
#include <QLabel>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolButton>

// Scenes and pictures as files, and what is said of any file that was saved or could not be.

namespace limn {

void MainWindow::noteSaved(const QString& path) {
  statusBar()->showMessage(tr("Saved %1").arg(QFileInfo(path).fileName()), 4000);
  noteSaved();
}

void MainWindow::noteSaved() {
  if (!m_saveError.isEmpty() && m_messages->sentence() == m_saveError)
    m_messages->hide();
  m_saveError.clear();
}

void MainWindow::showSaveError(const QString& sentence) {
  m_saveError = sentence;
  showError(sentence);
}

void MainWindow::saveScene() {
  const QString path = askWhereToSave(
      this, {tr("Save the scene"), suggestedName() + QStringLiteral(".json"), {tr("Limn scene (*.json)")}});
  if (!path.isEmpty())
    writeScene(path);
}

void MainWindow::writeScene(const QString& path) {
  const std::filesystem::path target(path.toStdString());
  try {
    writeFileAtomically(target, sceneToJson(m_session.scene(), volumeSeenFrom(target)));
    noteSaved(path);
  } catch (const Error& error) {
    showSaveError(QString::fromStdString(error.what()));
  }
}

void MainWindow::savePicture() {
  const AwaitedPicture asked{{}, m_view->scenesOfSides(), m_view->compareLayout()};
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString path =
      askWhereToSave(this, {tr("Save the picture"),
                            folder + QLatin1Char('/') + suggestedName() + QStringLiteral(".png"),
                            {tr("Pictures (*.png *.tif *.jpg *.exr)")}});
  if (path.isEmpty())
    return;
  m_awaitedPicture = asked;
  m_awaitedPicture->path = path;
  writeAwaitedPicture();
}

// Called again whenever the picture is further than before.
void MainWindow::writeAwaitedPicture() {
  if (!m_awaitedPicture)
    return;
  const AwaitedPicture awaited = *m_awaitedPicture;
  if (m_view->scenesOfSides() != awaited.scenes || m_view->compareLayout() != awaited.layout) {
    forgetAwaitedPicture();
    showSaveError(tr("The picture changed before it was complete, so it is not saved; save it again."));
  } else if (m_view->restingImage(0)) {
    forgetAwaitedPicture();
    writePicture(awaited.path);
  } else {
    m_waiting->setText(tr("Saving %1 once the picture is complete").arg(QFileInfo(awaited.path).fileName()));
    m_waiting->show();
    m_stopWaiting->show();
  }
}

void MainWindow::forgetAwaitedPicture() {
  m_awaitedPicture.reset();
  m_waiting->hide();
  m_stopWaiting->hide();
}

void MainWindow::writePicture(const QString& path) {
  const std::optional<Image> left = m_view->restingImage(0);
  if (!left) {
    showSaveError(tr("The picture is not complete yet; save it again once it is."));
    return;
  }
  const std::optional<Image> right =
      m_view->compareLayout() == CompareLayout::sideBySide ? m_view->restingImage(1) : std::nullopt;
  // It may travel: it names the volume without folders.
  const std::filesystem::path source(m_session.volumePath());
  const std::string volume = volumeSeenFrom(source.parent_path() / "picture");
  try {
    writeImage(path.toStdString(), right ? sideBySide(*left, *right) : *left,
               m_session.scene().image.background, sceneToJson(m_view->sceneOfRestingImage(0), volume));
    noteSaved(path);
  } catch (const Error& error) {
    showSaveError(QString::fromStdString(error.what()));
  }
}

} // namespace limn
