// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/PathDrawing.h"

#include "scene/ProjectionFacts.h"
#include "scene/basics/Error.h"
#include "scene/basics/MemoryBudget.h"
#include "scene/effects/EffectPlan.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace limn {
namespace {

constexpr int pathsAtFirst = 4;

// A pass that takes longer than there is time is not done before it ends.
constexpr double almostAll = 0.99;

// On the way to a number of paths so much of it is followed at once: between passes it is told how far it is.
constexpr int mostOfAll = 16;

// Where nothing has an error to tell, so many paths show that there is nothing to wait for.
constexpr int pathsOfNothing = 64;

int pathsGrownTo(double wanted, int paths) {
  const double most = std::min(2.0 * paths, double(mostPaths));
  return static_cast<int>(std::clamp(std::ceil(wanted), std::min(paths + 1.0, most), most));
}

// Of the way to the end, 0..1.
double wayTo(const Until& until, const PathFigures& figures, double seconds) {
  if (const auto* paths = std::get_if<UntilPaths>(&until))
    return std::min(1.0, double(figures.paths) / paths->paths);
  if (const auto* time = std::get_if<UntilSeconds>(&until))
    return std::min(1.0, seconds / time->seconds);
  const double wanted = std::get<UntilLevels>(until).levels;
  // The work left falls as the square of the error.
  return figures.rmsLevels ? std::min(1.0, std::pow(wanted / std::max(*figures.rmsLevels, 1e-9), 2.0)) : 0.0;
}

Message levelsOfError(double levels) {
  return levels < 10.0 ? Message::rounded(levels, 2) : Message::fixed(levels, 0);
}

} // namespace

int nextPaths(const Until& until, const PathFigures& figures, double seconds) {
  const int paths = figures.paths;
  if (const auto* wanted = std::get_if<UntilPaths>(&until))
    return paths >= wanted->paths
               ? paths
               : std::min(wanted->paths,
                          paths + std::max(pathsAtFirst, std::min(paths, wanted->paths / mostOfAll)));
  if (paths == 0)
    return pathsAtFirst;
  if (const auto* time = std::get_if<UntilSeconds>(&until)) {
    const double left = (time->seconds - seconds) * paths / std::max(seconds, 1e-6);
    return left < 1.0 ? paths : pathsGrownTo(std::floor(paths + left), paths);
  }
  if (!figures.rmsLevels)
    return paths >= pathsOfNothing ? paths : 2 * paths;
  const double ratio = *figures.rmsLevels / std::get<UntilLevels>(until).levels;
  // A little more than the law says, or chance would ask for one pass more.
  return ratio <= 1.0 || paths >= mostPaths ? paths : pathsGrownTo(1.02 * ratio * ratio * paths, paths);
}

void requireMemoryForPaths(const glm::ivec2& size, bool filtersNoise) {
  const double needed =
      double(size.x) * size.y * double(sizeof(cpu::PixelPaths) + (filtersNoise ? cpu::filterBytes : 0));
  const std::optional<std::uint64_t> free = freeMemory();
  if (!free || needed <= static_cast<double>(*free))
    return;
  throw Error(
      Error::Kind::other,
      Message::tr("A picture of physical light of %1 × %2 pixels keeps %3 GB of what its paths find, and "
                  "%4 GB of memory are free; choose a smaller one or close other programs.")
          .arg(size.x)
          .arg(size.y)
          .arg(Message::fixed(1e-9 * needed, 1), Message::fixed(1e-9 * static_cast<double>(*free), 1)));
}

DrawnByPaths drawnByPaths(CpuRenderer& renderer, const Scene& scene, const glm::ivec2& size,
                          const Effort& effort) {
  const Until until =
      scene.quality.paths ? Until(UntilPaths{*scene.quality.paths}) : scene.shading.physical.until;
  const auto begin = std::chrono::steady_clock::now();
  const bool filters = scene.shading.physical.filtersNoise;
  requireMemoryForPaths(size, filters);
  const double share = filters ? shareOfPaths : 1.0;
  const auto secondsSoFar = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  // Time goes on within a pass, too, of which the first may take all of it.
  const auto isCancelled = [&] {
    if (const auto* time = std::get_if<UntilSeconds>(&until); time && effort.report)
      effort.report(share * std::min(almostAll, secondsSoFar() / time->seconds));
    return effort.isCancelled && effort.isCancelled();
  };
  Scene pass = scene;
  pass.quality.paths.reset();
  DrawnByPaths drawn;
  for (int next = nextPaths(until, {}, 0.0); next > drawn.figures.paths;) {
    pass.shading.physical.until = UntilPaths{next};
    drawn.image = renderer.draw(pass, size, {{0, 0}, size}, isCancelled);
    drawn.figures = *renderer.pathFigures(pass, size);
    // A picture without anything to see has them all at once.
    drawn.figures.paths = next;
    drawn.seconds = secondsSoFar();
    if (effort.report)
      effort.report(share * wayTo(until, drawn.figures, drawn.seconds));
    next = nextPaths(until, drawn.figures, drawn.seconds);
  }
  drawn.radiance = *renderer.radiance(pass, size);
  if (filters) {
    cpu::FilteredPaths filtered = *renderer.withoutNoise(pass, size, partOf(effort, shareOfPaths, 1.0));
    drawn.image = std::move(filtered.image);
    drawn.figures = {.paths = drawn.figures.paths,
                     .rmsLevels = filtered.rmsLevels,
                     .p99_9Levels = {},
                     .filtered = filtered.figures};
  }
  return drawn;
}

Message sentenceOf(const PathFigures& figures) {
  if (figures.filtered && figures.filtered->largestChange == 0.0)
    return Message::tr("The picture has %1 paths a pixel, too few to filter their noise.").arg(figures.paths);
  if (figures.filtered && !figures.rmsLevels)
    return Message::tr(
               "The noise of %1 paths a pixel was filtered, which changed colours by %2 levels RMS, by %3 "
               "at most; they are too few to tell what error is left.")
        .arg(figures.paths)
        .arg(levelsOfError(figures.filtered->rmsChange), levelsOfError(figures.filtered->largestChange));
  if (figures.filtered)
    return Message::tr(
               "The picture lies within about %1 levels RMS of the exact one, after %2 paths a pixel whose "
               "noise was filtered: that changed colours by %3 levels RMS, by %4 at most, and was judged "
               "by paths that the filter did not see.")
        .arg(levelsOfError(*figures.rmsLevels))
        .arg(figures.paths)
        .arg(levelsOfError(figures.filtered->rmsChange), levelsOfError(figures.filtered->largestChange));
  if (!figures.rmsLevels || !figures.p99_9Levels)
    return Message::tr("The picture has %1 paths a pixel, too few to tell its error.").arg(figures.paths);
  return Message::tr("The picture lies within %1 levels RMS of the exact one, 99.9 % of its colours "
                     "within %2 (standard error), after %3 paths a pixel.")
      .arg(levelsOfError(*figures.rmsLevels), levelsOfError(*figures.p99_9Levels))
      .arg(figures.paths);
}

PictureAccuracy accuracyOf(const PathFigures& figures) {
  AccuracyOfPaths paths{figures.paths, figures.rmsLevels, {}, {}};
  if (const std::optional<NoiseFigures>& filtered = figures.filtered) {
    paths.filterRms = filtered->rmsChange;
    paths.filterLargest = filtered->largestChange;
  }
  return {figures.p99_9Levels, sentenceOf(figures).english(), paths};
}

PictureAccuracy accuracyOf(const std::vector<PathFigures>& pictures) {
  // Nothing is as far off as what nobody knows.
  const auto off = [](const PathFigures& figures) { return figures.rmsLevels.value_or(255.0); };
  return accuracyOf(*std::ranges::max_element(pictures, {}, off));
}

std::vector<Message> notesOf(const PathFigures& figures, const Scene& scene) {
  std::vector<Message> notes{sentenceOf(figures)};
  if (fogShows(scene))
    notes.push_back(Message::tr("Physical light knows no fog: it was left out."));
  if (showsSurface(scene.projection))
    notes.push_back(
        Message::tr("Physical light knows no surface of one value: tissue is shown as the curve says."));
  return notes;
}

} // namespace limn
