// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/HardCase.h"

#include <string>

namespace limn {

/// Fails where any row fails; applies where any does.
Verdict verdictOf(const MeasuredCase& one);

/// "8.4e-08 of 1e-06"; "n/a" where there is no figure.
std::string figureText(const Finding& finding);

/// A figure with two digits.
std::string shortNumber(double value);

} // namespace limn
