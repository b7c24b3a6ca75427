// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ChangeText.h"

#include "widgets/ValueText.h"

#include <QObject>

#include <array>
#include <optional>

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

// The only number in which two ways to light differ; none where they differ in more, or in something else.
QString numberText(const Shading& before, const Shading& after) {
  constexpr std::array numbers{&Shading::ambient,  &Shading::diffuse,          &Shading::specular,
                               &Shading::exponent, &Shading::ambientIntensity, &Shading::lightIntensity};
  const auto text = [](double number) { return digitsNumber(number, 3); };
  for (double Shading::*number : numbers) {
    Shading changed = before;
    changed.*number = after.*number;
    if (changed == after)
      return arrow(text(before.*number), text(after.*number));
  }
  constexpr std::array physicalNumbers{&PhysicalLight::density, &PhysicalLight::anisotropy,
                                       &PhysicalLight::keyRadiusDeg, &PhysicalLight::exposureEv};
  for (double PhysicalLight::*number : physicalNumbers) {
    Shading changed = before;
    changed.physical.*number = after.physical.*number;
    if (changed == after)
      return arrow(text(before.physical.*number), text(after.physical.*number));
  }
  constexpr std::array ranges{&Shading::exponentRange, &Shading::opacityRange};
  for (CoefficientRange Shading::*range : ranges) {
    Shading changed = before;
    changed.*range = after.*range;
    const auto words = [&](const CoefficientRange& of) {
      return QStringLiteral("%1–%2").arg(text(of.atFlat), text(of.atBoundary));
    };
    if (changed == after)
      return arrow(words(before.*range), words(after.*range));
  }
  return {};
}

} // namespace

QString changeText(const Scene& before, const Scene& after, const QString& called) {
  if (!before.volume || before.volume != after.volume)
    return called;
  Scene other = before;
  other.camera = after.camera;
  other.transferFunction = after.transferFunction;
  if (before.transferFunction != after.transferFunction && other == after)
    if (const auto point = changedPoint(before.transferFunction, after.transferFunction))
      return pointText(*point, *before.volume, called);
  other.transferFunction = before.transferFunction;
  other.shading = after.shading;
  if (before.shading != after.shading && other == after)
    if (const QString numbers = numberText(before.shading, after.shading); !numbers.isEmpty())
      return QStringLiteral("%1 %2").arg(called, numbers);
  return called;
}

} // namespace limn
