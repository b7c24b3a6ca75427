// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/PointUse.h"

#include "accuracy/Tolerance.h"
#include "scene/ProjectionFacts.h"
#include "scene/effects/EffectPlan.h"
#include "widgets/ValueText.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// The tolerance at the dial's exact end, levels.
constexpr double exactToleranceLevels = 0.5;

const std::vector<double> dialSteps{2.0, 1.0, 0.5, 0.25, 0.125};

bool isPreintegrated(const Scene& scene, double steepestPerMm) {
  if (!scene.volume)
    return false;
  SceneFacts facts;
  facts.steepestPerMm = steepestPerMm;
  return requiredEffects(scene, facts).effects.has(Effect::preintegration);
}

Scene withStep(Scene scene, double stepVoxels) {
  Quality& quality = scene.quality;
  // A tolerance lets rays run further; equal steps go back to where they commonly end.
  if (quality.toleranceLevels)
    quality.earlyTermination = Quality{}.earlyTermination;
  quality.toleranceLevels.reset();
  quality.fineness.reset();
  quality.stepVoxels = stepVoxels;
  quality.jitter = false;
  return scene;
}

OperatingPoint exactPoint() {
  OperatingPoint point;
  point.toleranceLevels = exactToleranceLevels;
  return point;
}

void addOnce(std::vector<OperatingPoint>& points, const OperatingPoint& point) {
  if (std::find(points.begin(), points.end(), point) == points.end())
    points.push_back(point);
}

// A scene without the view of it.
Scene contentOf(Scene scene) {
  scene.camera = {};
  scene.image = {};
  scene.quality = {};
  return scene;
}

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

// A time: one decimal below 10 ms.
QString msText(double ms) {
  return QObject::tr("%1 ms").arg(plainNumber(ms, ms < 10.0 ? 1 : 0));
}

} // namespace

MeasuredAccuracy timedFor(MeasuredAccuracy measured, const glm::ivec2& size) {
  const glm::ivec2& drawn = measured.report.size;
  const double factor = double(size.x) * size.y / std::max(1.0, double(drawn.x) * drawn.y);
  for (MeasuredPoint& point : measured.report.points)
    for (double* ms : {&point.ms.median, &point.ms.least, &point.ms.most})
      *ms *= factor;
  measured.timedSize = size;
  return measured;
}

std::optional<OperatingPoint> pointOf(const Scene& scene, double steepestPerMm) {
  OperatingPoint point;
  if (isPhysical(scene)) {
    point.paths = scene.quality.paths.value_or(pathsOf(scene.shading.physical.until));
    point.stepVoxels = scene.quality.stepVoxels;
    return point;
  }
  if (scene.quality.jitter)
    return std::nullopt;
  // Under a tolerance neither the step nor pre-integration matters, and where rays end comes with it.
  point.toleranceLevels = scene.quality.toleranceLevels;
  if (point.toleranceLevels)
    return point;
  point.stepVoxels = scene.quality.stepVoxels;
  point.preintegrated = isPreintegrated(scene, steepestPerMm);
  point.earlyTermination = scene.quality.earlyTermination;
  return point;
}

std::vector<OperatingPoint> dialPoints(const Scene& scene, double steepestPerMm) {
  std::vector<OperatingPoint> points;
  if (isPhysical(scene))
    return points;
  points.reserve(dialSteps.size() + 1);
  for (const double step : dialSteps)
    points.push_back(*pointOf(withStep(scene, step), steepestPerMm));
  if (integrates(scene.projection))
    points.push_back(exactPoint());
  return points;
}

std::vector<OperatingPoint> pointsToMeasure(const Scene& scene, double steepestPerMm) {
  std::vector<OperatingPoint> points;
  const double earlyTermination = withStep(scene, 1.0).quality.earlyTermination;
  const bool hasTolerances = integrates(scene.projection);
  for (OperatingPoint point : fewPoints()) {
    // Where a tolerance gets closer in less time, finer steps than the dial's are not worth waiting for.
    const bool isFinerThanDial = !point.toleranceLevels && point.stepVoxels < dialSteps.back();
    if (hasTolerances ? isFinerThanDial : point.toleranceLevels.has_value())
      continue;
    if (!point.toleranceLevels)
      point.earlyTermination = earlyTermination;
    points.push_back(point);
  }
  for (const OperatingPoint& point : dialPoints(scene, steepestPerMm))
    addOnce(points, point);
  // Averaging the curve matters only to pictures that gather along the ray.
  Scene averaged = scene;
  averaged.quality.preintegrated = Preintegration::always;
  for (const OperatingPoint& point : dialPoints(averaged, steepestPerMm))
    addOnce(points, point);
  return points;
}

bool isOfTheWindow(const OperatingPoint& point) {
  return point.rival.empty() && !point.paths && point.engine == Engine::rayCaster &&
         point.gradients == GradientSource::onTheFly && point.imageScale == 1.0;
}

Quality qualityAt(const OperatingPoint& point, const Scene& scene, double steepestPerMm) {
  if (point.toleranceLevels) {
    Quality quality = scene.quality;
    quality.jitter = false;
    quality.toleranceLevels = point.toleranceLevels;
    quality.fineness.reset();
    return quality;
  }
  Scene drawn = withStep(scene, point.stepVoxels);
  drawn.quality.earlyTermination = point.earlyTermination;
  if (pointOf(drawn, steepestPerMm) != point)
    drawn.quality.preintegrated = point.preintegrated ? Preintegration::always : Preintegration::never;
  return drawn.quality;
}

bool holdsFor(const Scene& measured, const Scene& shown) {
  return contentOf(measured) == contentOf(shown);
}

std::optional<double> levelsMeasuredOf(const Scene& shown, const MeasuredAccuracy& measured) {
  const ReferenceFacts& reference = measured.report.reference;
  if (!reference.converged || reference.isByChance || !holdsFor(measured.scene, shown) ||
      measured.scene.camera != shown.camera)
    return std::nullopt;
  const std::optional<OperatingPoint> point = pointOf(shown, measured.steepestPerMm);
  const std::optional<std::size_t> index = point ? indexOf(*point, measured.report.points) : std::nullopt;
  if (!index)
    return std::nullopt;
  return std::max(measured.report.points[*index].error.p99_9, leastP99_9(reference));
}

std::optional<std::size_t> indexOf(const OperatingPoint& point, const std::vector<MeasuredPoint>& points) {
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const MeasuredPoint& measured) { return measured.point == point; });
  if (found == points.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - points.begin());
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
  if (point.paths)
    return *point.paths == 1 ? QObject::tr("1 path a pixel")
                             : QObject::tr("%1 paths a pixel").arg(*point.paths);
  QString text = point.toleranceLevels ? toleranceText(*point.toleranceLevels) : stepText(point.stepVoxels);
  if (point.preintegrated)
    text += QObject::tr(", curve averaged");
  return text;
}

QString familyText(const OperatingPoint& point) {
  if (point.paths)
    return QObject::tr("random paths");
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
  if (!point.point.toleranceLevels && !point.point.paths)
    rows +=
        row(QObject::tr("Step"), (point.point.stepVoxels == 1.0 ? QObject::tr("%1 voxel = %2 mm")
                                                                : QObject::tr("%1 voxels = %2 mm"))
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
