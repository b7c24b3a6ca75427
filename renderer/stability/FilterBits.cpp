// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/FilterBits.h"

#include "scene/volume/Volume.h"
#include "stability/GlslEvaluator.h"
#include "stability/scenes/SimpleScenes.h"

#include <algorithm>
#include <bit>
#include <set>

namespace limn {

int filterBits() {
  constexpr int places = 1 << mostFilterBits;
  Scene scene;
  scene.volume = volumeOf(centredGrid({2, 2, 2}, glm::dvec3(1.0)), [](int x, int, int) { return x; });
  scene.transferFunction.points = {{0.0, glm::dvec3(1.0), 0.0}, {1.0, glm::dvec3(1.0), 1.0}};
  std::vector<glm::vec4> arguments;
  for (int i = 0; i < places; ++i)
    arguments.emplace_back((static_cast<float>(i) + 0.5f) / places - 0.5f, 0.0f, 0.0f, 0.0f);
  std::vector<float> values;
  const GlslEvaluator evaluate({"volume.glsl"});
  for (const glm::vec4& value : evaluate("scalarAt(toTexture(vec3(v.x, 0.0, 0.0)))", arguments, scene))
    values.push_back(value.r);
  return filterBitsOf(values);
}

int filterBitsOf(const std::vector<float>& values) {
  // With b bits there are 2^b values and, where fractions are rounded, one more.
  const std::set<float> different(values.begin(), values.end());
  return std::bit_width(std::max<std::size_t>(different.size(), 1)) - 1;
}

std::string filterText(int bits) {
  const std::string number = std::to_string(bits);
  if (bits >= mostFilterBits)
    return "weights of at least " + number + " bits between voxels";
  return "weights of " + number + " bits between voxels: values are off by up to 1/" +
         std::to_string(2 << bits) + " of what a cell changes by";
}

} // namespace limn
