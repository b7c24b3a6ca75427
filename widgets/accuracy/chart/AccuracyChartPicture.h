// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/accuracy/chart/ChartLook.h"
#include "widgets/accuracy/chart/ChartValues.h"

#include <QImage>
#include <QSize>

namespace limn {

/// The chart of a report as a figure of its own, with a title that names scene, size and renderer; text and
/// marks grow with the picture. Needs a QApplication, which may have no display (platform "offscreen").
QImage accuracyChartPicture(const AccuracyReport& report, const QSize& size,
                            ChartStyle style = ChartStyle::print, ErrorMeasure measure = ErrorMeasure::p99_9);

} // namespace limn
