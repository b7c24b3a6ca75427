// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceMaker.h"

#include "io/surfaces/Decimation.h"
#include "io/surfaces/Extraction.h"
#include "io/surfaces/SurfaceNormals.h"
#include "scene/basics/Error.h"

#include <algorithm>

namespace limn {
namespace {

// Of a triangle, with its half of a point: 124 and 182 were measured at the peak of the work.
constexpr double bytesEach = 150.0;
constexpr double bytesEachTakenAway = 220.0;

Message valueText(const Volume& volume, double value) {
  const Message number = Message::rounded(value, 6);
  return volume.info().unit.empty() ? number : number.followedBy(" ", volume.info().unit);
}

void requireInRange(const Volume& volume, double isovalue) {
  const ValueRange& range = volume.range();
  if (isovalue > range.lowest && isovalue <= range.highest)
    return;
  throw Error(
      Error::Kind::input,
      Message::tr("There is no surface at %1, because the volume has values from %2 to %3; choose one "
                  "between them.")
          .arg(valueText(volume, isovalue))
          .arg(valueText(volume, range.lowest))
          .arg(valueText(volume, range.highest)));
}

[[noreturn]] void failEmpty(const Volume& volume, double isovalue) {
  throw Error(
      Error::Kind::input,
      Message::tr("There is no surface at %1: nothing within the crop and what is kept reaches it; choose "
                  "a lower value or a larger crop.")
          .arg(valueText(volume, isovalue)));
}

void requireMemoryFor(const SurfaceEstimate& estimate, const SurfaceOrder& order) {
  if (!order.memoryBytes || estimate.bytes <= *order.memoryBytes)
    return;
  throw Error(
      Error::Kind::input,
      Message::tr("The surface would have about %1 million triangles, which need %2 MB of memory where %3 "
                  "are free; crop the volume, choose another value or open a coarser volume.")
          .arg(Message::rounded(static_cast<double>(estimate.triangles) / 1e6, 3))
          .arg(Message::fixed(estimate.bytes / 1e6, 0))
          .arg(Message::fixed(*order.memoryBytes / 1e6, 0)));
}

SurfaceEstimate estimateOf(const SurfaceLattice& lattice, const SurfaceOrder& order,
                           const Progress& progress) {
  const Volume& volume = lattice.solid().volume();
  const std::uint64_t points = crossedEdges(lattice, effortOf(progress, Message::tr("Counting triangles")));
  if (points == 0)
    failEmpty(volume, order.isovalue);
  const double each = order.toleranceMm > 0.0 ? bytesEachTakenAway : bytesEach;
  return {2 * points, each * 2.0 * static_cast<double>(points)};
}

std::size_t bodiesOf(const SurfaceParts& parts, double leastMm3) {
  return static_cast<std::size_t>(
      std::count_if(parts.enclosedMm3.begin(), parts.enclosedMm3.end(),
                    [&](double enclosed) { return enclosed >= 0.0 && enclosed >= leastMm3; }));
}

// What of the closed surface was asked for.
SurfaceMesh chosenTriangles(const ExtractedSurface& closed, MadeSurface& made) {
  const SurfaceParts parts = partsOf(closed.mesh);
  std::vector<std::uint8_t> flags = largeParts(parts, made.order.smallestPartMm3, made.dropped);
  made.parts = bodiesOf(parts, made.order.smallestPartMm3);
  if (!made.order.isClosed)
    for (std::size_t i = 0; i < flags.size(); ++i)
      flags[i] &= !closed.isCut[i];
  return onlyTriangles(closed.mesh, flags);
}

} // namespace

SurfaceEstimate estimatedSurface(const Scene& scene, const SurfaceOrder& order, const Progress& progress) {
  requireInRange(*scene.volume, order.isovalue);
  const Solid solid(scene, order.isovalue);
  const SurfaceEstimate estimate = estimateOf(SurfaceLattice(solid, order.cells), order, progress);
  requireMemoryFor(estimate, order);
  return estimate;
}

MadeSurface makeSurface(const Scene& scene, const SurfaceOrder& order, const Progress& progress) {
  requireInRange(*scene.volume, order.isovalue);
  const Solid solid(scene, order.isovalue);
  const SurfaceLattice lattice(solid, order.cells);
  requireMemoryFor(estimateOf(lattice, order, part(progress, 0.0, 0.05)), order);
  MadeSurface made;
  made.order = order;
  made.mesh = chosenTriangles(extractedSurface(lattice, part(progress, 0.05, 0.25)), made);
  if (made.mesh.triangles.empty())
    failEmpty(solid.volume(), order.isovalue);
  made.trianglesBefore = made.mesh.triangles.size();
  const std::vector<glm::dvec3> boundary = boundaryPoints(solid, made.mesh, part(progress, 0.25, 0.3));
  if (order.toleranceMm > 0.0)
    made.mesh = decimated(made.mesh, solid, order.toleranceMm, part(progress, 0.3, 0.8));
  made.mesh = withNormals(std::move(made.mesh), solid,
                          effortOf(part(progress, 0.8, 0.85), Message::tr("Measuring gradients")));
  made.error = measuredError(solid, made.mesh, boundary, part(progress, 0.85, 0.97));
  made.edges = edgesOf(made.mesh);
  reportOrStop(progress, 1.0, Message::tr("Measuring the surface"));
  if (made.edges.isWatertight())
    made.enclosedMm3 = limn::enclosedMm3(made.mesh);
  return made;
}

} // namespace limn
