// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Pyramid.h"

#include "scene/basics/Effort.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <type_traits>

namespace limn {
namespace {

// Voxels of a volume along one axis, and fewer that fill the same length. Each of the fewer stands for a
// cell of whole voxels.
class CoarseAxis {
public:
  /// `coarse` is 1 … `fine`.
  CoarseAxis(int fine, int coarse);

  /// A place between two centres of voxels of either kind, or on the first of them.
  struct Place {
    int fine = 0;            ///< the voxel at or before it
    float fineWeight = 0.0f; ///< of the one behind that
    int coarse = 0;          ///< likewise
    float coarseWeight = 0.0f;
  };

  /// All centres of either kind, from the first voxel's to the last one's. Between two of them both fields
  /// are linear.
  const std::vector<Place>& places() const { return m_places; }

  /// The first voxel of a cell; of one more than there are cells: the end.
  int cellBegin(int cell) const;

  /// The voxel behind one; the last has itself.
  int behind(int fine) const { return fine + 1 < m_fine ? fine + 1 : fine; }
  int behindCoarse(int coarse) const { return coarse + 1 < m_coarse ? coarse + 1 : coarse; }

private:
  Place placeAt(double index) const;

  int m_fine, m_coarse;
  std::vector<Place> m_places;
};

CoarseAxis::CoarseAxis(int fine, int coarse) : m_fine(fine), m_coarse(coarse) {
  std::vector<double> centres;
  centres.reserve(static_cast<std::size_t>(fine) + static_cast<std::size_t>(coarse));
  for (int i = 0; i < fine; ++i)
    centres.push_back(i);
  const double each = static_cast<double>(fine) / coarse;
  for (int i = 0; i < coarse; ++i)
    centres.push_back((i + 0.5) * each - 0.5);
  std::ranges::sort(centres);
  centres.erase(std::unique(centres.begin(), centres.end()), centres.end());
  m_places.reserve(centres.size());
  for (const double centre : centres)
    m_places.push_back(placeAt(centre));
}

int CoarseAxis::cellBegin(int cell) const {
  return static_cast<int>(std::int64_t{cell} * m_fine / m_coarse);
}

// Beyond the outermost centres a field is constant.
CoarseAxis::Place CoarseAxis::placeAt(double index) const {
  const double each = static_cast<double>(m_fine) / m_coarse;
  const double coarse = std::clamp((index + 0.5) / each - 0.5, 0.0, m_coarse - 1.0);
  const auto partOf = [](double at) { return static_cast<float>(at - std::floor(at)); };
  return {static_cast<int>(index), partOf(index), static_cast<int>(coarse), partOf(coarse)};
}

// A field in fewer voxels, made slab after slab, and how far it lies from the one that it stands for.
// Between the centres of voxels of either both are trilinear, so their difference is largest where such
// centres cross: there, and nowhere else, they are compared.
template <class T>
class CoarseField {
public:
  /// `range`: of the stored numbers.
  CoarseField(const StoredVoxels<T>& stored, const ValueRange& range, const glm::ivec3& dims,
              const glm::ivec3& coarseDims)
      : m_stored(stored), m_range(range),
        m_middle(static_cast<D>(std::round(0.5 * (range.lowest + range.highest)))), m_dims(dims),
        m_coarseDims(coarseDims), m_x(dims.x, coarseDims.x), m_y(dims.y, coarseDims.y),
        m_z(dims.z, coarseDims.z),
        m_voxels(static_cast<std::size_t>(coarseDims.x) * coarseDims.y * coarseDims.z) {}

  const glm::ivec3& dims() const { return m_coarseDims; }

  /// Takes the slices in before `end`. Throws Cancelled.
  void takeSlices(int end, const Effort& effort) {
    int made = m_made;
    while (made < m_coarseDims.z && m_z.cellBegin(made + 1) <= end)
      ++made;
    average(m_made, made, partOf(effort, 0.0, 0.3));
    m_made = made;
    const std::vector<CoarseAxis::Place>& places = m_z.places();
    std::size_t known = m_compared;
    while (known < places.size() && m_z.behind(places[known].fine) < end &&
           m_z.behindCoarse(places[known].coarse) < made)
      ++known;
    compare(m_compared, known, partOf(effort, 0.3, 1.0));
    m_compared = known;
  }

  /// Of all slices taken in: the largest difference of stored numbers anywhere, with room for its own
  /// rounding.
  double largestDifference() const { return m_largest + 0x1p-19 * (m_range.highest - m_range.lowest); }

  std::vector<T> takeVoxels() { return std::move(m_voxels); }

private:
  // In what numbers are compared: 8 and 16 bits fit in a float.
  using D = std::conditional_t<sizeof(T) <= 2, float, double>;
  using Sum = std::conditional_t<std::is_floating_point_v<T>, double, std::int64_t>;

  void average(int from, int to, const Effort& effort) {
    const int rows = (to - from) * m_coarseDims.y;
    shareOut(rows, effort, [&](Pieces& pieces) {
      std::vector<Sum> sums(static_cast<std::size_t>(m_dims.x));
      for (int row = pieces.next(); row >= 0; row = pieces.next())
        averageRow(row % m_coarseDims.y, from + row / m_coarseDims.y, sums);
    });
  }

  void averageRow(int j, int k, std::vector<Sum>& sums) {
    std::ranges::fill(sums, Sum{0});
    for (int z = m_z.cellBegin(k); z < m_z.cellBegin(k + 1); ++z)
      for (int y = m_y.cellBegin(j); y < m_y.cellBegin(j + 1); ++y) {
        const T* row = m_stored.data() + voxelOffset(m_dims, 0, y, z);
        for (std::size_t x = 0; x < sums.size(); ++x)
          sums[x] += static_cast<Sum>(row[x]);
      }
    const double rows = static_cast<double>(m_z.cellBegin(k + 1) - m_z.cellBegin(k)) *
                        (m_y.cellBegin(j + 1) - m_y.cellBegin(j));
    T* out = &m_voxels[voxelOffset(m_coarseDims, 0, j, k)];
    for (int i = 0; i < m_coarseDims.x; ++i) {
      Sum sum{0};
      for (int x = m_x.cellBegin(i); x < m_x.cellBegin(i + 1); ++x)
        sum += sums[static_cast<std::size_t>(x)];
      const double mean = static_cast<double>(sum) / (rows * (m_x.cellBegin(i + 1) - m_x.cellBegin(i)));
      out[i] = static_cast<T>(std::is_floating_point_v<T> ? mean : std::round(mean));
    }
  }

  // At the places `from` … `to`-1 along z.
  void compare(std::size_t from, std::size_t to, const Effort& effort) {
    const RowPieces rows({m_dims.x, static_cast<int>(m_y.places().size()), static_cast<int>(to - from)},
                         placesEach);
    std::mutex mutex;
    shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
      // One more than there are voxels: the last has nothing behind it.
      std::vector<D> fine(static_cast<std::size_t>(m_dims.x) + 1);
      std::vector<D> coarse(static_cast<std::size_t>(m_coarseDims.x) + 1);
      D largest = 0;
      for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
        rows.forEachRow(piece, [&](int y, int z) {
          largest =
              std::max(largest, compareRow(m_y.places()[static_cast<std::size_t>(y)],
                                           m_z.places()[from + static_cast<std::size_t>(z)], fine, coarse));
        });
      const std::lock_guard lock(mutex);
      m_largest = std::max(m_largest, static_cast<double>(largest));
    });
  }

  D compareRow(const CoarseAxis::Place& y, const CoarseAxis::Place& z, std::vector<D>& fine,
               std::vector<D>& coarse) const {
    mixRows(m_stored.data(), m_dims, {y.fine, m_y.behind(y.fine), y.fineWeight},
            {z.fine, m_z.behind(z.fine), z.fineWeight}, fine);
    mixRows(m_voxels.data(), m_coarseDims, {y.coarse, m_y.behindCoarse(y.coarse), y.coarseWeight},
            {z.coarse, m_z.behindCoarse(z.coarse), z.coarseWeight}, coarse);
    D largest = 0;
    for (const CoarseAxis::Place& x : m_x.places()) {
      const D* here = &fine[static_cast<std::size_t>(x.fine)];
      const D* there = &coarse[static_cast<std::size_t>(x.coarse)];
      const D a = here[0] + static_cast<D>(x.fineWeight) * (here[1] - here[0]);
      const D b = there[0] + static_cast<D>(x.coarseWeight) * (there[1] - there[0]);
      largest = std::max(largest, std::abs(a - b));
    }
    return largest;
  }

  // A row between two along an axis.
  struct Between {
    int first, second;
    float weight; // of the second
  };

  void mixRows(const T* voxels, const glm::ivec3& dims, const Between& y, const Between& z,
               std::vector<D>& mixed) const {
    std::ranges::fill(mixed, D{0});
    const auto add = [&](int j, int k, float weight) {
      if (weight == 0.0f)
        return;
      const T* row = voxels + voxelOffset(dims, 0, j, k);
      const auto share = static_cast<D>(weight);
      D* out = mixed.data();
      for (int x = 0; x < dims.x; ++x)
        out[x] += share * (static_cast<D>(row[x]) - m_middle);
    };
    add(y.first, z.first, (1.0f - y.weight) * (1.0f - z.weight));
    add(y.second, z.first, y.weight * (1.0f - z.weight));
    add(y.first, z.second, (1.0f - y.weight) * z.weight);
    add(y.second, z.second, y.weight * z.weight);
    mixed.back() = mixed[mixed.size() - 2];
  }

  static constexpr int placesEach = 4; // what a voxel costs, in those that are merely read

  const StoredVoxels<T>& m_stored;
  ValueRange m_range;
  D m_middle; // numbers are compared by how far they lie from it
  glm::ivec3 m_dims, m_coarseDims;
  CoarseAxis m_x, m_y, m_z;
  std::vector<T> m_voxels;
  int m_made = 0;             // coarse slices
  std::size_t m_compared = 0; // places along z
  double m_largest = 0.0;
};

constexpr int usualReductions[] = {2, 4, 8};

// Slabs of so many voxels: what is averaged is still at hand when it is compared.
constexpr std::int64_t slabVoxels = std::int64_t{1} << 21;

glm::ivec3 reducedDims(const glm::ivec3& dims, int reduction) {
  return (dims + reduction - 1) / reduction;
}

std::uint64_t voxelsOf(const glm::ivec3& dims) {
  return static_cast<std::uint64_t>(dims.x) * static_cast<std::uint64_t>(dims.y) *
         static_cast<std::uint64_t>(dims.z);
}

std::vector<int> reductionsWithin(const glm::ivec3& dims, std::uint64_t mostVoxels) {
  std::vector<int> reductions;
  for (const int reduction : usualReductions)
    if (voxelsOf(reducedDims(dims, reduction)) <= mostVoxels)
      reductions.push_back(reduction);
  int reduction = usualReductions[std::size(usualReductions) - 1];
  while (reductions.empty()) {
    reduction *= 2;
    const glm::ivec3 coarse = reducedDims(dims, reduction);
    if (voxelsOf(coarse) <= mostVoxels || coarse == glm::ivec3(1))
      reductions.push_back(reduction);
  }
  return reductions;
}

// Of the numbers as they are stored.
ValueRange storedRange(const Volume& volume) {
  if (volume.rescale().slope == 0.0)
    return {};
  const auto stored = [&rescale = volume.rescale()](double scalar) {
    return (scalar - rescale.intercept) / rescale.slope;
  };
  const double a = stored(volume.range().lowest), b = stored(volume.range().highest);
  return {std::min(a, b), std::max(a, b)};
}

template <class T>
std::vector<CoarseVolume> pyramidAs(const Volume& volume, const StoredVoxels<T>& stored,
                                    const std::vector<int>& reductions, const Effort& effort) {
  const glm::ivec3 dims = volume.grid().dims;
  std::vector<CoarseField<T>> fields;
  fields.reserve(reductions.size());
  for (const int reduction : reductions)
    fields.emplace_back(stored, storedRange(volume), dims, reducedDims(dims, reduction));
  const auto slices =
      static_cast<int>(std::clamp<std::int64_t>(slabVoxels / (std::int64_t{dims.x} * dims.y), 1, dims.z));
  for (int end = 0; end < dims.z;) {
    const double from = static_cast<double>(end) / dims.z;
    end = std::min(end + slices, dims.z);
    const double share = (static_cast<double>(end) / dims.z - from) / static_cast<double>(fields.size());
    for (std::size_t n = 0; n < fields.size(); ++n)
      fields[n].takeSlices(end, partOf(effort, from + share * static_cast<double>(n),
                                       from + share * static_cast<double>(n + 1)));
  }
  const ValueRange& range = volume.range();
  const double perValue = range.highest > range.lowest ? 1.0 / (range.highest - range.lowest) : 0.0;
  std::vector<CoarseVolume> levels;
  for (std::size_t n = 0; n < fields.size(); ++n) {
    const double error = fields[n].largestDifference() * std::abs(volume.rescale().slope) * perValue;
    levels.push_back(
        {std::make_shared<const Volume>(withVoxels(volume.grid(), fields[n].dims()), fields[n].takeVoxels(),
                                        volume.rescale(), std::nullopt, volume.info(),
                                        Effort{effort.threads, effort.isCancelled, {}}),
         reductions[n], error});
  }
  return levels;
}

} // namespace

Grid withVoxels(const Grid& grid, const glm::ivec3& dims) {
  const glm::dvec3 each = glm::dvec3(grid.dims) / glm::dvec3(dims);
  Grid other = grid;
  other.dims = dims;
  other.spacingMm = grid.spacingMm * each;
  other.originMm = indexToWorld(grid, 0.5 * (each - 1.0));
  return other;
}

std::vector<CoarseVolume> pyramidOf(const Volume& volume, std::uint64_t mostBytes, const Effort& effort) {
  return visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
    return pyramidAs(volume, stored, reductionsWithin(volume.grid().dims, mostBytes / sizeof(T)), effort);
  });
}

} // namespace limn
