// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <stdexcept>
#include <vector>

namespace limn::test {

/// The order that each halving of a step shows, log2(e_h / e_{h/2}), for errors from coarse to fine; halvings
/// that end below `floor` show rounding and are left out.
inline std::vector<double> observedOrders(const std::vector<double>& errors, double floor) {
  std::vector<double> orders;
  for (std::size_t i = 1; i < errors.size(); ++i)
    if (errors[i] >= floor)
      orders.push_back(std::log2(errors[i - 1] / errors[i]));
  return orders;
}

} // namespace limn::test
