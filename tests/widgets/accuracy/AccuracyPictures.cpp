// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Phantom.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/accuracy/AccuracySamples.h"
#include "widgets/accuracy/ChartPicture.h"
#include "widgets/accuracy/ErrorMapOverlay.h"
#include "widgets/theme/LookStyle.h"

#include <QApplication>
#include <QDir>

// Writes the chart of made-up reports in its three styles, the panel in both looks and the legend of the map
// to PNG files in a folder, to be looked at: limn_accuracy_pictures FOLDER
using namespace limn;

namespace {

void saveCharts(const QDir& folder) {
  const AccuracyReport report = sampleReport(usualPoints());
  const auto save = [&](const char* name, const AccuracyReport& shown, const QSize& size, ChartStyle style,
                        ErrorMeasure measure = ErrorMeasure::p99_9) {
    accuracyChartPicture(shown, size, style, measure).save(folder.filePath(QString::fromLatin1(name)));
  };
  save("chart-print.png", report, {1200, 750}, ChartStyle::print);
  save("chart-dark.png", report, {1200, 750}, ChartStyle::dark);
  save("chart-light.png", report, {1200, 750}, ChartStyle::light, ErrorMeasure::mean);
  save("chart-small.png", sampleReport(fewPoints()), {420, 360}, ChartStyle::dark);
  save("chart-paths.png", samplePathReport(), {1200, 750}, ChartStyle::print);
  save("chart-paths-small.png", samplePathReport(), {420, 360}, ChartStyle::dark);
  AccuracyReport open = report;
  open.reference.converged = false;
  save("chart-open.png", open, {800, 500}, ChartStyle::print);
}

void save(QWidget& widget, const QSize& size, const QString& path) {
  widget.resize(size);
  widget.show();
  for (int round = 0; round < 5; ++round) // layouts within layouts
    QApplication::processEvents();
  widget.grab().save(path);
}

void savePanel(const QString& prefix) {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 8.0});
  scene.transferFunction.points.resize(2);
  scene.transferFunction.points[0].value = -1000.0;
  scene.transferFunction.points[1].value = 500.0;
  scene.transferFunction.points[1].opacity = 0.8;
  AccuracyPanel panel;
  save(panel, {300, 900}, prefix + QStringLiteral("empty.png"));
  panel.setScene(scene);
  panel.setWork(AccuracyWork::measuring);
  panel.showProgress(0.4, QStringLiteral("Measuring rays, pre-integrated, step 1/4"));
  save(panel, {300, 900}, prefix + QStringLiteral("measuring.png"));
  panel.setWork(AccuracyWork::none);
  panel.setMeasured({sampleReport(pointsToMeasure(scene, 0.0)), scene, 0.0, {}});
  save(panel, {300, 1200}, prefix + QStringLiteral("measured.png"));
  save(panel, {420, 1200}, prefix + QStringLiteral("measured-wide.png"));
  scene.isovalue = 1.0;
  panel.setScene(scene);
  save(panel, {300, 1200}, prefix + QStringLiteral("stale.png"));
}

void saveLegend(const QDir& folder) {
  QWidget view;
  view.resize(640, 400);
  ErrorMapOverlay overlay(&view);
  ErrorMap map{{256, 160}, std::vector<float>(256 * 160)};
  for (std::size_t i = 0; i < map.levels.size(); ++i)
    map.levels[i] = i / 256 < 20 ? -1.0f : 12.0f * static_cast<float>(i % 256) / 255.0f;
  overlay.showMap(map, {0.0, 0.0, 640.0, 400.0});
  save(view, {640, 400}, folder.filePath(QStringLiteral("map.png")));
}

} // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  const QDir folder(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("."));
  saveCharts(folder);
  saveLegend(folder);
  for (const bool dark : {true, false}) {
    applyTheme(application, dark ? ThemeChoice::dark : ThemeChoice::light);
    savePanel(folder.filePath(dark ? QStringLiteral("panel-dark-") : QStringLiteral("panel-light-")));
  }
}
