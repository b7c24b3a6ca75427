// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ValueText.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

QLocale ungrouped() {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

QString withRealMinus(QString text) {
  return text.replace(QLatin1Char('-'), minusSign);
}

} // namespace

QString plainNumber(double number, int decimals) {
  const QLocale locale = ungrouped();
  QString text = locale.toString(number, 'f', decimals);
  const QString point = locale.decimalPoint();
  if (text.contains(point)) {
    while (text.endsWith(locale.zeroDigit()))
      text.chop(1);
    if (text.endsWith(point))
      text.chop(point.size());
  }
  return text == locale.negativeSign() + locale.zeroDigit() ? locale.zeroDigit() : withRealMinus(text);
}

QString fixedNumber(double number, int decimals) {
  return withRealMinus(ungrouped().toString(number, 'f', decimals));
}

QString digitsNumber(double number, int digits) {
  return withRealMinus(ungrouped().toString(number, 'g', digits));
}

std::optional<std::vector<double>> numbersTyped(const QString& list) {
  static const QRegularExpression space(QStringLiteral("\\s+"));
  const QString typed = list.trimmed();
  // A comma parts numbers only where nothing else does.
  const QStringList parts = typed.contains(QLatin1Char(';')) ? typed.split(QLatin1Char(';'))
                            : typed.contains(space)          ? typed.split(space)
                                                             : typed.split(QLatin1Char(','));
  std::vector<double> numbers;
  for (QString part : parts) {
    part = part.trimmed();
    if (part.endsWith(QLatin1Char(',')))
      part.chop(1);
    bool isNumber = false;
    part.replace(minusSign, QLatin1Char('-'));
    numbers.push_back(part.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber));
    if (!isNumber)
      return std::nullopt;
  }
  return numbers;
}

QString numberList(const std::vector<double>& numbers) {
  const bool hasComma = QLocale().decimalPoint() == QLatin1String(",");
  QStringList parts;
  for (const double number : numbers)
    parts << digitsNumber(number, 6);
  return parts.join(hasComma ? QStringLiteral("; ") : QStringLiteral(", "));
}

QString opacityText(double opacity) {
  if (!(opacity > 0.0))
    return plainNumber(opacity, 3);
  return plainNumber(opacity, std::clamp(2 - static_cast<int>(std::floor(std::log10(opacity))), 2, 6));
}

QString withUnit(const QString& numbers, const QString& unit) {
  return unit.isEmpty() ? numbers : numbers + QChar(0x00a0) + unit;
}

QString valueText(double value, const QString& unit, int decimals) {
  return withUnit(plainNumber(value, decimals), unit);
}

int decimalsOfSpan(double span) {
  return span > 0.0 ? std::clamp(static_cast<int>(3.0 - std::log10(span)), 0, 6) : 0;
}

int decimalsFor(double step) {
  if (!(step > 0.0) || !std::isfinite(step))
    return 0;
  // A step of 1 needs none; the small term keeps 0.1 and the like from rounding up to one more.
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
}

int decimalsOfMean(double step, double deviation, std::size_t count) {
  const double known = std::max(step, deviation) / std::sqrt(static_cast<double>(count));
  return std::min(decimalsFor(known), decimalsFor(step) + 1);
}

QString promisedLevels(double levels) {
  if (!(levels > 0.0) || std::isinf(levels))
    return levels > 0.0 ? QStringLiteral("∞") : QStringLiteral("0");
  const double unit = std::pow(10.0, std::floor(std::log10(levels)) - 1.0);
  // A part in 10⁹ is rounding of the division and not worth another digit.
  const double rounded = std::ceil(levels / unit - 1e-9) * unit;
  return plainNumber(rounded, std::clamp(static_cast<int>(-std::floor(std::log10(unit) + 0.5)), 0, 6));
}

QString rangeText(double lowest, double highest, int decimals) {
  return plainNumber(lowest, decimals) + QChar(0x2009) + QChar(0x2013) + QChar(0x2009) +
         plainNumber(highest, decimals);
}

} // namespace limn
