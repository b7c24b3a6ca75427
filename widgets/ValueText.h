// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace limn {

/// A number in the user's locale without grouping or trailing zeros, at most `decimals` of them.
QString plainNumber(double number, int decimals);

/// An opacity for reading: three significant digits, at most six decimals, no trailing zeros.
QString opacityText(double opacity);

/// A number for reading, with a real minus sign and its unit: "−310 HU". An empty unit adds nothing.
QString valueText(double value, const QString& unit, int decimals);

/// An error in 8-bit levels that is promised, two digits, rounded up: "0.66".
QString promisedLevels(double levels);

/// The decimals that tell apart two numbers `step` > 0 apart, 0..9.
int decimalsFor(double step);

/// A range for reading: "0 – 8".
QString rangeText(double lowest, double highest, int decimals);

} // namespace limn
