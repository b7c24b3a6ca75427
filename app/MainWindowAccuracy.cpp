// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/MessageBar.h"
#include "app/SaveDialog.h"
#include "app/accuracy/AccuracyText.h"
#include "io/AtomicFile.h"
#include "scene/Error.h"
#include "widgets/accuracy/AccuracyChartPicture.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/accuracy/ErrorMapOverlay.h"
#include "widgets/view/overlay/SideText.h"

#include <QBuffer>
#include <QDockWidget>
#include <QFileInfo>
#include <QStandardPaths>

// How close the picture is to the exact one, and what that costs.

namespace limn {
namespace {

constexpr int mostPixels = 320; ///< each way, of a picture that is measured
constexpr QSize chartSize(1200, 750);

QByteArray pngOf(const QImage& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG"))
    throw Error(Error::Kind::other, "The chart cannot be written as PNG; is there memory left?");
  return bytes;
}

QByteArray accuracyFile(const AccuracyReport& report, const QString& ending) {
  if (ending == QStringLiteral("csv"))
    return QByteArray::fromStdString(accuracyCsv(report));
  const QByteArray chart = pngOf(accuracyChartPicture(report, chartSize, ChartStyle::print));
  if (ending != QStringLiteral("html"))
    return chart;
  // The page carries its chart, so that one file can be passed on.
  const QByteArray address = "data:image/png;base64," + chart.toBase64();
  return QByteArray::fromStdString(accuracyPage(report, address.toStdString()));
}

} // namespace

void MainWindow::makeAccuracyDock() {
  m_accuracy = new AccuracyPanel(this);
  m_accuracyDock =
      addDock(tr("Accuracy"), QStringLiteral("accuracyDock"), m_accuracy, Qt::RightDockWidgetArea);
  tabifyDockWidget(m_effectsDock, m_accuracyDock);
  m_shadingDock->raise();
  m_errorMap = new ErrorMapOverlay(m_view);
  const double movingMs = m_settings.movingMs();
  m_view->setMovingMs(movingMs);
  m_accuracy->setMovingMs(movingMs);
}

void MainWindow::connectAccuracy() {
  connect(m_accuracy, &AccuracyPanel::qualityEdited, &m_session, &Session::setQuality);
  connect(m_accuracy, &AccuracyPanel::toleranceWished, this, &MainWindow::findSteps);
  connect(m_accuracy, &AccuracyPanel::movingMsPicked, this, [this](double ms) {
    m_settings.setMovingMs(ms);
    m_view->setMovingMs(ms);
  });
  connect(m_accuracy, &AccuracyPanel::measureRequested, this, &MainWindow::measureAccuracy);
  connect(m_accuracy, &AccuracyPanel::mapRequested, this, &MainWindow::showErrorMap);
  connect(m_accuracy, &AccuracyPanel::saveRequested, this, &MainWindow::saveAccuracy);
  connect(m_accuracy, &AccuracyPanel::cancelRequested, this, [this] {
    m_accuracyMeasurer.cancel();
    setAccuracyWork(AccuracyWork::none);
  });
  connect(m_errorMap, &ErrorMapOverlay::outgrown, this, &MainWindow::takeErrorMapBack);
}

void MainWindow::connectMeasurer() {
  connect(&m_accuracyMeasurer, &AccuracyMeasurer::progressed, m_accuracy, &AccuracyPanel::showProgress);
  connect(&m_accuracyMeasurer, &AccuracyMeasurer::measured, this, [this](const MeasuredAccuracy& measured) {
    setAccuracyWork(AccuracyWork::none);
    m_accuracy->setMeasured(measured);
  });
  connect(&m_accuracyMeasurer, &AccuracyMeasurer::stepsFound, this, &MainWindow::useSteps);
  connect(&m_accuracyMeasurer, &AccuracyMeasurer::compared, this, &MainWindow::showCompared);
  connect(&m_accuracyMeasurer, &AccuracyMeasurer::failed, this, [this](const QString& sentence) {
    setAccuracyWork(AccuracyWork::none);
    showError(sentence);
  });
}

void MainWindow::measureAccuracy() {
  const Scene scene = m_view->sceneOfSide(sideMeasured());
  const QString name = tr("%1, %2").arg(suggestedName(), sideTitle(scene));
  m_accuracyMeasurer.measure(name, scene, measuredSize());
  setAccuracyWork(AccuracyWork::measuring);
}

void MainWindow::findSteps(const Quality& quality, const Gesture& gesture) {
  takeErrorMapBack();
  std::vector<Scene> scenes;
  for (int side = 0; side < pictureCount(m_view->compareLayout()); ++side) {
    scenes.push_back(m_view->sceneOfSide(side));
    scenes.back().quality = quality;
  }
  m_toleranceGesture = gesture;
  m_accuracyMeasurer.findSteps(scenes, shownSize());
  setAccuracyWork(AccuracyWork::findingSteps);
}

void MainWindow::useSteps(const WithinTolerance& found) {
  setAccuracyWork(AccuracyWork::none);
  m_session.setQuality(found.scene.quality, m_toleranceGesture);
  if (!found.holds)
    m_messages->show(MessageBar::Kind::warning, QString::fromStdString(found.sentence));
}

// The map is of the picture as it stands on screen, refined or not.
void MainWindow::showErrorMap(bool shown) {
  takeErrorMapBack();
  if (!shown)
    return;
  m_comparedScene = m_view->sceneOfSide(sideMeasured());
  m_accuracyMeasurer.compare(m_view->sceneOfRestingImage(sideMeasured()), measuredSize());
  setAccuracyWork(AccuracyWork::comparing);
}

void MainWindow::takeErrorMapBack() {
  m_errorMap->setVisible(false);
  m_comparedScene = {};
  if (m_accuracy->work() == AccuracyWork::comparing) {
    m_accuracyMeasurer.cancel();
    setAccuracyWork(AccuracyWork::none);
  }
  m_accuracy->setCompared(std::nullopt);
}

void MainWindow::showCompared(const ComparedPicture& picture) {
  setAccuracyWork(AccuracyWork::none);
  m_accuracy->setCompared(picture);
  if (picture.reference.converged)
    m_errorMap->showMap(picture.map, m_view->logicalRect(sideMeasured()));
}

void MainWindow::showAccuracyScene() {
  const Scene scene = m_view->sceneOfSide(sideMeasured());
  const CompareLayout layout = m_view->compareLayout();
  const bool liesOver = layout == CompareLayout::wipe || layout == CompareLayout::difference;
  if (m_comparedScene.volume && (scene != m_comparedScene || liesOver))
    takeErrorMapBack();
  m_accuracyMeasurer.forgetOthersThan(scene.volume);
  m_accuracy->setScene(scene);
  m_accuracy->setMapUnavailable(
      liesOver ? tr("Choose one picture or side by side: here two pictures lie over each other.")
               : QString());
}

// While something is measured the pictures at rest do not refine: each would slow the other down.
void MainWindow::setAccuracyWork(AccuracyWork work) {
  m_accuracy->setWork(work);
  m_view->setRefinesAtRest(m_settings.refinesAtRest() && work == AccuracyWork::none);
}

// The right one of two, as for the effects.
int MainWindow::sideMeasured() const {
  return pictureCount(m_view->compareLayout()) - 1;
}

glm::ivec2 MainWindow::shownSize() const {
  const QSizeF shown = m_view->logicalRect(sideMeasured()).size() * m_view->devicePixelRatioF();
  return glm::max(glm::ivec2(qRound(shown.width()), qRound(shown.height())), glm::ivec2(1));
}

glm::ivec2 MainWindow::measuredSize() const {
  const glm::dvec2 shown = shownSize();
  const double scale = std::min(1.0, mostPixels / std::max(shown.x, shown.y));
  return glm::max(glm::ivec2(glm::round(scale * shown)), glm::ivec2(1));
}

void MainWindow::saveAccuracy() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString path = askWhereToSave(
      this, {tr("Save what was measured"),
             folder + QLatin1Char('/') + suggestedName() + QStringLiteral("-accuracy.html"),
             {tr("Page with chart and table (*.html)"), tr("Chart (*.png)"), tr("Table (*.csv)")}});
  if (!path.isEmpty())
    writeAccuracy(path);
}

void MainWindow::writeAccuracy(const QString& path) {
  if (!m_accuracy->measured())
    return;
  try {
    const QByteArray bytes = accuracyFile(m_accuracy->measured()->report, QFileInfo(path).suffix().toLower());
    writeFileAtomically(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    noteSaved(path);
  } catch (const Error& error) {
    showSaveError(QString::fromStdString(error.what()));
  }
}

} // namespace limn
