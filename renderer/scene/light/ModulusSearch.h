// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/volume/Volume.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <tuple>
#include <vector>

namespace limn {

/// What the gradient moduli of a volume's eligible voxels hold, value/mm; 0 where none is eligible.
struct FoundModuli {
  double largest = 0.0;
  double percentile = 0.0; ///< a float, or the largest itself
  bool operator==(const FoundModuli&) const = default;
};

/// Finds the largest modulus and, where a `percent` (0..100] is given, that nearest-rank percentile: the
/// exact element, rounded to float; at 100 the largest itself. As a rule in one pass over the volume, the
/// same for any number of threads: a quick estimate in float tells which moduli could be either, and only
/// those are computed in double.
FoundModuli findModuli(const Volume& volume, std::optional<double> percent, const Effort& effort = {});

/// Moduli, as bits of floats in units of `modulusUnit`, among which an element is looked for. They are
/// counted in classes of 2^shift.
struct ModulusWindow {
  static constexpr std::uint32_t bitsOfInfinity = 0x7f800000; ///< floats that are not negative order as these

  std::uint32_t mostClasses = 1;
  std::uint32_t first = 0;
  std::uint32_t last = bitsOfInfinity;

  int shift() const;
  std::size_t classes() const { return ((last - first) >> shift()) + std::size_t{1}; }
};

/// What a pass over voxels finds of their moduli, in units of `modulusUnit`.
struct ModulusCounts {
  double largest = 0.0;
  std::uint64_t eligible = 0;
  std::uint64_t above = 0;            ///< behind the window
  std::vector<std::uint64_t> classes; ///< of the window; none where only the largest is looked for
  auto fields() { return std::tie(largest, eligible, above, classes); }
};

/// Of the voxels of both, which share none, in the same window. In any order and grouping the same.
ModulusCounts joined(const ModulusCounts& a, const ModulusCounts& b);

/// Moduli of some voxels, each from another part of the volume, in units of `modulusUnit`. It tells where a
/// percentile likely is, never what it is.
struct ModulusSample {
  std::vector<float> moduli;
  auto fields() { return std::tie(moduli); }
};
ModulusSample joined(const ModulusSample& a, const ModulusSample& b);

/// Of the voxels `of`; a volume that holds a part holds their neighbours, too. Throw Cancelled.
ModulusSample sampledModuli(const Volume& volume, const VoxelBox& of, const Effort& effort = {});
/// The largest is `known` at least. Without a window only the largest is looked for.
ModulusCounts countedModuli(const Volume& volume, const VoxelBox& of,
                            const std::optional<ModulusWindow>& window, double known,
                            const Effort& effort = {});

/// How all voxels are looked at: by one process, or by several of which each looks at its own.
struct ModulusLooks {
  std::function<ModulusSample()> sample;
  std::function<ModulusCounts(const std::optional<ModulusWindow>& window, double known)> count;
};

/// As findModuli: what is found does not depend on who looked at which voxels. Of the volume it asks how many
/// voxels there are, range and grid.
FoundModuli findModuliBy(const ModulusLooks& looks, const Volume& volume, std::optional<double> percent);

} // namespace limn
