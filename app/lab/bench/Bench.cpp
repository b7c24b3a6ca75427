// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/bench/Bench.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace limn {

Scene turned(const Scene& scene, int index, int count) {
  Scene view = scene;
  if (index > 0)
    view.camera = orbited(scene.camera, 2.0 * M_PI * index / count, 0.0);
  return view;
}

std::optional<Scene> edited(const Scene& scene, int index) {
  const std::vector<ControlPoint>& points = scene.transferFunction.points;
  if (points.empty())
    return std::nullopt;
  const std::size_t middle = points.size() / 2;
  Scene changed = scene;
  changed.transferFunction = withPointMoved(scene.transferFunction, middle, points[middle].value,
                                            points[middle].opacity * (1.0 - 1e-3 * (index + 1)));
  return changed;
}

namespace {

// What a contender refused and the rows of others may be measured without.
bool isRefusal(const Error& error) {
  return error.kind() == Error::Kind::usage || error.kind() == Error::Kind::openGl;
}

// First picture and memory, or why there is none, which `refusal` then holds if it held nothing.
BenchRow firstRow(const std::string& name, const Scene& scene, Contender& contender,
                  const std::function<void()>& advance, std::exception_ptr& refusal) {
  BenchRow row;
  row.program = contender.program();
  row.scene = name;
  row.size = {scene.image.width, scene.image.height};
  row.stepVoxels = scene.quality.stepVoxels;
  try {
    const FrameCost first = contender.drawFirst(scene);
    row.firstMs = first.ms;
    row.firstCpuMs = first.cpuMs;
    advance();
    contender.draw(edited(scene, 0).value_or(scene));
    advance();
  } catch (const Error& error) {
    if (!isRefusal(error))
      throw;
    refusal = refusal ? refusal : std::current_exception();
    row.missing = error.what();
    return row;
  }
  row.peakMb = contender.peakMb();
  row.renderer = contender.renderer();
  row.effects = contender.effects(scene);
  return row;
}

} // namespace

std::vector<BenchRow> benchRows(const std::string& name, const Scene& scene,
                                const std::vector<std::unique_ptr<Contender>>& contenders, int frames,
                                const std::function<void()>& advance) {
  std::vector<BenchRow> rows;
  rows.reserve(contenders.size());
  std::exception_ptr refusal;
  for (const auto& contender : contenders)
    rows.push_back(firstRow(name, scene, *contender, advance, refusal));
  if (std::ranges::all_of(rows, [](const BenchRow& row) { return !row.missing.empty(); }))
    std::rethrow_exception(refusal);
  // Renderer after renderer for one scene.
  const auto drawInTurn = [&](const Scene& one,
                              const std::function<void(std::size_t, const FrameCost&)>& take) {
    for (std::size_t k = 0; k < contenders.size(); ++k)
      if (rows[k].missing.empty()) {
        take(k, contenders[k]->draw(one));
        advance();
      }
  };
  for (int i = 0; i < frames; ++i)
    drawInTurn(turned(scene, i, frames),
               [&](std::size_t k, const FrameCost& cost) { rows[k].views.push_back(cost); });
  std::vector<std::vector<FrameCost>> edits(contenders.size());
  for (int i = 0; i < frames; ++i)
    drawInTurn(edited(scene, i + 1).value_or(scene),
               [&](std::size_t k, const FrameCost& cost) { edits[k].push_back(cost); });
  if (edited(scene, 0))
    for (std::size_t k = 0; k < contenders.size(); ++k)
      if (rows[k].missing.empty())
        rows[k].editMs = timingOf(wallTimes(edits[k])).median;
  return rows;
}

} // namespace limn
