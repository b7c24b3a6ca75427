// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/AccuracyChartPicture.h"

#include "widgets/accuracy/chart/AccuracyChart.h"

#include <QGraphicsScene>
#include <QPainter>

#include <algorithm>

namespace limn {
namespace {

QString titleOf(const AccuracyReport& report) {
  return AccuracyChart::tr("%1 · %2 × %3 pixels · %4")
      .arg(QString::fromStdString(report.scene))
      .arg(report.size.x)
      .arg(report.size.y)
      .arg(QString::fromStdString(report.renderer));
}

} // namespace

QImage accuracyChartPicture(const AccuracyReport& report, const QSize& size, ChartStyle style,
                            ErrorMeasure measure) {
  QGraphicsScene scene;
  auto* chart = new AccuracyChart;
  scene.addItem(chart);
  const double text = std::clamp(std::min(size.width() / 70.0, size.height() / 42.0), 9.0, 60.0);
  chart->setStyle(style);
  chart->setMeasure(measure);
  chart->setTextSize(text);
  chart->setMostTicks(static_cast<int>(size.width() / (5.0 * text)),
                      static_cast<int>(size.height() / (3.0 * text)));
  chart->setLegendAtRight(3 * size.width() >= 4 * size.height());
  chart->setReport(report);
  chart->setTitle(titleOf(report));
  chart->resize(size);
  scene.setSceneRect(QRectF(QPointF(0.0, 0.0), QSizeF(size)));
  QImage picture(size, QImage::Format_RGB32);
  picture.fill(chartColors(style).background);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  scene.render(&painter);
  return picture;
}

} // namespace limn
