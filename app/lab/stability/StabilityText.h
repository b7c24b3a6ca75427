// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/PictureFuzz.h"

#include <string>

namespace limn {

/// Fails where any row fails; applies where any does.
Verdict verdictOf(const MeasuredCase& one);

/// "8.4e-08 of 1e-06"; "n/a" where there is no figure.
std::string figureText(const Finding& finding);

/// A figure with two digits.
std::string shortNumber(double value);

/// Whether no case and no seed failed.
bool holds(const StabilityReport& report);

/// A line that counts cases, rows, seeds and failures.
std::string stabilitySummary(const StabilityReport& report);

/// For the terminal: a line per case with the tightest row of each engine; rows that fail in full.
std::string stabilityTable(const StabilityReport& report);

/// A page with every row and the pictures inside it, so that one file can be sent.
std::string stabilityPage(const StabilityReport& report);

} // namespace limn
