// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/Reformat.h"

#include "scene/view/PlaneSettings.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace limn {
namespace {

// The pixels of a row that lie inside the volume: first ≤ x < last.
struct PixelSpan {
  int first = 0;
  int last = 0;
};

// Where the pixels of a plane lie in a volume, in voxel indices.
struct IndexPlane {
  glm::dvec3 origin{0.0}, perColumn{0.0}, perRow{0.0};
  std::vector<glm::dvec3> offsets; ///< of the samples of a slab from the plane
};

// One index axis as samples are taken from it.
struct VoxelAxis {
  VoxelAxis(int voxels, std::ptrdiff_t pitch)
      : last(voxels - 1), lowest(std::max(0, voxels - 2)), stride(pitch), next(voxels > 1 ? pitch : 0) {}
  double last;           ///< the last voxel's centre
  int lowest;            ///< the last voxel that has a next one
  std::ptrdiff_t stride; ///< from a voxel to the next in the stored array
  std::ptrdiff_t next;   ///< 0 where there is none
};

// Between which voxels of an axis an index lies.
struct BetweenVoxels {
  int low = 0;
  double share = 0.0; ///< of the next voxel
};

// Beyond the ends of the axis its first or last voxel.
BetweenVoxels betweenOn(const VoxelAxis& axis, double index) {
  const double clamped = std::min(std::max(index, 0.0), axis.last);
  const int low = std::min(static_cast<int>(clamped), axis.lowest);
  return {low, clamped - low};
}

// Reads the stored array along any row; `Fetch` makes a scalar of a position in it.
template <class Fetch>
class VoxelRows {
public:
  VoxelRows(const glm::ivec3& dims, const Fetch& fetch)
      : m_x(dims.x, 1), m_y(dims.y, dims.x), m_z(dims.z, static_cast<std::ptrdiff_t>(dims.x) * dims.y),
        m_fetch(fetch) {}

  /// Calls `take(x, value)` for each pixel of the span.
  template <class Take>
  void read(PlaneInterpolation interpolation, const glm::dvec3& start, const glm::dvec3& step,
            const PixelSpan& span, Take&& take) const {
    if (interpolation == PlaneInterpolation::nearest)
      for (int x = span.first; x < span.last; ++x)
        take(x, nearest(start + static_cast<double>(x) * step));
    else
      for (int x = span.first; x < span.last; ++x)
        take(x, linear(start + static_cast<double>(x) * step));
  }

private:
  // Indices are at least -0.5 here, so that adding a half and cutting off rounds.
  static std::ptrdiff_t roundedOn(const VoxelAxis& axis, double index) {
    return static_cast<std::ptrdiff_t>(std::min(index + 0.5, axis.last)) * axis.stride;
  }

  double nearest(const glm::dvec3& index) const {
    return m_fetch(roundedOn(m_x, index.x) + roundedOn(m_y, index.y) + roundedOn(m_z, index.z));
  }

  double linear(const glm::dvec3& index) const {
    const BetweenVoxels x = betweenOn(m_x, index.x);
    const BetweenVoxels y = betweenOn(m_y, index.y);
    const BetweenVoxels z = betweenOn(m_z, index.z);
    const std::ptrdiff_t at = x.low * m_x.stride + y.low * m_y.stride + z.low * m_z.stride;
    const auto alongX = [&](std::ptrdiff_t offset) {
      const double low = m_fetch(offset);
      return low + x.share * (m_fetch(offset + m_x.next) - low);
    };
    const auto alongY = [&](std::ptrdiff_t offset) {
      const double low = alongX(offset);
      return low + y.share * (alongX(offset + m_y.next) - low);
    };
    const double low = alongY(at);
    return low + z.share * (alongY(at + m_z.next) - low);
  }

  VoxelAxis m_x, m_y, m_z;
  Fetch m_fetch;
};

// The index axes along which the columns and rows of a plane run, and the one across it.
struct AlignedAxes {
  int column = 0;
  int row = 1;
  int across = 2;
};

// The axes where each way runs along one of its own, as in every volume that is not oblique.
std::optional<AlignedAxes> alignedAxes(const IndexPlane& plane) {
  const auto loneAxis = [](const glm::dvec3& way) {
    const glm::bvec3 moves = glm::notEqual(way, glm::dvec3(0.0));
    return moves.x + moves.y + moves.z == 1 ? (moves.x ? 0 : moves.y ? 1 : 2) : -1;
  };
  const int column = loneAxis(plane.perColumn);
  const int row = loneAxis(plane.perRow);
  if (column < 0 || row < 0 || column == row)
    return std::nullopt;
  return AlignedAxes{column, row, 3 - column - row};
}

// The same as linear VoxelRows where axes are aligned, several times as fast: of a row, first the voxels of
// the line that it lies on are interpolated between their four neighbours, then the pixels between those.
template <class Fetch>
class AlignedRows {
public:
  AlignedRows(const glm::ivec3& dims, const Fetch& fetch, const IndexPlane& plane, const AlignedAxes& axes,
              int width)
      : m_axes(axes), m_fetch(fetch) {
    const std::ptrdiff_t pitches[] = {1, dims.x, static_cast<std::ptrdiff_t>(dims.x) * dims.y};
    for (const int axis : {axes.column, axes.row, axes.across})
      m_voxels.emplace_back(dims[axis], pitches[axis]);
    for (int x = 0; x < width; ++x)
      m_columns.push_back(
          betweenOn(m_voxels[0], plane.origin[axes.column] + x * plane.perColumn[axes.column]));
  }

  /// `line` is room to work in, as long as the volume is along the columns.
  template <class Take>
  void read(const glm::dvec3& start, const PixelSpan& span, std::vector<double>& line, Take&& take) const {
    if (span.first >= span.last)
      return;
    const auto [begin, end] = std::minmax(m_columns[static_cast<std::size_t>(span.first)].low,
                                          m_columns[static_cast<std::size_t>(span.last) - 1].low);
    const BetweenVoxels row = betweenOn(m_voxels[1], start[m_axes.row]);
    const BetweenVoxels across = betweenOn(m_voxels[2], start[m_axes.across]);
    const std::ptrdiff_t base = row.low * m_voxels[1].stride + across.low * m_voxels[2].stride;
    const std::ptrdiff_t stride = m_voxels[0].stride;
    const std::ptrdiff_t nextRow = m_voxels[1].next;
    const std::ptrdiff_t nextAcross = m_voxels[2].next;
    const int last = std::min(end + 1, static_cast<int>(m_voxels[0].last));
    for (int i = begin; i <= last; ++i) {
      const std::ptrdiff_t at = base + i * stride;
      const double near = m_fetch(at) + row.share * (m_fetch(at + nextRow) - m_fetch(at));
      const double far = m_fetch(at + nextAcross) +
                         row.share * (m_fetch(at + nextAcross + nextRow) - m_fetch(at + nextAcross));
      line[static_cast<std::size_t>(i)] = near + across.share * (far - near);
    }
    const std::size_t next = m_voxels[0].next != 0 ? 1 : 0;
    for (int x = span.first; x < span.last; ++x) {
      const BetweenVoxels& column = m_columns[static_cast<std::size_t>(x)];
      const double* const low = line.data() + column.low;
      take(x, low[0] + column.share * (low[next] - low[0]));
    }
  }

private:
  AlignedAxes m_axes;
  std::vector<VoxelAxis> m_voxels; ///< in the order of AlignedAxes
  std::vector<BetweenVoxels> m_columns;
  Fetch m_fetch;
};

constexpr double outside = std::numeric_limits<double>::quiet_NaN();

// Rows are shared out in pieces of about this many samples; less than one piece is not worth a thread.
constexpr int samplesPerPiece = 1 << 15;

int rowsTogether(int width, std::size_t samplesOfPixel) {
  const auto perRow = static_cast<std::int64_t>(width) * static_cast<std::int64_t>(samplesOfPixel);
  return static_cast<int>(
      std::clamp<std::int64_t>(samplesPerPiece / std::max<std::int64_t>(1, perRow), 1, 1024));
}

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

  const int together = rowsTogether(plane.size.x, place.offsets.size());
  forEachPiece((plane.size.y + together - 1) / together, effort, [&](int piece) {
    Workroom room{std::vector<int>(static_cast<std::size_t>(plane.size.x)),
                  std::vector<double>(axes ? static_cast<std::size_t>(volume.dims[axes->column]) : 0)};
    for (int y = piece * together; y < std::min(plane.size.y, (piece + 1) * together); ++y)
      readRow(y, room);
  });
  return image;
}

// The shares of a region's looks at indices inside the volume. Most places lie between voxels of one label,
// which is seen at once.
template <class Places>
class ShareReader {
public:
  ShareReader(const Region& region, const LabelLooks& looks, const Places& places)
      : m_region(region), m_looks(looks), m_places(places.data()), m_dims(region.labels->dims()) {}

  void addNearest(const glm::dvec3& index, std::vector<LookShare>& shares) const {
    const glm::ivec3 voxel = glm::min(glm::ivec3(index + 0.5), m_dims - 1);
    shares.push_back(alone(m_places[voxelOffset(m_dims, voxel.x, voxel.y, voxel.z)]));
  }

  void addBetween(const glm::dvec3& index, std::vector<LookShare>& shares) const {
    const glm::ivec3 low = glm::min(glm::ivec3(glm::max(index, glm::dvec3(0.0))), m_dims - 1);
    const glm::ivec3 high = glm::min(low + 1, m_dims - 1);
    const auto* const near = m_places + voxelOffset(m_dims, 0, 0, low.z);
    const auto* const far = m_places + voxelOffset(m_dims, 0, 0, high.z);
    const std::size_t above = static_cast<std::size_t>(low.y) * m_dims.x;
    const std::size_t below = static_cast<std::size_t>(high.y) * m_dims.x;
    const auto place = near[above + low.x];
    const bool isOne = near[above + high.x] == place && near[below + low.x] == place &&
                       near[below + high.x] == place && far[above + low.x] == place &&
                       far[above + high.x] == place && far[below + low.x] == place &&
                       far[below + high.x] == place;
    if (isOne)
      return shares.push_back(alone(place));
    const LookShares mixed = lookSharesAt(m_looks, m_region, index);
    shares.insert(shares.end(), mixed.used().begin(), mixed.used().end());
  }

private:
  LookShare alone(std::size_t place) const { return {m_looks.ofLabel[place], 1.0, m_region.weights[place]}; }

  const Region& m_region;
  const LabelLooks& m_looks;
  const typename Places::value_type* m_places;
  glm::ivec3 m_dims;
};

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

std::span<const LookShare> PlaneShares::at(int x, int y) const {
  const Row& row = rows[static_cast<std::size_t>(y)];
  const std::uint32_t begin = x > 0 ? row.ends[static_cast<std::size_t>(x) - 1] : 0;
  return std::span(row.shares).subspan(begin, row.ends[static_cast<std::size_t>(x)] - begin);
}

PlaneShares sharesOn(const Region& region, const LabelLooks& looks, const Grid& volume,
                     const PlaneGrid& plane, PlaneInterpolation interpolation, const Effort& effort) {
  const IndexPlane place = indexPlane(volume, plane, {});
  PlaneShares all{plane.size, std::vector<PlaneShares::Row>(static_cast<std::size_t>(plane.size.y))};
  const auto readRow = [&](const auto& reader, int y) {
    PlaneShares::Row& row = all.rows[static_cast<std::size_t>(y)];
    row.ends.assign(static_cast<std::size_t>(plane.size.x), 0);
    row.shares.reserve(static_cast<std::size_t>(plane.size.x));
    const glm::dvec3 start = place.origin + static_cast<double>(y) * place.perRow;
    const PixelSpan span = spanInside(start, place.perColumn, volume.dims, plane.size.x);
    for (int x = span.first; x < plane.size.x; ++x) {
      const glm::dvec3 index = start + static_cast<double>(x) * place.perColumn;
      if (x < span.last && interpolation == PlaneInterpolation::nearest)
        reader.addNearest(index, row.shares);
      else if (x < span.last)
        reader.addBetween(index, row.shares);
      row.ends[static_cast<std::size_t>(x)] = static_cast<std::uint32_t>(row.shares.size());
    }
  };
  const int together = rowsTogether(plane.size.x, 1);
  std::visit(
      [&](const auto& places) {
        const ShareReader reader(region, looks, places);
        forEachPiece((plane.size.y + together - 1) / together, effort, [&](int piece) {
          for (int y = piece * together; y < std::min(plane.size.y, (piece + 1) * together); ++y)
            readRow(reader, y);
        });
      },
      region.labels->places());
  return all;
}

} // namespace limn
