// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceLattice.h"

#include "scene/basics/Effort.h"

#include <atomic>
#include <cmath>

namespace limn {
namespace {

// A plane that lies nearer to voxel centres, in voxels, stands for them: cells would be too thin for
// triangles.
constexpr double thinnestCell = 0.003;

std::vector<double> placesBetween(double lower, double upper, int cells) {
  std::vector<double> places{lower, lower};
  for (double part = std::ceil((lower + thinnestCell) * cells); part < (upper - thinnestCell) * cells; ++part)
    places.push_back(part / cells);
  places.insert(places.end(), {upper, upper});
  return places;
}

bool isCentre(double at, int count) {
  return at == std::floor(at) && at >= 0.0 && at < count;
}

} // namespace

SurfaceLattice::SurfaceLattice(const Solid& solid, int cells) : m_solid(&solid), m_cells(cells) {
  for (int axis = 0; axis < 3; ++axis) {
    m_at[axis] = placesBetween(solid.lower()[axis], solid.upper()[axis], cells);
    m_dims[axis] = static_cast<int>(m_at[axis].size());
  }
}

std::vector<std::uint8_t> SurfaceLattice::marked(int firstLayer, int layers, const Effort& effort) const {
  const std::size_t width = m_dims.x;
  std::vector<std::uint8_t> marks(width * m_dims.y * layers, 0);
  forEachPiece(layers, effort, [&](int layer) {
    const int k = firstLayer + layer;
    if (isOutside(2, k))
      return;
    for (int j = 1; j + 1 < m_dims.y; ++j)
      markRow(j, k, marks.data() + (static_cast<std::size_t>(layer) * m_dims.y + j) * width);
  });
  return marks;
}

void SurfaceLattice::markRow(int j, int k, std::uint8_t* out) const {
  const glm::ivec3& voxels = m_solid->volume().grid().dims;
  const double y = m_at[1][j], z = m_at[2][k];
  const auto ask = [&](int i) { out[i] = m_solid->contains({m_at[0][i], y, z}) ? 1 : 0; };
  // Between the planes at which the crop ends, rows through centres are read as they are stored.
  const int between = m_dims.x - 4;
  if (m_cells == 1 && between > 0 && isCentre(y, voxels.y) && isCentre(z, voxels.z)) {
    ask(1);
    m_solid->markRow(static_cast<int>(m_at[0][2]), between, static_cast<int>(y), static_cast<int>(z),
                     out + 2);
    ask(m_dims.x - 2);
    return;
  }
  for (int i = 1; i + 1 < m_dims.x; ++i)
    ask(i);
}

std::uint64_t crossedEdges(const SurfaceLattice& lattice, const Effort& effort) {
  constexpr int layersEach = 16;
  const glm::ivec3& dims = lattice.dims();
  const std::size_t width = dims.x, area = width * dims.y;
  std::atomic<std::uint64_t> crossed = 0;
  Effort alone;
  alone.threads = 1;
  forEachPiece((dims.z - 1 + layersEach - 1) / layersEach, effort, [&](int piece) {
    const int first = piece * layersEach;
    const int layers = std::min(layersEach + 1, dims.z - first);
    const std::vector<std::uint8_t> marks = lattice.marked(first, layers, alone);
    // The outermost places are all outside, so that what has no neighbour crosses nothing.
    std::uint64_t here = 0;
    for (std::size_t i = 0; i < area * (layers - 1); ++i)
      here += (marks[i] != marks[i + 1]) + (marks[i] != marks[i + width]) + (marks[i] != marks[i + area]);
    crossed += here;
  });
  return crossed;
}

} // namespace limn
