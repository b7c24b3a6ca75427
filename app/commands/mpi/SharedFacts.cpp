// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/mpi/SharedFacts.h"

#include "scene/effects/EffectPlan.h"
#include "scene/framing/KeptVoxels.h"

namespace limn {

PartWanted::Share shareOf(const Ranks& ranks, const Grid& grid, bool inSlices) {
  const IndexBox brick = Bricks(grid, CropBox{}, ranks.count(), inSlices).box(ranks.rank());
  return {voxelsRead(grid, brick, Quality{}.stepVoxels), ownVoxels(grid, brick)};
}

VoxelBox ownVoxels(const Ranks& ranks, const Volume& volume) {
  return volume.part() ? volume.part()->own : shareOf(ranks, volume.grid(), false).own;
}

BinCounts countsOfOwn(const Volume& volume, int mostBins) {
  return countsIn(volume, volume.part()->own, mostBins);
}

VisibleVoxels visibleOfOwn(const Scene& scene, int unitVoxels) {
  const VoxelBox left = croppedVoxels(scene.volume->grid(), scene.crop);
  return visibleWithin(scene, intersection(left, scene.volume->part()->own), unitVoxels);
}

// Which effects read gradients does not depend on what ranks find of their bricks.
WholeFacts SharedFacts::of(const Scene& scene) {
  const Volume& volume = *scene.volume;
  const EffectSet effects = requiredEffects(scene, SceneFacts{}).effects;
  WholeFacts whole;
  if (effects.has(Effect::gradient)) {
    const GradientReference reference = resolvedReference(scene.shading);
    const auto* percentile = std::get_if<PercentileReference>(&reference);
    if (percentile && usesRatio(effects))
      whole.percent = percentile->percent;
    whole.moduli = modulusOf(volume, whole.percent);
  }
  if (readsSteepness(scene)) {
    if (!m_steepness) {
      const auto find = [&] { return latticeModuli(volume, ownVoxels(m_ranks, volume)); };
      m_steepness = steepness(volume, ofAll<LatticeModuli>(m_ranks, find));
    }
    whole.steepestPerMm = *m_steepness;
  }
  return whole;
}

FoundModuli SharedFacts::modulusOf(const Volume& volume, std::optional<double> percent) {
  if (const auto known = m_moduli.find(percent); known != m_moduli.end())
    return known->second;
  const VoxelBox own = ownVoxels(m_ranks, volume);
  const auto sample = [&] {
    return ofAll<ModulusSample>(m_ranks, [&] { return sampledModuli(volume, own, m_effort); });
  };
  const auto count = [&](const std::optional<ModulusWindow>& window, double known) {
    return ofAll<ModulusCounts>(m_ranks, [&] { return countedModuli(volume, own, window, known, m_effort); });
  };
  return m_moduli[percent] = findModuliBy({sample, count}, volume, percent);
}

} // namespace limn
