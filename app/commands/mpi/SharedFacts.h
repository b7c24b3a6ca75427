// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/mpi/Ranks.h"
#include "io/reading/PartWanted.h"
#include "scene/Scene.h"
#include "scene/framing/VisibleVoxels.h"

#include <map>
#include <optional>

namespace limn {

using cpu::WholeFacts;

/// Which voxels of a volume a rank holds while it knows of no scene, and which it counts: its brick of a
/// scene without crop and with ordinary steps.
PartWanted::Share shareOf(const Ranks& ranks, const Grid& grid, bool inSlices);

/// The voxels that this rank counts of a volume, whether it holds others or not.
VoxelBox ownVoxels(const Ranks& ranks, const Volume& volume);

/// What this rank adds to an answer that all give together, by ofAll.
BinCounts countsOfOwn(const Volume& volume, int mostBins);
VisibleVoxels visibleOfOwn(const Scene& scene, int unitVoxels);

/// What pictures need to know of all voxels of the one volume that is drawn, each rank looking at its own.
/// Keeps what was found.
class SharedFacts {
public:
  SharedFacts(const Ranks& ranks, int threads) : m_ranks(ranks), m_effort{threads, {}, {}} {}

  /// All ranks call it alike, with the same scene. Throws on all what fails on any.
  WholeFacts of(const Scene& scene);

private:
  FoundModuli modulusOf(const Volume& volume, std::optional<double> percent);

  const Ranks& m_ranks;
  Effort m_effort;
  std::map<std::optional<double>, FoundModuli> m_moduli; // by the percent
  std::optional<double> m_steepness;
};

} // namespace limn
