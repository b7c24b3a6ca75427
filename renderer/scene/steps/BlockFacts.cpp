// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/BlockFacts.h"

#include "scene/light/Gradient.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace limn {
namespace {

// In what the differences of stored numbers are computed: exactly, of 8 and 16 bits in float.
template <class T>
using Difference = std::conditional_t<sizeof(T) <= 2, float, double>;

// What a row of blocks along x gathers of the voxels on and in it, first for each place along x and then for
// each block: compilers make vector instructions of the loops over places.
template <class T>
class RowGatherer {
public:
  RowGatherer(const Volume& volume, const StoredVoxels<T>& stored)
      : m_stored(stored), m_dims(volume.grid().dims), m_spacing(volume.grid().spacingMm),
        m_rescale(volume.rescale()), m_smallest(smallestSpacingMm(volume.grid())),
        m_columns(static_cast<std::size_t>(m_dims.x)), m_padded(m_columns.lowest.size() + 2),
        m_rows(m_padded * perEdge * perEdge) {
    for (int axis = 0; axis < 3; ++axis) {
      const double share = m_smallest / m_spacing[axis];
      m_weight[axis] = static_cast<D>(share * share);
    }
  }

  /// Writes the facts of the blocks (0 … count-1, j, k).
  void gather(int j, int k, int count, FieldFacts* facts) {
    const glm::ivec2 first = glm::ivec2(j, k) * factCells;
    const glm::ivec2 last = glm::min(first + factCells, glm::ivec2(m_dims.y, m_dims.z) - 1);
    for (int z = first.y - 1; z <= last.y + 1; ++z)
      for (int y = first.x - 1; y <= last.x + 1; ++y)
        convert(y, z, rowAt(y - first.x, z - first.y));
    m_columns.clear();
    for (int z = first.y; z <= last.y; ++z)
      for (int y = first.x; y <= last.x; ++y)
        add(y - first.x, z - first.y, y < last.x, z < last.y);
    for (int i = 0; i < count; ++i)
      facts[i] = finished(i * factCells);
  }

private:
  using D = Difference<T>;

  static constexpr int perEdge = factCells + 3; // the voxels on the faces, and one beyond each

  // What is gathered at each place along x.
  struct Columns {
    explicit Columns(std::size_t size)
        : lowest(size), highest(size), alongX(size), alongY(size), alongZ(size), bend(size) {}

    void clear() {
      std::ranges::fill(lowest, std::numeric_limits<D>::infinity());
      std::ranges::fill(highest, -std::numeric_limits<D>::infinity());
      for (std::vector<D>* one : {&alongX, &alongY, &alongZ, &bend})
        std::ranges::fill(*one, D{0});
    }

    std::vector<D> lowest, highest;
    std::vector<D> alongX, alongY, alongZ; // the steepest change to the next voxel
    std::vector<D> bend;                   // squared, by the square of the smallest spacing
  };

  // Of the row of voxels beside the first one of the blocks.
  D* rowAt(int y, int z) {
    return &m_rows[static_cast<std::size_t>((z + 1) * perEdge + y + 1) * m_padded + 1];
  }

  // Beyond the outermost centres the field is constant.
  void convert(int y, int z, D* row) {
    const T* voxels =
        &m_stored[voxelOffset(m_dims, 0, std::clamp(y, 0, m_dims.y - 1), std::clamp(z, 0, m_dims.z - 1))];
    for (int x = 0; x < m_dims.x; ++x)
      row[x] = static_cast<D>(voxels[x]);
    row[-1] = row[0];
    row[m_dims.x] = row[m_dims.x - 1];
  }

  void add(int y, int z, bool hasNextY, bool hasNextZ) {
    const D* here = rowAt(y, z);
    const D* below = rowAt(y - 1, z);
    const D* above = rowAt(y + 1, z);
    const D* before = rowAt(y, z - 1);
    const D* behind = rowAt(y, z + 1);
    const D countsY = hasNextY ? D{1} : D{0}, countsZ = hasNextZ ? D{1} : D{0};
    const glm::vec<3, D> weight = m_weight;
    D* __restrict lowest = m_columns.lowest.data();
    D* __restrict highest = m_columns.highest.data();
    D* __restrict alongX = m_columns.alongX.data();
    D* __restrict alongY = m_columns.alongY.data();
    D* __restrict alongZ = m_columns.alongZ.data();
    D* __restrict bend = m_columns.bend.data();
    for (int x = 0; x < m_dims.x; ++x) {
      const D value = here[x];
      const D right = here[x + 1] - value, up = above[x] - value, on = behind[x] - value;
      const D bentX = (right - (value - here[x - 1])) * weight.x;
      const D bentY = (up - (value - below[x])) * weight.y;
      const D bentZ = (on - (value - before[x])) * weight.z;
      const D squares = bentX * bentX + bentY * bentY + bentZ * bentZ;
      lowest[x] = value < lowest[x] ? value : lowest[x];
      highest[x] = value > highest[x] ? value : highest[x];
      const D x1 = std::abs(right), y1 = std::abs(up) * countsY, z1 = std::abs(on) * countsZ;
      alongX[x] = x1 > alongX[x] ? x1 : alongX[x];
      alongY[x] = y1 > alongY[x] ? y1 : alongY[x];
      alongZ[x] = z1 > alongZ[x] ? z1 : alongZ[x];
      bend[x] = squares > bend[x] ? squares : bend[x];
    }
  }

  // Of the block whose first voxel is at x.
  FieldFacts finished(int x) const {
    const auto first = static_cast<std::size_t>(x);
    const auto last = static_cast<std::size_t>(std::min(x + factCells, m_dims.x - 1));
    D lowest = m_columns.lowest[first], highest = m_columns.highest[first], bend = m_columns.bend[first];
    glm::vec<3, D> steepest(0, m_columns.alongY[first], m_columns.alongZ[first]);
    for (std::size_t n = first + 1; n <= last; ++n) {
      lowest = std::min(lowest, m_columns.lowest[n]);
      highest = std::max(highest, m_columns.highest[n]);
      bend = std::max(bend, m_columns.bend[n]);
      steepest = glm::max(steepest, {m_columns.alongX[n - 1], m_columns.alongY[n], m_columns.alongZ[n]});
    }
    const double slope = std::abs(m_rescale.slope);
    const double a = m_rescale.slope * double(lowest) + m_rescale.intercept;
    const double b = m_rescale.slope * double(highest) + m_rescale.intercept;
    return {{std::min(a, b), std::max(a, b)},
            slope * glm::length(glm::dvec3(steepest) / m_spacing),
            slope * (std::sqrt(double(bend)) / (m_smallest * m_smallest))};
  }

  const StoredVoxels<T>& m_stored;
  glm::ivec3 m_dims;
  glm::dvec3 m_spacing;
  Rescale m_rescale;
  double m_smallest;
  glm::vec<3, D> m_weight; // of a second difference along each axis
  Columns m_columns;
  std::size_t m_padded; // voxels of a row with one more at each end
  std::vector<D> m_rows;
};

} // namespace

BlockFacts blockFacts(const Volume& volume, const Effort& effort) {
  BlockFacts result;
  result.range = volume.range();
  result.commonPerMm = steepness(volume);
  const glm::ivec3 cells = glm::max(volume.grid().dims - 1, glm::ivec3(1));
  const glm::ivec3 blocks = result.blocks = (cells + factCells - 1) / factCells;
  result.facts =
      RoomVector<FieldFacts>(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z, volume.room());
  const RowPieces rows(blocks, factCells * factCells * factCells);
  visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
    shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
      RowGatherer<T> gatherer(volume, stored);
      for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
        rows.forEachRow(piece, [&](int j, int k) {
          gatherer.gather(j, k, blocks.x, &result.facts[voxelOffset(blocks, 0, j, k)]);
        });
    });
  });
  return result;
}

} // namespace limn
