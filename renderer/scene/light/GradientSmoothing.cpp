// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientSmoothing.h"

#include "scene/light/Gradient.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace limn {
namespace {

// More neighbours than any axis has voxels that could be smoothed in a lifetime.
constexpr double mostNeighbours = 1e6;

// Pieces of work that are handed out together.
constexpr int piecesAtATime = 16;

// Columns that are smoothed along z together.
constexpr int mostColumns = 256;

// How many voxels away a Gaussian that is cut off at 3σ reaches. A product of thirds and tenths may fall
// short of the whole number that it is meant to be.
double neighboursReached(double sigmaMm, double spacingMm) {
  return sigmaMm > 0.0 ? std::min(3.0 * sigmaMm / spacingMm * (1.0 + 1e-12), mostNeighbours) : 0.0;
}

std::vector<float> weightsInFloats(const std::vector<double>& weights) {
  return {weights.begin(), weights.end()};
}

// Adds what `weights` make of the neighbours' differences from each of `count` numbers, so that what is
// constant stays so to the last bit. Those `n` places behind lie in `rowAt(n)`, those before in `rowAt(-n)`.
template <class RowAt>
void addNeighbours(int count, const std::vector<float>& weights, const RowAt& rowAt, float* sums) {
  const float* here = rowAt(0);
  std::copy(here, here + count, sums);
  for (int n = 1; n < static_cast<int>(weights.size()); ++n) {
    const float weight = weights[static_cast<std::size_t>(n)];
    const float* low = rowAt(-n);
    const float* high = rowAt(n);
    for (int i = 0; i < count; ++i)
      sums[i] += weight * ((low[i] - here[i]) + (high[i] - here[i]));
  }
}

} // namespace

std::vector<double> smoothingWeights(double sigmaMm, double spacingMm, int count) {
  std::vector<double> weights(static_cast<std::size_t>(neighboursReached(sigmaMm, spacingMm)) + 1);
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const double distance = static_cast<double>(n) * (spacingMm / sigmaMm);
    weights[n] = n == 0 ? 1.0 : std::exp(-0.5 * distance * distance);
  }
  const double sum = 2.0 * std::accumulate(weights.begin(), weights.end(), 0.0) - 1.0;
  for (double& weight : weights)
    weight /= sum;
  const auto most = static_cast<std::size_t>(std::max(count, 1));
  while (weights.size() > most) {
    if (most > 1)
      weights[most - 1] += weights.back();
    weights.pop_back();
  }
  if (most == 1)
    weights[0] = 1.0;
  return weights;
}

bool smoothsAnything(double sigmaMm, const Grid& grid) {
  for (int axis = 0; axis < 3; ++axis)
    if (grid.dims[axis] > 1 && neighboursReached(sigmaMm, grid.spacingMm[axis]) >= 1.0)
      return true;
  return false;
}

double smoothingOfSlices(const Grid& grid) {
  std::array<double, 3> spacings{grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z};
  std::ranges::sort(spacings);
  if (spacings[2] < 1.25 * spacings[1] || imageNormalAxis(grid))
    return 0.0;
  return std::min(0.7 * spacings[2], mostGradientSmoothing);
}

Smoothing::Smoothing(std::shared_ptr<const Volume> volume, double sigmaMm)
    : m_volume(std::move(volume)), m_sigmaMm(sigmaMm), m_dims(m_volume->grid().dims),
      m_scalars(m_volume->voxelCount(), m_volume->room()) {
  assert(!m_volume->part());
  for (int axis = 0; axis < 3; ++axis)
    m_weights[static_cast<std::size_t>(axis)] =
        weightsInFloats(smoothingWeights(sigmaMm, m_volume->grid().spacingMm[axis], m_dims[axis]));
  m_rowsPerPiece = std::clamp(voxelsPerPiece / m_dims.x, 1, m_dims.y);
  m_stripsPerSlice = (m_dims.y + m_rowsPerPiece - 1) / m_rowsPerPiece;
  m_columnsPerPiece = std::min(m_dims.x, mostColumns);
  m_piecesPerRow = (m_dims.x + m_columnsPerPiece - 1) / m_columnsPerPiece;
  m_across = m_stripsPerSlice * m_dims.z;
  m_pieces = m_across + m_piecesPerRow * m_dims.y;
  m_isDone.assign(static_cast<std::size_t>(m_pieces), 0);
}

double Smoothing::more(const Effort& effort) {
  if (m_smoothed)
    return 1.0;
  // Along z nothing begins before all is there.
  const int end = std::min(m_done + piecesAtATime, m_done < m_across ? m_across : m_pieces);
  forEachPiece(end - m_done, {effort.threads, effort.isCancelled, {}}, [&](int n) {
    const int piece = m_done + n;
    char& isDone = m_isDone[static_cast<std::size_t>(piece)];
    if (isDone != 0) // before it was cancelled
      return;
    if (piece < m_across)
      smoothAcross(piece);
    else
      smoothAlongZ(piece - m_across);
    isDone = 1;
  });
  m_done = end;
  if (effort.report)
    effort.report(static_cast<double>(m_done) / m_pieces);
  if (m_done < m_pieces)
    return static_cast<double>(m_done) / m_pieces;
  const ValueRange& range = m_volume->range();
  const double width = range.highest - range.lowest;
  m_smoothed = std::make_shared<const Volume>(m_volume->withScalars(
      StoredVoxels<float>(std::move(m_scalars)), {width > 0.0 ? width : 1.0, range.lowest}));
  m_scalars = {};
  return 1.0;
}

// Smooths some rows of a slice along x and y. Rows that several pieces reach are smoothed along x by each.
void Smoothing::smoothAcross(int piece) {
  const int k = piece / m_stripsPerSlice;
  const int first = piece % m_stripsPerSlice * m_rowsPerPiece;
  const int end = std::min(first + m_rowsPerPiece, m_dims.y);
  const int reachX = static_cast<int>(m_weights[0].size()) - 1;
  const int reachY = static_cast<int>(m_weights[1].size()) - 1;
  const int from = std::max(first - reachY, 0), to = std::min(end + reachY, m_dims.y);
  const auto width = static_cast<std::size_t>(m_dims.x);
  std::vector<float> padded(width + 2 * static_cast<std::size_t>(reachX));
  std::vector<float> alongX(width * static_cast<std::size_t>(to - from));
  const auto rowAt = [&](int j) {
    return alongX.data() + width * static_cast<std::size_t>(std::clamp(j, from, to - 1) - from);
  };
  float* inner = padded.data() + reachX;
  visitVoxels(*m_volume, [&](const auto& stored) {
    const Rescale& rescale = m_volume->rescale();
    const ValueRange& range = m_volume->range();
    const double span = range.highest > range.lowest ? range.highest - range.lowest : 1.0;
    for (int j = from; j < to; ++j) {
      const auto* voxels = &stored[voxelOffset(m_dims, 0, j, k)];
      for (int i = 0; i < m_dims.x; ++i)
        inner[i] = static_cast<float>(
            (rescale.slope * static_cast<double>(voxels[i]) + rescale.intercept - range.lowest) / span);
      std::fill(padded.data(), inner, inner[0]);
      std::fill(inner + m_dims.x, padded.data() + padded.size(), inner[m_dims.x - 1]);
      addNeighbours(
          m_dims.x, m_weights[0], [&](int n) { return inner + n; }, rowAt(j));
    }
  });
  for (int j = first; j < end; ++j)
    addNeighbours(
        m_dims.x, m_weights[1], [&](int n) { return rowAt(j + n); },
        &m_scalars[voxelOffset(m_dims, 0, j, k)]);
}

// Smooths some columns along z in their place.
void Smoothing::smoothAlongZ(int piece) {
  const int j = piece / m_piecesPerRow;
  const int first = piece % m_piecesPerRow * m_columnsPerPiece;
  const int count = std::min(m_columnsPerPiece, m_dims.x - first);
  if (m_weights[2].size() == 1)
    return;
  std::vector<float> columns(static_cast<std::size_t>(count) * m_dims.z);
  const auto rowAt = [&](int k) {
    return columns.data() + static_cast<std::size_t>(count) * std::clamp(k, 0, m_dims.z - 1);
  };
  for (int k = 0; k < m_dims.z; ++k) {
    const float* row = &m_scalars[voxelOffset(m_dims, first, j, k)];
    std::copy(row, row + count, rowAt(k));
  }
  for (int k = 0; k < m_dims.z; ++k)
    addNeighbours(
        count, m_weights[2], [&](int n) { return rowAt(k + n); },
        &m_scalars[voxelOffset(m_dims, first, j, k)]);
}

std::shared_ptr<const Volume> smoothedVolume(std::shared_ptr<const Volume> volume, double sigmaMm,
                                             const Effort& effort) {
  Smoothing smoothing(std::move(volume), sigmaMm);
  while (smoothing.more(effort) < 1.0) {
  }
  return smoothing.smoothed();
}

} // namespace limn
