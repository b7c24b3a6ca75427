// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/times/CostModel.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limn {
namespace {

// Premultiplied RGBA in floats.
constexpr double bytesPerPixel = 16.0;

} // namespace

double imbalanceOf(const BrickRow& row) {
  return row.samples > 0.0 ? row.mostSamples * row.bricks / row.samples : 1.0;
}

std::optional<double> growthOf(const std::vector<ScaleRow>& rows, const std::string& program,
                               const std::function<double(const ScaleRow&)>& figureOf) {
  std::vector<const ScaleRow*> measured;
  for (const ScaleRow& row : rows)
    if (row.drawn.program == program && row.drawn.missing.empty() && figureOf(row) > 0.0)
      measured.push_back(&row);
  std::ranges::sort(measured, {}, [](const ScaleRow* row) { return row->edge; });
  if (measured.size() < 2 || measured.back()->edge == measured[measured.size() - 2]->edge)
    return std::nullopt;
  const ScaleRow& large = *measured.back();
  const ScaleRow& small = *measured[measured.size() - 2];
  return std::log(figureOf(large) / figureOf(small)) /
         (3.0 * std::log(static_cast<double>(large.edge) / small.edge));
}

CostFacts costFacts(const std::vector<BrickRow>& rows) {
  assert(!rows.empty());
  const BrickRow& row = *std::ranges::max_element(
      rows, {}, [](const BrickRow& one) { return std::pair(one.edge, one.bricks); });
  const double pixels = static_cast<double>(row.size.x) * row.size.y;
  const double voxels = std::pow(row.edge, 3.0);
  CostFacts facts;
  facts.samplesPerCpuSecond = row.cpuMs > 0.0 ? row.samples / (row.cpuMs / 1e3) : 0.0;
  facts.samplesPerPixelEdge = row.samples / (pixels * row.edge);
  facts.keptBytesPerVoxel = row.mostKeptMb * 1e6 / (voxels / row.bricks);
  facts.imbalance = imbalanceOf(row);
  return facts;
}

ManyNodes onManyNodes(const CostFacts& facts, const SupposedNodes& supposed, double voxels,
                      const glm::ivec2& size, double nodes) {
  const double pixels = static_cast<double>(size.x) * size.y;
  const double samples = facts.samplesPerPixelEdge * pixels * std::cbrt(voxels);
  const double imbalance = nodes > 1 ? facts.imbalance : 1.0;
  const double message = pixels * bytesPerPixel;
  ManyNodes result;
  result.nodes = nodes;
  result.voxelsEach = voxels / nodes;
  result.voxelGbEach = result.voxelsEach * supposed.bytesPerVoxel / 1e9;
  result.keptGbEach = result.voxelsEach * facts.keptBytesPerVoxel / 1e9;
  result.readSeconds = result.voxelsEach * supposed.bytesPerVoxel / supposed.diskBytesPerSecond;
  result.marchMs = 1e3 * imbalance * samples / (nodes * supposed.cores * facts.samplesPerCpuSecond);
  result.messageMb = message / 1e6;
  result.movedGb = (nodes - 1) * message / 1e9;
  result.compositeMs = 1e3 * std::ceil(std::log2(nodes)) * message / supposed.linkBytesPerSecond;
  return result;
}

double mostUsefulNodes(const CostFacts& facts, const SupposedNodes& supposed, double voxels,
                       const glm::ivec2& size) {
  constexpr double most = 1 << 24;
  const auto pictureMs = [&](double nodes) {
    const ManyNodes one = onManyNodes(facts, supposed, voxels, size, nodes);
    return one.marchMs + one.compositeMs;
  };
  double best = 1;
  for (double nodes = 2; nodes <= most; nodes *= 2)
    if (pictureMs(nodes) < pictureMs(best))
      best = nodes;
  return best;
}

} // namespace limn
