// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/cases/Cases.h"

#include <algorithm>
#include <iterator>

namespace limn {

std::vector<HardCase> hardCases() {
  std::vector<HardCase> cases;
  for (const auto& group : {formulaCases, blendingCases, rayCases, voxelCases, functionCases, gradientCases,
                            reuseCases, projectionCases, driverCases}) {
    std::vector<HardCase> more = group();
    std::move(more.begin(), more.end(), std::back_inserter(cases));
  }
  // "H10" after "H9".
  std::stable_sort(cases.begin(), cases.end(), [](const HardCase& a, const HardCase& b) {
    return std::stoi(a.id.substr(1)) < std::stoi(b.id.substr(1));
  });
  return cases;
}

} // namespace limn
