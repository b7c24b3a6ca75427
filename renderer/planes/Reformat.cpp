// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/Reformat.h"

#include "planes/VoxelRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double outside = std::numeric_limits<double>::quiet_NaN();

// Rows are shared out in pieces of about this many samples; less than one piece is not worth a thread.
constexpr int samplesPerPiece = 1 << 15;

// A way through the grid; what rounding leaves beside an axis moves no sample by 1e-8 voxels.
glm::dvec3 indexVector(const Grid& volume, const glm::dvec3& vectorMm) {
  const glm::dvec3 vector = worldVectorToIndex(volume, vectorMm);
  return glm::mix(vector, glm::dvec3(0.0), glm::lessThan(glm::abs(vector), glm::dvec3(1e-12)));
}

IndexPlane indexPlane(const Grid& volume, const PlaneGrid& plane, const Slab& slab) {
  IndexPlane result{worldToIndex(volume, plane.originMm),
                    indexVector(volume, plane.spacingMm * plane.axes.right),
                    indexVector(volume, plane.spacingMm * plane.axes.down),
                    {}};
  const glm::dvec3 perMm = indexVector(volume, glm::cross(plane.axes.right, plane.axes.down));
  const double voxels =
      slab.thicknessMm * std::max({std::abs(perMm.x), std::abs(perMm.y), std::abs(perMm.z)});
  // Rounding of a thickness of whole voxels must not add a sample.
  const int samples = std::max(1, static_cast<int>(std::ceil(voxels - 1e-6)));
  for (int i = 0; i < samples; ++i)
    result.offsets.push_back(((i + 0.5) / samples - 0.5) * slab.thicknessMm * perMm);
  return result;
}

bool isWithin(const glm::dvec3& index, const glm::ivec3& dims) {
  return glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) &&
         glm::all(glm::lessThan(index, glm::dvec3(dims) - 0.5));
}

// Clip the row against the box, then settle the ends by the very arithmetic that samples are taken with.
PixelSpan spanInside(const glm::dvec3& start, const glm::dvec3& step, const glm::ivec3& dims, int width) {
  double first = 0.0;
  double last = width;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = -0.5 - start[axis];
    const double high = dims[axis] - 0.5 - start[axis];
    if (step[axis] == 0.0) {
      if (low > 0.0 || high <= 0.0)
        return {};
      continue;
    }
    const double a = low / step[axis];
    const double b = high / step[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first <= last))
    return {};
  PixelSpan span{std::max(0, static_cast<int>(std::floor(first)) - 1),
                 std::min(width, static_cast<int>(std::ceil(last)) + 2)};
  while (span.first < span.last && !isWithin(start + static_cast<double>(span.first) * step, dims))
    ++span.first;
  while (span.first < span.last && !isWithin(start + static_cast<double>(span.last - 1) * step, dims))
    --span.last;
  return span;
}

/// What a thread works with.
struct Workroom {
  std::vector<int> samples; ///< of each pixel of a row, so far
  std::vector<double> line; ///< of voxels
};

template <class Fetch>
PlaneImage sampled(const Grid& volume, const PlaneGrid& plane, const PlaneSampling& sampling,
                   const Fetch& fetch, const Effort& effort) {
  const IndexPlane place = indexPlane(volume, plane, sampling.slab);
  const bool isMaximum = sampling.slab.mode == Slab::Mode::maximum;
  const bool isLinear = sampling.interpolation == PlaneInterpolation::linear;
  const std::optional<AlignedAxes> axes = isLinear ? alignedAxes(place) : std::nullopt;
  const VoxelRows<Fetch> rows(volume.dims, fetch);
  const AlignedRows<Fetch> aligned(volume.dims, fetch, place, axes.value_or(AlignedAxes{}),
                                   axes ? plane.size.x : 0);
  PlaneImage image{plane.size,
                   std::vector<double>(static_cast<std::size_t>(plane.size.x) * plane.size.y, outside)};

  const auto readRow = [&](int y, Workroom& room) {
    double* const row = image.values.data() + static_cast<std::size_t>(y) * plane.size.x;
    int* const samples = room.samples.data();
    std::fill(room.samples.begin(), room.samples.end(), 0);
    const auto take = [&](int x, double value) {
      const bool isFirst = samples[x]++ == 0;
      row[x] = isFirst ? value : isMaximum ? std::max(row[x], value) : row[x] + value;
    };
    for (const glm::dvec3& offset : place.offsets) {
      const glm::dvec3 start = place.origin + static_cast<double>(y) * place.perRow + offset;
      const PixelSpan span = spanInside(start, place.perColumn, volume.dims, plane.size.x);
      if (axes)
        aligned.read(start, span, room.line, take);
      else
        rows.read(sampling.interpolation, start, place.perColumn, span, take);
    }
    if (!isMaximum)
      for (int x = 0; x < plane.size.x; ++x)
        if (samples[x] > 1)
          row[x] /= samples[x];
  };

  const auto perRow =
      static_cast<std::int64_t>(plane.size.x) * static_cast<std::int64_t>(place.offsets.size());
  const int together = static_cast<int>(
      std::clamp<std::int64_t>(samplesPerPiece / std::max<std::int64_t>(1, perRow), 1, 1024));
  forEachPiece((plane.size.y + together - 1) / together, effort, [&](int piece) {
    Workroom room{std::vector<int>(static_cast<std::size_t>(plane.size.x)),
                  std::vector<double>(axes ? static_cast<std::size_t>(volume.dims[axes->column]) : 0)};
    for (int y = piece * together; y < std::min(plane.size.y, (piece + 1) * together); ++y)
      readRow(y, room);
  });
  return image;
}

} // namespace

PlaneImage reformatted(const Volume& volume, const PlaneGrid& plane, const PlaneSampling& sampling,
                       const Effort& effort) {
  return visitVoxels(volume, [&](const auto& stored) {
    const auto fetch = [voxels = stored.data(), slope = volume.rescale().slope,
                        intercept = volume.rescale().intercept](std::ptrdiff_t at) {
      return slope * static_cast<double>(voxels[at]) + intercept;
    };
    return sampled(volume.grid(), plane, sampling, fetch, effort);
  });
}

PlaneImage weightsOn(const Region& region, const Grid& volume, const PlaneGrid& plane,
                     PlaneInterpolation interpolation, const Effort& effort) {
  const PlaneSampling sampling{interpolation, {}};
  if (!region.labels)
    return sampled(
        volume, plane, sampling, [](std::ptrdiff_t) { return 1.0; }, effort);
  return std::visit(
      [&](const auto& places) {
        const auto fetch = [places = places.data(), weights = region.weights.data()](std::ptrdiff_t at) {
          return weights[places[at]];
        };
        return sampled(volume, plane, sampling, fetch, effort);
      },
      region.labels->places());
}

} // namespace limn
