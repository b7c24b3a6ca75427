// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceMaker.h"

#include "io/surfaces/Decimation.h"
#include "io/surfaces/Extraction.h"
#include "scene/basics/Error.h"
#include "scene/light/Gradient.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace limn {
namespace {

/// Points that triangles join (union by the lower number, paths halved).
class JoinedPoints {
public:
  explicit JoinedPoints(std::size_t count) : m_above(count) { std::iota(m_above.begin(), m_above.end(), 0u); }
  std::uint32_t rootOf(std::uint32_t point) {
    while (m_above[point] != point)
      point = m_above[point] = m_above[m_above[point]];
    return point;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = rootOf(a);
    b = rootOf(b);
    m_above[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> m_above;
};

// The mesh with a normal for each point: -g/|g| of the field's gradient (DEFINITION section 2) where the
// point lies on the isosurface; on faces that close a cut, and where there is no gradient, that of the
// triangles around it.
SurfaceMesh withNormals(SurfaceMesh mesh, const Solid& solid, const Effort& effort = {});

// A point farther from the isosurface, in voxels, or from the planes where the crop ends, is not on them.
constexpr double nearIsosurface = 0.5;
constexpr double onPlane = 1e-3;
// The gradient's direction and that of the triangles agree at least so far (cosine), or noise decides it.
constexpr double leastAgreement = 0.25;

glm::dvec3 unit(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0, 0.0, 1.0);
}

bool isOnPlane(const Solid& solid, const glm::dvec3& index) {
  return glm::any(glm::lessThan(index, solid.lower() + onPlane)) ||
         glm::any(glm::greaterThan(index, solid.upper() - onPlane));
}

glm::dvec3 normalAt(const Solid& solid, const glm::dvec3& pointMm, const glm::dvec3& ofTriangles) {
  const glm::dvec3 index = solid.toIndex(pointMm);
  if (isOnPlane(solid, index))
    return ofTriangles;
  const glm::dvec3 gradient = gradientAt(solid.volume(), index);
  const double modulus = glm::length(gradient);
  const double nearMm = nearIsosurface * smallestSpacingMm(solid.volume().grid());
  if (!(modulus > 0.0) || std::abs(solid.excess(index)) > nearMm * modulus)
    return ofTriangles;
  const glm::dvec3 normal = -gradient / modulus;
  return glm::dot(normal, ofTriangles) >= leastAgreement ? normal : ofTriangles;
}

SurfaceMesh withNormals(SurfaceMesh mesh, const Solid& solid, const Effort& effort) {
  std::vector<glm::dvec3> around(mesh.points.size(), glm::dvec3(0.0));
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 area = areaVector(mesh, triangle);
    for (int corner = 0; corner < 3; ++corner)
      around[triangle[corner]] += area;
  }
  mesh.normals.resize(mesh.points.size());
  constexpr std::size_t perPiece = 1 << 13;
  forEachPiece(static_cast<int>((mesh.points.size() + perPiece - 1) / perPiece), effort, [&](int piece) {
    const std::size_t begin = static_cast<std::size_t>(piece) * perPiece;
    for (std::size_t i = begin; i < std::min(begin + perPiece, mesh.points.size()); ++i)
      mesh.normals[i] = normalAt(solid, glm::dvec3(mesh.points[i]), unit(around[i]));
  });
  return mesh;
}

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
          .arg(valueText(volume, isovalue), valueText(volume, range.lowest),
               valueText(volume, range.highest)));
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
          .arg(Message::rounded(static_cast<double>(estimate.triangles) / 1e6, 3),
               Message::fixed(estimate.bytes / 1e6, 0), Message::fixed(*order.memoryBytes / 1e6, 0)));
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

SurfaceParts partsOf(const SurfaceMesh& mesh) {
  JoinedPoints joined(mesh.points.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    joined.join(triangle.x, triangle.y);
    joined.join(triangle.y, triangle.z);
  }
  constexpr auto unknown = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> partOfRoot(mesh.points.size(), unknown);
  SurfaceParts parts;
  parts.ofTriangle.reserve(mesh.triangles.size());
  std::vector<glm::dvec3> origins;
  for (const glm::uvec3& t : mesh.triangles) {
    std::uint32_t& part = partOfRoot[joined.rootOf(t.x)];
    if (part == unknown) {
      part = static_cast<std::uint32_t>(origins.size());
      origins.emplace_back(mesh.points[t.x]);
      parts.enclosedMm3.push_back(0.0);
    }
    parts.ofTriangle.push_back(part);
    const glm::dvec3& origin = origins[part];
    const glm::dvec3 a(mesh.points[t.x]), b(mesh.points[t.y]), c(mesh.points[t.z]);
    parts.enclosedMm3[part] += glm::dot(a - origin, glm::cross(b - origin, c - origin)) / 6.0;
  }
  return parts;
}

std::vector<std::uint8_t> largeParts(const SurfaceParts& parts, double leastMm3, DroppedParts& dropped) {
  dropped = {};
  std::vector<std::uint8_t> isLarge;
  for (const double enclosed : parts.enclosedMm3) {
    isLarge.push_back(std::abs(enclosed) >= leastMm3);
    if (isLarge.back())
      continue;
    ++(enclosed < 0.0 ? dropped.hollows : dropped.parts);
    dropped.enclosedMm3 += std::max(0.0, enclosed);
  }
  std::vector<std::uint8_t> flags;
  flags.reserve(parts.ofTriangle.size());
  for (const std::uint32_t part : parts.ofTriangle)
    flags.push_back(isLarge[part]);
  return flags;
}

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
