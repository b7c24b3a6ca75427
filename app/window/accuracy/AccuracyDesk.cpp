// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/accuracy/AccuracyDesk.h"

#include "app/Settings.h"
#include "app/document/DocumentText.h"
#include "app/document/OpenDocument.h"
#include "app/saving/SaveDialog.h"
#include "app/saving/SaveNotes.h"
#include "app/window/MessageBar.h"
#include "io/AtomicFile.h"
#include "io/reports/AccuracyPage.h"
#include "io/reports/ReportJson.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/accuracy/chart/AccuracyChartPicture.h"
#include "widgets/accuracy/map/ErrorMapOverlay.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/SideText.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPointer>
#include <QStandardPaths>

namespace limn {
namespace {

constexpr int mostPixels = 224; ///< each way, of a picture that is measured
constexpr QSize chartSize(1200, 750);

QByteArray pngOf(const QImage& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG"))
    throw Error(Error::Kind::other, Message::tr("The chart cannot be written as PNG; is there memory left?"));
  return bytes;
}

QByteArray accuracyFile(const AccuracyReport& report, const QString& ending) {
  if (ending == QStringLiteral("csv"))
    return QByteArray::fromStdString(accuracyCsv(report));
  QByteArray chart = pngOf(accuracyChartPicture(report, chartSize, ChartStyle::print));
  if (ending != QStringLiteral("html"))
    return chart;
  // The page carries its chart, so that one file can be passed on.
  const QByteArray address = "data:image/png;base64," + chart.toBase64();
  return QByteArray::fromStdString(accuracyPage(report, address.toStdString()));
}

} // namespace

AccuracyDesk::AccuracyDesk(const Partners& partners, QObject* parent)
    : QObject(parent), m_with(partners), m_map(new ErrorMapOverlay(&partners.view)) {
  const double movingMs = m_with.settings.movingMs();
  m_with.view.setMovingMs(movingMs);
  m_with.panel.setMovingMs(movingMs);
  m_with.view.setRefinesAtRest(m_with.settings.refinesAtRest());
  connectPanel();
  connectMeasurer();
  connect(m_map, &ErrorMapOverlay::outgrown, this, &AccuracyDesk::takeMapBack);
  connect(&m_with.view, &CompareView::pictureStateChanged, this, &AccuracyDesk::showOnScreen);
}

void AccuracyDesk::connectPanel() {
  AccuracyPanel* panel = &m_with.panel;
  connect(panel, &AccuracyPanel::qualityEdited, &m_with.session, &Session::setQuality);
  connect(panel, &AccuracyPanel::toleranceWished, this, &AccuracyDesk::findSteps);
  connect(panel, &AccuracyPanel::movingMsPicked, this, [this](double ms) {
    m_with.settings.setMovingMs(ms);
    m_with.view.setMovingMs(ms);
  });
  connect(panel, &AccuracyPanel::measureRequested, this, &AccuracyDesk::measure);
  connect(panel, &AccuracyPanel::mapRequested, this, &AccuracyDesk::showMap);
  connect(panel, &AccuracyPanel::saveRequested, this, &AccuracyDesk::save);
  connect(panel, &AccuracyPanel::cancelRequested, this, [this] {
    m_measurer.cancel();
    setWork(AccuracyWork::none);
  });
}

void AccuracyDesk::connectMeasurer() {
  connect(&m_measurer, &AccuracyMeasurer::progressed, &m_with.panel, &AccuracyPanel::showProgress);
  connect(&m_measurer, &AccuracyMeasurer::measured, this, [this](const MeasuredAccuracy& measured) {
    setWork(AccuracyWork::none);
    m_measured = measured.report;
    m_with.panel.setMeasured(timedFor(measured, shownSize()));
    m_with.view.setMeasuredErrors([panel = QPointer(&m_with.panel)](const Scene& shown) {
      return panel ? levelsMeasuredOf(shown, *panel->measured()) : std::nullopt;
    });
  });
  connect(&m_measurer, &AccuracyMeasurer::stepsFound, this, &AccuracyDesk::useSteps);
  connect(&m_measurer, &AccuracyMeasurer::compared, this, &AccuracyDesk::showCompared);
  connect(&m_measurer, &AccuracyMeasurer::failed, this, [this](const QString& sentence) {
    setWork(AccuracyWork::none);
    m_with.messages.show(MessageBar::Kind::error, sentence);
  });
}

// What is measured is what the window does.
AccuracyMeasurer& AccuracyDesk::measurer() {
  m_measurer.setRays(m_with.view.engine() == ViewEngine::driver ? RaysBy::openGl : RaysBy::processor);
  return m_measurer;
}

void AccuracyDesk::measure() {
  const Scene scene = m_with.view.sceneOfSide(measuredSide());
  const QString name = tr("%1, %2").arg(suggestedName(m_with.document), sideTitle(scene));
  measurer().measure(name, scene, measuredSize());
  setWork(AccuracyWork::measuring);
}

void AccuracyDesk::findSteps(const Quality& quality, const Gesture& gesture) {
  takeMapBack();
  std::vector<Scene> scenes;
  for (int side = 0; side < pictureCount(m_with.view.compareLayout()); ++side) {
    scenes.push_back(m_with.view.sceneOfSide(side));
    scenes.back().quality = quality;
  }
  m_toleranceGesture = gesture;
  measurer().findSteps(scenes, shownSize());
  setWork(AccuracyWork::findingSteps);
}

void AccuracyDesk::useSteps(const WithinTolerance& found) {
  setWork(AccuracyWork::none);
  m_with.session.setQuality(found.scene.quality, m_toleranceGesture);
  if (!found.holds)
    m_with.messages.show(MessageBar::Kind::warning, translated(found.sentence));
}

// The map is of the picture as it stands on screen, refined or not.
void AccuracyDesk::showMap(bool shown) {
  takeMapBack();
  if (!shown)
    return;
  m_compared = m_with.view.sceneOfSide(measuredSide());
  measurer().compare(m_with.view.sceneOfRestingImage(measuredSide()), shownSize());
  setWork(AccuracyWork::comparing);
}

void AccuracyDesk::takeMapBack() {
  m_map->setVisible(false);
  m_compared = {};
  if (m_with.panel.work() == AccuracyWork::comparing) {
    m_measurer.cancel();
    setWork(AccuracyWork::none);
  }
  m_with.panel.setCompared(std::nullopt);
}

void AccuracyDesk::showCompared(const ComparedPicture& picture) {
  setWork(AccuracyWork::none);
  m_with.panel.setCompared(picture);
  if (picture.reference.converged)
    m_map->showMap(picture.map, m_with.view.logicalRect(measuredSide()));
}

void AccuracyDesk::showScene() {
  const Scene scene = m_with.view.sceneOfSide(measuredSide());
  const CompareLayout layout = m_with.view.compareLayout();
  const bool liesOver = layout == CompareLayout::wipe || layout == CompareLayout::difference;
  if (m_compared.volume && (scene != m_compared || liesOver))
    takeMapBack();
  m_measurer.forgetOthersThan(scene.volume);
  m_with.panel.setScene(scene);
  m_with.panel.setMapUnavailable(
      liesOver ? tr("Choose one picture or side by side: here two pictures lie over each other.")
               : QString());
}

void AccuracyDesk::showOnScreen(const PictureState& state) {
  const auto side = static_cast<std::size_t>(measuredSide());
  m_with.panel.setOnScreen(
      state.resting && side < state.sides.size()
          ? std::optional(qualityShown(m_with.view.sceneOfSide(measuredSide()).quality, state.sides[side]))
          : std::nullopt);
}

void AccuracyDesk::setRefinesAtRest(bool refines) {
  m_with.settings.setRefinesAtRest(refines);
  m_with.view.setRefinesAtRest(refines);
}

// While something is measured the pictures at rest do not refine: each would slow the other down.
void AccuracyDesk::setWork(AccuracyWork work) {
  m_with.panel.setWork(work);
  m_with.view.setRefinesAtRest(m_with.settings.refinesAtRest() && work == AccuracyWork::none);
}

// The right one of two, as for the effects.
int AccuracyDesk::measuredSide() const {
  return pictureCount(m_with.view.compareLayout()) - 1;
}

glm::ivec2 AccuracyDesk::shownSize() const {
  const QSizeF shown = m_with.view.logicalRect(measuredSide()).size() * m_with.view.devicePixelRatioF();
  return glm::max(glm::ivec2(qRound(shown.width()), qRound(shown.height())), glm::ivec2(1));
}

glm::ivec2 AccuracyDesk::measuredSize() const {
  const glm::dvec2 shown = shownSize();
  const double scale = std::min(1.0, mostPixels / std::max(shown.x, shown.y));
  return glm::max(glm::ivec2(glm::round(scale * shown)), glm::ivec2(1));
}

void AccuracyDesk::save() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString path =
      askWhereToSave(m_with.view.window(),
                     {tr("Save what was measured"),
                      suggestedName(m_with.document) + QStringLiteral("-accuracy.html"),
                      {tr("Page with chart and table (*.html)"), tr("Chart (*.png)"), tr("Table (*.csv)")},
                      folder},
                     m_with.settings);
  if (!path.isEmpty())
    write(path);
}

void AccuracyDesk::write(const QString& path) {
  if (!m_measured)
    return;
  const auto writeFile = [&] {
    const QByteArray bytes = accuracyFile(*m_measured, QFileInfo(path).suffix().toLower());
    writeFileAtomically(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
  };
  m_with.notes.attempt(writeFile, path);
}

} // namespace limn
