// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/LightGrid.h"

#include "scene/volume/Volume.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Codes as vectors of numbers, of which the first tells whether a node is known.
glm::ivec4 codesOf(std::uint8_t code) {
  return {code, 0, 0, 0};
}
glm::ivec4 codesOf(const std::array<std::uint8_t, 4>& codes) {
  return {codes[0], codes[1], codes[2], codes[3]};
}
void setCodes(std::uint8_t& code, const glm::ivec4& codes) {
  code = static_cast<std::uint8_t>(codes.x);
}
void setCodes(std::array<std::uint8_t, 4>& to, const glm::ivec4& codes) {
  for (int part = 0; part < 4; ++part)
    to[static_cast<std::size_t>(part)] = static_cast<std::uint8_t>(codes[part]);
}

// The mean of the neighbours that are known, rounded; 0 where none is.
template <class Light>
glm::ivec4 meanAround(const LightNodes& nodes, const Light& light, const glm::ivec3& node) {
  const glm::ivec3 from = glm::max(node - 1, glm::ivec3(0));
  const glm::ivec3 to = glm::min(node + 1, nodes.count - 1);
  glm::ivec4 sum(0);
  int known = 0;
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x)
        if (const glm::ivec4 codes = codesOf(light[voxelOffset(nodes.count, x, y, z)]); codes.x > 0) {
          sum += codes;
          ++known;
        }
  return known > 0 ? (sum + known / 2) / known : sum;
}

template <class Light>
void completeAll(const LightNodes& nodes, Light& light, const glm::ivec4& allComes) {
  const Light before = light;
  for (int z = 0; z < nodes.count.z; ++z)
    for (int y = 0; y < nodes.count.y; ++y)
      for (int x = 0; x < nodes.count.x; ++x) {
        auto& node = light[voxelOffset(nodes.count, x, y, z)];
        if (codesOf(node).x > 0)
          continue;
        const glm::ivec4 mean = meanAround(nodes, before, {x, y, z});
        setCodes(node, mean.x > 0 ? mean : allComes);
      }
}

// From one node to the next, smallest spacings; of the axes the shortest way.
double distanceBetween(const LightNodes& nodes, const Grid& grid) {
  const glm::dvec3 mm = nodes.stride * grid.spacingMm;
  return std::min({mm.x, mm.y, mm.z}) / smallestSpacingMm(grid);
}

} // namespace

double LightVolumes::directFrom() const {
  return isFine ? LightLook::farthest : 0.0;
}

LightLook lightLook(const LightVolumes& light, const Grid& grid, bool isFine) {
  const double ambientAway = std::max(1.5, distanceBetween(light.ambientNodes, grid));
  if (isFine && light.isFine)
    return {LightLook::farthest, LightLook::farthest - light.directFrom(), ambientAway, true};
  const double half = 0.5 * distanceBetween(light.directNodes, grid);
  const double away = std::max(light.isFine ? LightLook::awayMoving : 1.75, half);
  return {away, away - light.directFrom(), ambientAway, false};
}

LayerLengths layerLengths(double from) {
  LayerLengths lengths{};
  const double height = LightLook::layersReach / static_cast<double>(lengths[0].size());
  for (std::size_t angle = 0; angle < lengths.size(); ++angle) {
    // Weighed by the cosine light of equal shares comes from equal parts of the cosine's square.
    const double cosine = std::sqrt((static_cast<double>(angle) + 0.5) / static_cast<double>(lengths.size()));
    for (std::size_t layer = 0; layer < lengths[angle].size(); ++layer) {
      const double lower = std::max(static_cast<double>(layer) * height, from * cosine);
      const double upper = std::min(static_cast<double>(layer + 1) * height, LightLook::layersReach * cosine);
      lengths[angle][layer] = static_cast<float>(std::max(0.0, upper - lower) / cosine);
    }
  }
  return lengths;
}

void complete(const LightNodes& nodes, DirectLight& light) {
  completeAll(nodes, light, {255, 0, 0, 0});
}

void complete(const LightNodes& nodes, AmbientLight& light) {
  completeAll(nodes, light, {255, 127, 127, 127});
}

LightNodes lightNodes(const Grid& grid, const glm::dvec3& lower, const glm::dvec3& upper,
                      std::size_t bytesEach, std::size_t mostBytes) {
  const glm::dvec3 extent = upper - lower;
  if (glm::any(glm::lessThanEqual(extent, glm::dvec3(0.0))))
    return {};
  const glm::dvec3 sizeMm = extent * grid.spacingMm;
  LightNodes nodes;
  nodes.first = lower;
  const double most = static_cast<double>(mostBytes) / static_cast<double>(bytesEach);
  double distanceMm = std::max(smallestSpacingMm(grid), std::cbrt(sizeMm.x * sizeMm.y * sizeMm.z / most));
  for (;; distanceMm *= 1.02) {
    const glm::dvec3 count = glm::max(glm::ceil(sizeMm / distanceMm) + 1.0, glm::dvec3(2.0));
    nodes.count = glm::ivec3(count);
    if (count.x * count.y * count.z <= std::max(most, 8.0))
      break;
  }
  nodes.stride = extent / glm::dvec3(nodes.count - 1);
  return nodes;
}

} // namespace limn
