// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace limn {

/// What all numbers have that are shown, in fields too; most locales write a hyphen.
inline constexpr QChar minusSign(0x2212);

/// A number in the user's locale without grouping or trailing zeros, at most `decimals` of them.
QString plainNumber(double number, int decimals);

/// A number in the user's locale without grouping, with exactly `decimals`: "12.0".
QString fixedNumber(double number, int decimals);

/// A number in the user's locale without grouping, with at most `digits` that count: "0.957".
QString digitsNumber(double number, int digits);

/// The numbers of a list that somebody has typed, with a decimal point or comma: "0.5, 0.5, 1.2" or "0,5;
/// 0,5; 1,2". Nothing where a part of it is no number.
std::optional<std::vector<double>> numbersTyped(const QString& list);

/// Numbers as such a list in the user's locale.
QString numberList(const std::vector<double>& numbers);

/// An opacity for reading: three significant digits, at most six decimals, no trailing zeros.
QString opacityText(double opacity);

/// Numbers as text with their unit behind them. An empty unit adds nothing.
QString withUnit(const QString& numbers, const QString& unit);

/// A number for reading, with its unit: "−310 HU".
QString valueText(double value, const QString& unit, int decimals);

/// An error in 8-bit levels that is promised, two digits, rounded up: "0.66".
QString promisedLevels(double levels);

/// The decimals with which numbers between ends that lie `span` apart are read: about four digits of the
/// span.
int decimalsOfSpan(double span);

/// The decimals that tell apart two numbers `step` > 0 apart, 0..9.
int decimalsFor(double step);

/// The decimals with which mean and standard deviation of `count` > 0 numbers are read that lie `step` > 0
/// apart: so many as tell means apart that chance does, which are known to a √count-th of the deviation or,
/// where that is less, of the step; at most one more than the numbers themselves have.
int decimalsOfMean(double step, double deviation, std::size_t count);

/// A range for reading: "0 – 8".
QString rangeText(double lowest, double highest, int decimals);

} // namespace limn
