// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/StandIns.h"

#include "scene/regions/Reduction.h"

namespace limn::cpu {
namespace {

double pixelMm(const Scene& scene, const glm::ivec2& size) {
  const Camera& camera = scene.camera;
  const double away = camera.projection == Camera::Projection::orthographic
                          ? 1.0
                          : glm::length(camera.position - boxCentreMm(scene.volume->grid()));
  return 2.0 * halfHeight(camera) * away / size.y;
}

} // namespace

bool StandIns::makeReady(const std::shared_ptr<const Volume>& volume, const Effort& effort) {
  if (volume == m_whole)
    return false;
  m_whole.reset();
  m_levels.clear();
  m_kept.clear();
  if (volume->room())
    m_levels = pyramidOf(*volume, m_mostBytes, effort);
  m_kept.resize(m_levels.size());
  m_whole = volume;
  return true;
}

std::optional<StandIn> StandIns::of(const Scene& scene, const glm::ivec2& size) {
  if (m_levels.empty() || scene.volume != m_whole)
    return std::nullopt;
  const double pixel = pixelMm(scene, size);
  std::size_t level = 0;
  while (level + 1 < m_levels.size() && smallestSpacingMm(m_levels[level + 1].volume->grid()) <= pixel)
    ++level;
  const CoarseVolume& coarse = m_levels[level];
  StandIn standIn{scene, {coarse.reduction, coarse.largestError}};
  standIn.scene.volume = coarse.volume;
  standIn.scene.keep = kept(scene.keep, coarse.reduction, level);
  return standIn;
}

const Region& StandIns::kept(const Region& keep, int reduction, std::size_t level) {
  Kept& last = m_kept[level];
  if (last.whole != keep)
    last = {keep, reduced(keep, glm::ivec3(reduction))};
  return last.coarse;
}

} // namespace limn::cpu
