// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/curve/SuggestionText.h"

#include "widgets/ValueText.h"
#include "widgets/curve/picture/Tissue.h"

#include <QObject>

#include <algorithm>

namespace limn {
namespace {

// CT numbers, HU.
bool isAir(double value) {
  return value < -500.0;
}

bool isSoft(double value) {
  return value > -150.0 && value < 200.0;
}

bool isBone(double value) {
  return value > 300.0;
}

// A value is told to some hundredths of the step over its boundary.
QString numberText(double value, const Boundary& boundary, const QString& unit) {
  return valueText(value, unit, decimalsFor(std::max((boundary.high - boundary.low) / 20.0, 1e-9)));
}

QString placeText(const Boundary& boundary, const ValueNames& names) {
  return QObject::tr("Surface at %1").arg(numberText(boundary.value(), boundary, names.unit));
}

} // namespace

QString boundaryName(const Boundary& boundary, const ValueNames& names) {
  if (!names.isHounsfield)
    return placeText(boundary, names);
  if (isAir(boundary.low) && isSoft(boundary.high))
    return QObject::tr("Skin and airways");
  if (isSoft(boundary.low) && isBone(boundary.high))
    return QObject::tr("Bone");
  const auto low = tissueAt(boundary.low);
  const auto high = tissueAt(boundary.high);
  if (low && high && low->name != high->name)
    return QObject::tr("From %1 to %2", "two tissues").arg(low->name, high->name);
  if (low && high)
    return QObject::tr("Within %1", "a tissue").arg(low->name);
  return placeText(boundary, names);
}

QString boundaryExplained(const Boundary& boundary, const ValueNames& names) {
  const double percent = 100.0 * boundary.share;
  return QObject::tr("%1, between %2 and %3; %4 % of all boundaries")
      .arg(placeText(boundary, names), numberText(boundary.low, boundary, {}),
           numberText(boundary.high, boundary, names.unit), plainNumber(percent, percent < 9.5 ? 1 : 0));
}

} // namespace limn
