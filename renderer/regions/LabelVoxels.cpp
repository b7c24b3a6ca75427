// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/LabelVoxels.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limn {
namespace {

// Sums of values from the middle of the volume's range, so that their squares keep their digits.
struct LabelSums {
  std::size_t all = 0;
  std::size_t valid = 0;
  double sum = 0.0;
  double squares = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
};

LabelFigures figuresFrom(const LabelSums& sums, double middle, double voxelMm3) {
  LabelFigures figures;
  figures.millilitres = static_cast<double>(sums.all) * voxelMm3 / 1000.0;
  figures.voxels = sums.valid;
  if (sums.valid == 0)
    return figures;
  const double count = static_cast<double>(sums.valid);
  const double offset = sums.sum / count;
  figures.mean = middle + offset;
  figures.deviation = std::sqrt(std::max(0.0, sums.squares / count - offset * offset));
  figures.lowest = sums.lowest;
  figures.highest = sums.highest;
  return figures;
}

} // namespace

std::vector<LabelFigures> figuresOfLabels(const LabelMap& labels, const Volume& volume,
                                          const Effort& effort) {
  assert(labels.dims() == volume.grid().dims);
  const glm::ivec3& dims = labels.dims();
  const Rescale& rescale = volume.rescale();
  const VoxelMask& invalid = volume.invalidMask();
  const double middle = (volume.range().lowest + volume.range().highest) / 2.0;
  std::vector<LabelSums> sums(labels.labels().size());
  // In order and on one thread: sums of each label for each slice would be larger than the volume.
  const std::size_t slice = static_cast<std::size_t>(dims.x) * dims.y;
  visitVoxels(volume, [&](const auto& stored) {
    std::visit(
        [&](const auto& places) {
          for (int z = 0; z < dims.z; ++z) {
            if (effort.isCancelled && effort.isCancelled())
              throw Cancelled();
            for (std::size_t voxel = slice * z; voxel < slice * (z + 1); ++voxel) {
              LabelSums& its = sums[places[voxel]];
              ++its.all;
              if (!invalid.empty() && invalid[voxel])
                continue;
              const double value = rescale.slope * static_cast<double>(stored[voxel]) + rescale.intercept;
              its.lowest = its.valid == 0 ? value : std::min(its.lowest, value);
              its.highest = its.valid == 0 ? value : std::max(its.highest, value);
              ++its.valid;
              its.sum += value - middle;
              its.squares += (value - middle) * (value - middle);
            }
          }
        },
        labels.places());
  });
  const glm::dvec3& spacing = volume.grid().spacingMm;
  std::vector<LabelFigures> figures;
  figures.reserve(sums.size());
  for (const LabelSums& its : sums)
    figures.push_back(figuresFrom(its, middle, spacing.x * spacing.y * spacing.z));
  return figures;
}

} // namespace limn
