// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/LabelledRow.h"

#include "widgets/Translated.h"
#include "widgets/ValueText.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace limn {

double fractionOf(const SliderScale& scale, double value) {
  const double limited = std::clamp(value, scale.lowest, scale.highest);
  if (scale.logarithmic)
    return std::log(limited / scale.lowest) / std::log(scale.highest / scale.lowest);
  return (limited - scale.lowest) / (scale.highest - scale.lowest);
}

double valueAtFraction(const SliderScale& scale, double fraction) {
  if (fraction <= 0.0)
    return scale.lowest;
  if (fraction >= 1.0)
    return scale.highest;
  if (scale.logarithmic)
    return scale.lowest * std::pow(scale.highest / scale.lowest, fraction);
  return std::lerp(scale.lowest, scale.highest, fraction);
}

QString toolTipOf(const NumberSpec& spec, bool isRange) {
  const QString unit = spec.unit.isEmpty() ? QString() : QStringLiteral(" ") + spec.unit;
  const QString initial = isRange ? rangeText(spec.defaultValue, spec.defaultUpper, spec.decimals)
                                  : valueText(spec.defaultValue, QString(), spec.decimals);
  return QObject::tr("<p>%1</p><p>Range %2%3, default %4%3. Double click on the name to reset.</p>")
      .arg(spec.help, rangeText(spec.lowest, spec.highest, spec.decimals), unit, initial);
}

QString describedFor(const NumberSpec& spec) {
  return spec.unit.isEmpty() ? spec.help : QObject::tr("In %1. %2").arg(spec.unit, spec.help);
}

QString unitBehind(const NumberSpec& spec, double number) {
  const bool isOne = plainNumber(number, spec.decimals) == plainNumber(1.0, spec.decimals);
  return isOne && !spec.unitOfOne.isEmpty() ? spec.unitOfOne : spec.unit;
}

QString changeText(const QString& label) {
  return QObject::tr("change %1").arg(inSentence(label));
}

QString changeText(const NumberSpec& spec) {
  return changeText(spec.called.isEmpty() ? spec.label : spec.called);
}

Gesture switchGesture(const QString& label, bool isOn) {
  return {nextGestureId(), (isOn ? QObject::tr("%1: on") : QObject::tr("%1: off")).arg(inSentence(label)),
          true};
}

Gesture choiceGesture(const QString& label, const QString& before, const QString& after) {
  return {nextGestureId(), QObject::tr("%1: %2 → %3").arg(inSentence(label), before, after), true};
}

} // namespace limn
