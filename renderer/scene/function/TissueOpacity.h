// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"

#include <functional>

namespace limn {

/// Two values, ascending, scalar units.
struct ValueBand {
  double lowest = 0.0;
  double highest = 0.0;
};

/// The function with what `change` makes of every opacity in a band; over half the band's width to either
/// side it goes over into what was there, and further away nothing changes. Points are added where that
/// begins and ends. Results are limited to 0..1.
TransferFunction withOpacityChanged(const TransferFunction& function, const ValueBand& band,
                                    const std::function<double(double)>& change);

/// Half an opacity; what is hardly seen any more becomes 0.
double lessOpacity(double opacity);

/// Twice an opacity, and at least so much that it is seen.
double moreOpacity(double opacity);

} // namespace limn
