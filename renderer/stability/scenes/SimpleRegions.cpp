// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/scenes/SimpleRegions.h"

namespace limn {

Region cubesRegion(const glm::ivec3& dims, int edge, const std::vector<double>& weights) {
  const int count = static_cast<int>(weights.size());
  std::vector<Label> labels;
  labels.reserve(weights.size());
  for (int value = 0; value < count; ++value)
    labels.push_back({value, "Cubes " + std::to_string(value), glm::dvec3(1.0)});
  std::vector<std::uint8_t> places;
  places.reserve(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        places.push_back(static_cast<std::uint8_t>((x / edge + y / edge + z / edge) % count));
  return {Region::Kind::labels, "cubes", std::make_shared<const LabelMap>(dims, places, labels), weights};
}

} // namespace limn
