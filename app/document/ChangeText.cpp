// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ChangeText.h"

#include "widgets/ValueText.h"

#include <QObject>

#include <array>
#include <numbers>
#include <optional>
#include <variant>

namespace limn {
namespace {

QString arrow(const QString& from, const QString& to) {
  return QStringLiteral("%1 → %2").arg(from, to);
}

// The points of two curves that differ in one point alone.
struct ChangedPoint {
  ControlPoint before, after;
};

std::optional<ChangedPoint> changedPoint(const TransferFunction& before, const TransferFunction& after) {
  if (before.points.size() != after.points.size() || before.unitDistanceMm != after.unitDistanceMm)
    return std::nullopt;
  std::optional<ChangedPoint> changed;
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    if (before.points[i] == after.points[i])
      continue;
    if (changed)
      return std::nullopt;
    changed = ChangedPoint{before.points[i], after.points[i]};
  }
  return changed;
}

QString pointText(const ChangedPoint& point, const Volume& volume, const QString& called) {
  const auto value = [&](double number) {
    return valueText(number, QString::fromStdString(volume.info().unit),
                     decimalsOfSpan(volume.range().highest - volume.range().lowest));
  };
  const bool hasMoved = point.before.value != point.after.value;
  const bool isOtherOpacity = point.before.opacity != point.after.opacity;
  if (point.before.color != point.after.color)
    return hasMoved || isOtherOpacity ? called
                                      : QObject::tr("change colour at %1").arg(value(point.after.value));
  const QString opacity = arrow(opacityText(point.before.opacity), opacityText(point.after.opacity));
  if (!hasMoved)
    return QObject::tr("opacity at %1 %2").arg(value(point.after.value), opacity);
  const QString place = arrow(value(point.before.value), value(point.after.value));
  return isOtherOpacity ? QObject::tr("move point %1, opacity %2").arg(place, opacity)
                        : QObject::tr("move point %1").arg(place);
}

// A number of a scene as the window shows it: where it is, null where the scene has none, and what one of the
// window's is worth.
struct ShownNumber {
  double* (*in)(Scene& scene);
  double unit = 1.0;
};

constexpr double percent = 0.01;

constexpr std::array shownNumbers{
    ShownNumber{[](Scene& scene) { return &scene.shading.ambient; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.diffuse; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.specular; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.exponent; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.ambientIntensity; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.lightIntensity; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.gradientSmoothing; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.gradientCurve.parameter; }},
    ShownNumber{[](Scene& scene) { return scene.shading.knee ? &*scene.shading.knee : nullptr; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.shadow.strength; }, percent},
    ShownNumber{[](Scene& scene) { return &scene.shading.shadow.softnessDeg; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.occlusion.strength; }, percent},
    ShownNumber{[](Scene& scene) { return &scene.shading.occlusion.reachMm; }},
    ShownNumber{[](Scene& scene) {
      auto* reference = std::get_if<PercentileReference>(&scene.shading.gradientReference);
      return reference ? &reference->percent : nullptr;
    }},
    ShownNumber{[](Scene& scene) {
      auto* reference = std::get_if<FixedReference>(&scene.shading.gradientReference);
      return reference ? &reference->valuePerMm : nullptr;
    }},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.density; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.anisotropy; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.surface; }, percent},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.specularShare; }, percent},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.keyIrradiance; }, std::numbers::pi},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.keyRadiusDeg; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.sky.above; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.sky.below; }},
    ShownNumber{[](Scene& scene) { return &scene.shading.physical.exposureEv; }},
    ShownNumber{[](Scene& scene) {
      auto* until = std::get_if<UntilLevels>(&scene.shading.physical.until);
      return until ? &until->levels : nullptr;
    }},
    ShownNumber{[](Scene& scene) {
      auto* until = std::get_if<UntilSeconds>(&scene.shading.physical.until);
      return until ? &until->seconds : nullptr;
    }},
    ShownNumber{[](Scene& scene) { return &scene.fog.densityPerMm; }},
    ShownNumber{[](Scene& scene) { return &scene.fog.startMm; }},
    ShownNumber{[](Scene& scene) { return &scene.fog.endMm; }},
    ShownNumber{[](Scene& scene) { return &scene.isovalue; }},
    ShownNumber{[](Scene& scene) { return &scene.quality.stepVoxels; }},
    ShownNumber{[](Scene& scene) { return &scene.quality.earlyTermination; }}};

// Four digits tell 0.9985 from 0.999, and 1234 HU from 1230.
QString numberText(double number) {
  return digitsNumber(number, 4);
}

// The only number in which two scenes differ; empty where they differ in more, or in something else.
QString changedNumber(Scene before, Scene after) {
  for (const ShownNumber& number : shownNumbers) {
    double* from = number.in(before);
    const double* to = number.in(after);
    if (!from || !to || *from == *to)
      continue;
    const QString text = arrow(numberText(*from / number.unit), numberText(*to / number.unit));
    *from = *to;
    return before == after ? text : QString();
  }
  return {};
}

// The same of a range.
QString changedRange(const Shading& before, const Shading& after) {
  const auto words = [](double from, double to) {
    return QStringLiteral("%1–%2").arg(numberText(from), numberText(to));
  };
  constexpr std::array ranges{&Shading::exponentRange, &Shading::opacityRange};
  for (CoefficientRange Shading::*range : ranges) {
    Shading changed = before;
    changed.*range = after.*range;
    if (changed == after)
      return arrow(words((before.*range).atFlat, (before.*range).atBoundary),
                   words((after.*range).atFlat, (after.*range).atBoundary));
  }
  Shading changed = before;
  changed.significance = after.significance;
  if (changed == after && before.significance && after.significance)
    return arrow(words(before.significance->low, before.significance->high),
                 words(after.significance->low, after.significance->high));
  return {};
}

} // namespace

QString changeText(const Scene& before, const Scene& after, const Gesture& gesture) {
  const QString& called = gesture.text;
  if (gesture.isWhole || !before.volume || before.volume != after.volume)
    return called;
  Scene other = before;
  other.camera = after.camera;
  const QString number = changedNumber(other, after);
  if (!number.isEmpty())
    return QStringLiteral("%1 %2").arg(called, withUnit(number, gesture.unit));
  other.transferFunction = after.transferFunction;
  if (before.transferFunction != after.transferFunction && other == after)
    if (const auto point = changedPoint(before.transferFunction, after.transferFunction))
      return pointText(*point, *before.volume, called);
  other.transferFunction = before.transferFunction;
  other.shading = after.shading;
  if (before.shading != after.shading && other == after)
    if (const QString range = changedRange(before.shading, after.shading); !range.isEmpty())
      return QStringLiteral("%1 %2").arg(called, withUnit(range, gesture.unit));
  return called;
}

} // namespace limn
