// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ray/ProfileText.h"

#include "widgets/ValueText.h"

#include <QObject>

#include <algorithm>

namespace limn {
namespace {

QString percentText(double share) {
  const double percent = 100.0 * share;
  const int decimals = percent > 0.0 && percent < 10.0 ? 1 : 0;
  return QObject::tr("%1 %").arg(plainNumber(percent, decimals));
}

QString valueOf(const ProfileNames& names, double value) {
  return valueText(value, names.valueUnit, names.valueDecimals);
}

// "per mm", where lengths are known.
QString perLength(const ProfileNames& names) {
  return names.depthUnit.isEmpty() ? QObject::tr("per unit of length") : QObject::tr("per mm");
}

double largestOf(const RayProfile& profile, double (*number)(const RayProfile::Sample&)) {
  double largest = 0.0;
  for (const RayProfile::Sample& sample : profile.samples)
    largest = std::max(largest, number(sample));
  return largest;
}

double opacityOf(const RayProfile::Sample& sample) {
  return sample.opacityPerMm;
}

QString emptySummary(const RayProfile& profile, const ProfileNames& names) {
  const ValueRange values = valuesOf(profile);
  return QObject::tr("Nothing shows along this ray: the picture gives no opacity to its values, %1 to %2.")
      .arg(valueOf(names, values.lowest), valueOf(names, values.highest));
}

// A depth: "34.2 mm".
QString depthText(const ProfileNames& names, double depthMm) {
  return valueText(depthMm, names.depthUnit, 1);
}

} // namespace

ValueRange valuesOf(const RayProfile& profile) {
  const auto [low, high] = std::ranges::minmax_element(profile.samples, {}, &RayProfile::Sample::value);
  return {low->value, high->value};
}

double contributionPerMm(const RayProfile::Sample& sample) {
  return sample.lengthMm > 0.0 ? sample.contribution / sample.lengthMm : sample.contribution;
}

QString profileSummary(const RayProfile& profile, const ProfileNames& names) {
  const QString alpha = QObject::tr("The pixel is %1 opaque.").arg(percentText(profile.alpha));
  if (profile.projection == Projection::average)
    return QObject::tr("An average: every depth counts alike, and none stands for the picture.");
  const std::optional<double> half = halfLightDepth(profile);
  if (!half)
    return emptySummary(profile, names);
  const QString depth = depthText(names, *half);
  const QString value = valueOf(names, sampleAt(profile, *half).value);
  switch (profile.projection) {
  case Projection::mip:
    return QObject::tr("The largest value, %1, lies %2 deep; the picture shows it alone.").arg(value, depth);
  case Projection::minip:
    return QObject::tr("The smallest value, %1, lies %2 deep; the picture shows it alone.").arg(value, depth);
  case Projection::isosurface:
    return QObject::tr("The surface lies %1 deep; the picture shows it alone.").arg(depth);
  case Projection::xray:
    return QObject::tr("Half of the absorption lies within the first %1, up to %2.").arg(depth, value) +
           u' ' + alpha;
  case Projection::composite:
  case Projection::compositeIsosurface:
  case Projection::average:
    break;
  }
  return QObject::tr("Half of the light comes from the first %1 of the volume, up to %2.").arg(depth, value) +
         u' ' + alpha;
}

QString readingAt(const RayProfile& profile, const ProfileNames& names, double depthMm) {
  const RayProfile::Sample& sample = sampleAt(profile, depthMm);
  QString what = QStringLiteral("%1: %2").arg(depthText(names, depthMm), valueOf(names, sample.value));
  const auto place = static_cast<std::size_t>(&sample - profile.samples.data());
  if (place < names.labels.size() && !names.labels[place].isEmpty())
    what += QStringLiteral(", %1").arg(names.labels[place]);
  if (!gathersLight(profile.projection) || !(profile.alpha > 0.0))
    return what;
  double gathered = 0.0;
  for (const RayProfile::Sample& each : profile.samples)
    if (each.depthMm <= depthMm)
      gathered += each.contribution;
  return QObject::tr("%1, opacity %2 %3, %4 of the light so far")
      .arg(what, opacityText(sample.opacityPerMm), perLength(names), percentText(gathered / profile.alpha));
}

std::array<LaneText, 3> laneTexts(const RayProfile& profile, const ProfileNames& names) {
  const ValueRange values = valuesOf(profile);
  const QString range =
      QObject::tr("%1 to %2").arg(valueOf(names, values.lowest), valueOf(names, values.highest));
  const auto most = [](const QString& text) { return QObject::tr("at most %1").arg(text); };
  const QString opacity = most(opacityText(largestOf(profile, opacityOf)));
  const QString share = most(percentText(largestOf(profile, contributionPerMm)));
  switch (profile.projection) {
  case Projection::mip:
  case Projection::minip:
  case Projection::average:
    return {LaneText{QObject::tr("Value"), range}, LaneText{QObject::tr("Opacity of the value"), opacity},
            LaneText{QObject::tr("What the picture takes"), {}}};
  case Projection::isosurface:
    return {LaneText{QObject::tr("Value"), range}, LaneText{QObject::tr("Surface"), {}},
            LaneText{QObject::tr("What the picture takes"), {}}};
  case Projection::composite:
  case Projection::xray:
  case Projection::compositeIsosurface:
    break;
  }
  return {LaneText{QObject::tr("Value"), range},
          LaneText{QObject::tr("Opacity %1").arg(perLength(names)), opacity},
          LaneText{QObject::tr("Share of the pixel %1").arg(perLength(names)), share}};
}

} // namespace limn
