// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/points/PointText.h"

#include "widgets/ValueText.h"
#include "widgets/accuracy/points/PointUse.h"

#include <QObject>

#include <cmath>

namespace limn {
namespace {

QString capitalised(const QString& text) {
  return text.left(1).toUpper() + text.mid(1);
}

QString row(const QString& name, const QString& value) {
  return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td align='right'>%2</td></tr>").arg(name, value);
}

QString stepText(double stepVoxels) {
  const double parts = 1.0 / stepVoxels;
  if (parts > 1.0 && parts == std::floor(parts))
    return QObject::tr("step 1/%1 voxel").arg(plainNumber(parts, 0));
  return stepVoxels == 1.0 ? QObject::tr("step 1 voxel")
                           : QObject::tr("step %1 voxels").arg(plainNumber(stepVoxels, 3));
}

QString toleranceText(double levels) {
  return levels == 0.5 ? QObject::tr("exact to half a level")
                       : QObject::tr("exact to %1 levels").arg(plainNumber(levels, 2));
}

QString errorRow(const ReferenceFacts& reference, const QString& name, double levels, double least) {
  const QString text = !reference.converged ? QObject::tr("unknown")
                       : levels < least     ? QObject::tr("< %1 levels").arg(promisedLevels(least))
                                            : QObject::tr("%1 levels").arg(plainNumber(levels, 3));
  return row(name, text.toHtmlEscaped());
}

} // namespace

QString msText(double ms) {
  return QObject::tr("%1 ms").arg(plainNumber(ms, ms < 10.0 ? 1 : 0));
}

QString pointErrorText(const MeasuredPoint& point, const ReferenceFacts& reference) {
  if (!reference.converged)
    return QObject::tr("unknown");
  const double least = leastP99_9(reference);
  if (point.error.p99_9 < least)
    return QObject::tr("less than %1 levels").arg(promisedLevels(least));
  const QString levels = promisedLevels(point.error.p99_9);
  return levels == QStringLiteral("1") ? QObject::tr("1 level") : QObject::tr("%1 levels").arg(levels);
}

QString pointText(const OperatingPoint& point) {
  QString text = point.toleranceLevels ? toleranceText(*point.toleranceLevels) : stepText(point.stepVoxels);
  if (point.preintegrated)
    text += QObject::tr(", curve averaged");
  return text;
}

QString familyText(const OperatingPoint& point) {
  if (!isOfTheWindow(point))
    return QString::fromStdString(familyOf(point));
  const QString steps = point.toleranceLevels ? QObject::tr("steps by error") : QObject::tr("equal steps");
  return point.preintegrated ? QObject::tr("%1, curve averaged").arg(steps) : steps;
}

QString pointSentence(const MeasuredPoint& point, const ReferenceFacts& reference) {
  const QString name = capitalised(pointText(point.point));
  const QString time = msText(point.ms.median);
  if (!reference.converged)
    return QObject::tr("%1: not converged, so the error is unknown; %2.").arg(name, time);
  return QObject::tr("%1: within %2, %3.").arg(name, pointErrorText(point, reference), time);
}

QString pointToolTip(const MeasuredPoint& point, const AccuracyReport& report) {
  const ReferenceFacts& reference = report.reference;
  const double least = leastP99_9(reference);
  QString rows;
  if (!point.point.toleranceLevels)
    rows +=
        row(QObject::tr("Step"), QObject::tr("%1 voxels = %2 mm")
                                     .arg(plainNumber(point.point.stepVoxels, 4),
                                          plainNumber(point.point.stepVoxels * report.smallestSpacingMm, 3)));
  rows += errorRow(reference, QObject::tr("Largest error"), point.error.largest, least);
  rows += errorRow(reference, QObject::tr("99.9th percentile"), point.error.p99_9, least);
  rows += errorRow(reference, QObject::tr("Mean error"), point.error.mean, leastMean(reference));
  rows += row(QObject::tr("Off by over 1 level"),
              reference.converged
                  ? QObject::tr("%1 % of pixels").arg(plainNumber(100.0 * point.error.shareOverOne, 2))
                  : QObject::tr("unknown"));
  rows += row(QObject::tr("Time"), QObject::tr("%1 (%2 – %3)")
                                       .arg(msText(point.ms.median), plainNumber(point.ms.least, 1),
                                            plainNumber(point.ms.most, 1)));
  return QStringLiteral("<b>%1</b><br>%2<table>%3</table>")
      .arg(capitalised(pointText(point.point)).toHtmlEscaped(), familyText(point.point).toHtmlEscaped(),
           rows);
}

} // namespace limn
