// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measure/bench/BrickBench.h"

#include "app/engines/ProcessCost.h"
#include "cpu/bricks/BrickRenderer.h"

#include <algorithm>

namespace limn {
namespace {

// Partial results are sent as premultiplied RGBA in floats.
constexpr double bytesPerPixel = 16.0;

BrickRow rowOf(int edge, const Scene& scene, int count, int threads) {
  const glm::ivec2 size(scene.image.width, scene.image.height);
  const Bricks bricks(scene.volume->grid(), scene.crop, count);
  BrickRow row;
  row.edge = edge;
  row.bricks = count;
  row.size = size;
  row.reducedMb = (count - 1) * bytesPerPixel * size.x * size.y / 1e6;
  for (int brick = 0; brick < count; ++brick) {
    BrickRenderer renderer(threads);
    renderer.begin(scene, size, bricks.box(brick));
    const FrameCost cost = costOf([&] { renderer.share({{0, 0}, size}); });
    const auto samples = static_cast<double>(renderer.samples());
    row.samples += samples;
    row.mostSamples = std::max(row.mostSamples, samples);
    row.cpuMs += cost.cpuMs;
    row.mostCpuMs = std::max(row.mostCpuMs, cost.cpuMs);
    row.mostKeptMb = std::max(row.mostKeptMb, renderer.memoryMb());
  }
  return row;
}

} // namespace

std::vector<BrickRow> brickRows(int edge, const Scene& scene, int most, int threads,
                                const std::function<void()>& advance) {
  std::vector<BrickRow> rows;
  for (int count = 1; count <= most; count *= 2) {
    rows.push_back(rowOf(edge, scene, count, threads));
    advance();
  }
  return rows;
}

} // namespace limn
