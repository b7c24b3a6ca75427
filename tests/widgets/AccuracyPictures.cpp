// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/AccuracySamples.h"
#include "widgets/accuracy/AccuracyChartPicture.h"

#include <QApplication>
#include <QDir>

// Writes the chart of made-up reports in its three styles to PNG files in a folder, to be looked at.
int main(int argc, char** argv) {
  using namespace limn;
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  const QDir folder(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("."));
  const AccuracyReport report = sampleReport(usualPoints());
  const auto save = [&](const char* name, const AccuracyReport& shown, const QSize& size, ChartStyle style,
                        ErrorMeasure measure = ErrorMeasure::p99_9) {
    accuracyChartPicture(shown, size, style, measure).save(folder.filePath(QString::fromLatin1(name)));
  };
  save("chart-print.png", report, {1200, 750}, ChartStyle::print);
  save("chart-dark.png", report, {1200, 750}, ChartStyle::dark);
  save("chart-light.png", report, {1200, 750}, ChartStyle::light, ErrorMeasure::mean);
  save("chart-small.png", sampleReport(fewPoints()), {420, 360}, ChartStyle::dark);
  AccuracyReport open = report;
  open.reference.converged = false;
  save("chart-open.png", open, {800, 500}, ChartStyle::print);
}
