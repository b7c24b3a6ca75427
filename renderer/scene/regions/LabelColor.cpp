// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/LabelColor.h"

#include "scene/volume/VolumePart.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr int mostVoxelsAsked = 4096;

} // namespace

glm::dvec3 shownColor(const Volume& volume, const Region& region, std::size_t place) {
  const LabelMap& map = *region.labels;
  if (lookOfLabel(region, place) == 0)
    return map.labels()[place].color;
  const TransferFunction& look = region.looks[lookOfLabel(region, place) - 1];
  const VoxelBox& box = map.boxAround(place);
  const glm::ivec3 size = box.upper - box.lower;
  const double voxels = 1.0 * size.x * size.y * size.z;
  const int stride = std::max(1, static_cast<int>(std::ceil(std::cbrt(voxels / mostVoxelsAsked))));
  glm::dvec3 weighed(0.0), plain(0.0);
  double opacity = 0.0, count = 0.0;
  const auto ask = [&](int step) {
    for (int z = box.lower.z; z < box.upper.z; z += step)
      for (int y = box.lower.y; y < box.upper.y; y += step)
        for (int x = box.lower.x; x < box.upper.x; x += step)
          if (map.placeAt(voxelOffset(map.dims(), x, y, z)) == place) {
            const Classified shown = classify(look, volume.value({x, y, z}));
            weighed += shown.opacity * shown.color;
            opacity += shown.opacity;
            plain += shown.color;
            count += 1.0;
          }
  };
  // Thin ones may lie between.
  for (int step = stride; count == 0.0 && step > 0; step /= 2)
    ask(step);
  return opacity > 0.0 ? weighed / opacity : count > 0.0 ? plain / count : map.labels()[place].color;
}

void ShownColors::follow(const std::shared_ptr<const Volume>& volume, const Region& region) {
  const bool areSame = volume == m_volume && region.labels == m_labels;
  m_volume = volume;
  m_labels = region.labels;
  const std::map<std::size_t, Found> before = std::exchange(m_found, {});
  for (std::size_t place = 0; volume && region.labels && place < region.lookOf.size(); ++place) {
    const std::size_t n = lookOfLabel(region, place);
    if (n == 0)
      continue;
    const TransferFunction& look = region.looks[n - 1];
    const auto known = before.find(place);
    const bool isKnown = areSame && known != before.end() && known->second.look == look;
    m_found[place] = isKnown ? known->second : Found{look, shownColor(*volume, region, place)};
  }
  if (m_found.empty())
    m_volume.reset(); // nobody shall wait for its memory
}

glm::dvec3 ShownColors::of(std::size_t place) const {
  const auto found = m_found.find(place);
  return found != m_found.end() ? found->second.color : m_labels->labels()[place].color;
}

} // namespace limn
