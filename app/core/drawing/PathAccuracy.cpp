// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/PathAccuracy.h"

#include "accuracy/sweep/FigureText.h"
#include "app/core/drawing/PathDrawing.h"
#include "app/core/drawing/ProcessCost.h"
#include "app/core/drawing/RealRenderers.h"
#include "cpu/CpuRenderer.h"

#include <algorithm>

namespace limn {
namespace {

constexpr int fewestPathsMeasured = 4;
// So often at most whoever waits is told how far it is between two numbers of paths.
constexpr int mostPasses = 16;

// Where nothing is covered, nothing is off.
std::optional<ImageError> errorOf(const PathFigures& figures, const ErrorMap& map) {
  const bool isCovered = std::ranges::any_of(map.levels, [](float levels) { return levels >= 0.0f; });
  if (isCovered && !figures.rmsLevels)
    return std::nullopt;
  ImageError error;
  error.rms = figures.rmsLevels.value_or(0.0);
  error.p99_9 = figures.p99_9Levels.value_or(0.0);
  error.mean = figures.meanLevels;
  error.largest = figures.largestLevels;
  error.shareOverOne = figures.shareOverOne;
  return error;
}

Scene withPaths(Scene scene, int paths) {
  scene.quality.paths = paths;
  return scene;
}

// One picture that gets more and more paths.
class Following {
public:
  Following(const Scene& scene, const glm::ivec2& size, const Effort& effort, int most,
            const ReportProgress& progress)
      : m_renderer(effort.threads), m_scene(scene), m_size(size), m_isCancelled(effort.isCancelled),
        m_most(most), m_progress(progress) {
    m_renderer.makeReady(scene, {effort.threads, effort.isCancelled, {}});
  }

  const CpuRenderer& renderer() const { return m_renderer; }

  // In passes of `fewest` paths at least.
  void to(int paths, int fewest) {
    const int pass = std::max(fewest, (paths - m_paths + mostPasses - 1) / mostPasses);
    while (m_paths < paths) {
      const int next = std::min(paths, m_paths + pass);
      if (m_progress)
        m_progress(double(m_paths) / m_most, Message::tr("Following %1 paths a pixel").arg(paths));
      m_renderer.draw(withPaths(m_scene, next), m_size, {{0, 0}, m_size}, m_isCancelled);
      m_paths = next;
    }
  }

  PathErrors errors() const {
    const Scene drawn = withPaths(m_scene, m_paths);
    const ErrorMap map{m_size, m_renderer.pathErrors(drawn, m_size)};
    return {errorOf(*m_renderer.pathFigures(drawn, m_size), map), map};
  }

private:
  CpuRenderer m_renderer;
  const Scene& m_scene;
  glm::ivec2 m_size;
  std::function<bool()> m_isCancelled;
  int m_most, m_paths = 0;
  const ReportProgress& m_progress;
};

} // namespace

AccuracyReport measurePaths(const std::string& name, const Scene& scene, const glm::ivec2& size,
                            int mostPathsMeasured, const Effort& effort, const ReportProgress& progress) {
  requireMemoryForPaths(size);
  Following following(scene, size, effort, mostPathsMeasured, progress);
  AccuracyReport report = reportOn(name, following.renderer().name(), scene, size);
  report.reference.converged = report.reference.isByChance = true;
  double ms = 0.0;
  for (int paths = fewestPathsMeasured; paths <= mostPathsMeasured; paths *= 2) {
    ms += costOf([&] { following.to(paths, fewestPathsMeasured); }).ms;
    MeasuredPoint point;
    point.point.paths = paths;
    point.point.stepVoxels = scene.quality.stepVoxels;
    point.error = following.errors().error.value_or(ImageError{});
    point.ms = {ms, ms, ms};
    report.points.push_back(point);
  }
  for (MeasuredPoint& point : report.points)
    point.peakMb = following.renderer().memoryMb();
  findOrders(report.points);
  markPareto(report.points);
  if (const Message law = lawOfPaths(report.points); !law.empty())
    report.remarks.push_back(law.english());
  return report;
}

PathErrors pathErrors(const Scene& scene, const glm::ivec2& size, const Effort& effort,
                      const ReportProgress& progress) {
  const int paths = std::max(1, scene.quality.paths.value_or(pathsOf(scene.shading.physical.until)));
  requireMemoryForPaths(size);
  Following following(scene, size, effort, paths, progress);
  following.to(paths, 1);
  return following.errors();
}

} // namespace limn
