// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OrientationLetters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {

std::string lettersOf(const glm::dvec3& direction) {
  constexpr double leastCosine = 0.2588; // cos 75°
  // LPS: +x is the patient's left, +y posterior, +z superior.
  constexpr std::array<const char*, 3> letters{"RL", "AP", "IS"};
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string text;
  for (int axis : order)
    if (std::abs(direction[axis]) > leastCosine)
      text += letters[axis][direction[axis] > 0.0 ? 1 : 0];
  return text;
}

OrientationLetters orientationLetters(const Camera& camera) {
  const CameraBasis basis = basisOf(camera);
  return {lettersOf(-basis.right), lettersOf(basis.right), lettersOf(basis.up), lettersOf(-basis.up)};
}

} // namespace limn
