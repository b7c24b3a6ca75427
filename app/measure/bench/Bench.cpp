// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measure/bench/Bench.h"

#include <cmath>

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

std::vector<BenchRow> benchRows(const std::string& name, const Scene& scene,
                                const std::vector<std::unique_ptr<Contender>>& contenders, int frames,
                                const std::function<void()>& advance) {
  std::vector<BenchRow> rows;
  const auto drawn = [&advance](const FrameCost& cost) {
    advance();
    return cost;
  };
  for (const auto& contender : contenders) {
    BenchRow row;
    row.firstMs = drawn(contender->drawFirst(scene)).ms;
    drawn(contender->draw(edited(scene, 0).value_or(scene)));
    row.peakMb = contender->peakMb();
    row.program = contender->program();
    row.renderer = contender->renderer();
    row.effects = contender->effects(scene);
    row.scene = name;
    row.size = {scene.image.width, scene.image.height};
    row.stepVoxels = scene.quality.stepVoxels;
    rows.push_back(row);
  }
  for (int i = 0; i < frames; ++i)
    for (std::size_t k = 0; k < contenders.size(); ++k)
      rows[k].views.push_back(drawn(contenders[k]->draw(turned(scene, i, frames))));
  std::vector<std::vector<FrameCost>> edits(contenders.size());
  for (int i = 0; i < frames; ++i)
    for (std::size_t k = 0; k < contenders.size(); ++k)
      edits[k].push_back(drawn(contenders[k]->draw(edited(scene, i + 1).value_or(scene))));
  if (edited(scene, 0))
    for (std::size_t k = 0; k < contenders.size(); ++k)
      rows[k].editMs = timingOf(wallTimes(edits[k])).median;
  return rows;
}

} // namespace limn
