// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/Cohort.h"

#include <algorithm>

namespace limn {
namespace {

// What a point brought in each scene.
struct Gathered {
  OperatingPoint point;
  std::vector<double> p99_9, mean, ms;
  std::string worst;
};

struct GatheredGroup {
  CohortGroup group;
  std::vector<Gathered> points;
};

void add(const MeasuredPoint& measured, const NamedReport& of, std::vector<Gathered>& points) {
  auto found = std::ranges::find(points, measured.point, &Gathered::point);
  if (found == points.end())
    found = points.insert(found, Gathered{measured.point, {}, {}, {}, {}});
  found->ms.push_back(measured.ms.median);
  if (!of.report.reference.converged)
    return;
  if (found->p99_9.empty() || measured.error.p99_9 > *std::ranges::max_element(found->p99_9))
    found->worst = of.name;
  found->p99_9.push_back(measured.error.p99_9);
  found->mean.push_back(measured.error.mean);
}

CohortPoint overScenes(const Gathered& gathered) {
  CohortPoint point;
  point.point = gathered.point;
  point.scenes = static_cast<int>(gathered.ms.size());
  point.ms = timingOf(gathered.ms);
  point.converged = static_cast<int>(gathered.p99_9.size());
  if (point.converged == 0)
    return point;
  const Timing errors = timingOf(gathered.p99_9); // a median and its ends, whatever is counted
  point.usualP99_9 = errors.median;
  point.worstP99_9 = errors.most;
  point.usualMean = timingOf(gathered.mean).median;
  point.worst = gathered.worst;
  return point;
}

} // namespace

std::vector<CohortGroup> cohortOf(const std::vector<NamedReport>& reports) {
  std::vector<GatheredGroup> groups;
  for (const NamedReport& one : reports) {
    auto found = std::ranges::find_if(groups, [&](const GatheredGroup& other) {
      return other.group.machine == one.report.machine && other.group.renderer == one.report.renderer;
    });
    if (found == groups.end())
      found = groups.insert(found, GatheredGroup{{one.report.machine, one.report.renderer, 0, {}}, {}});
    ++found->group.reports;
    for (const MeasuredPoint& point : one.report.points)
      add(point, one, found->points);
  }
  std::vector<CohortGroup> result;
  for (GatheredGroup& group : groups) {
    std::ranges::transform(group.points, std::back_inserter(group.group.points), overScenes);
    result.push_back(std::move(group.group));
  }
  return result;
}

} // namespace limn
