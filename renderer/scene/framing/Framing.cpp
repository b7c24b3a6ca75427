// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/framing/Framing.h"

#include "scene/framing/Outermost.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn {
namespace {

// What is thinner is framed as if it were so many voxels wide.
constexpr double leastVoxels = 3.0;

// The outermost voxels of both sides of one axis of a picture whose edges have a slope: how far across and
// behind the middle of the volume they lie, mm.
struct Sides {
  double slope;
  glm::dvec2 high;
  glm::dvec2 low;

  // An eye so far before the middle and so far across sees an edge of this slope along each of them.
  double depth() const { return (high.x - low.x - slope * (high.y + low.y)) / (2.0 * slope); }
  double centre() const { return (high.x + low.x - slope * (high.y - low.y)) / 2.0; }
};

// Frames one direction of view. An eye at -d and p sees within edges of slope s what satisfies
// |x - p| ≤ s (z + d), a half space for each edge: how far the voxels reach across both tells where it
// stands.
class Framer {
public:
  Framer(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect)
      : m_camera(camera), m_basis(basisOf(camera)), m_anchor(boxCentreMm(grid)),
        m_diagonal(boxDiagonalMm(grid)), m_outermost(grid, visible),
        m_slopes(framedShare * halfHeight(camera) * glm::dvec2(aspect, 1.0)) {
    const double near = seen(m_basis.right, -m_basis.forward).y;
    const double far = seen(m_basis.right, m_basis.forward).y;
    m_middle = (near + far) / 2.0;
    const double least = leastVoxels * std::max({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z});
    m_isOrthographic = camera.projection == Camera::Projection::orthographic;
    m_distance = m_isOrthographic ? heightOf(least, aspect) : distanceOf(least, near);
  }

  // From the eye to the target; of an orthographic camera the height.
  double distance() const { return m_distance; }

  // At that distance or a larger one, centred.
  Camera at(double distance) const {
    Camera placed = m_camera;
    placed.up = m_basis.up;
    const double depth = distance - m_middle;
    placed.target = m_anchor + centre(m_basis.right, m_slopes.x, depth) * m_basis.right +
                    centre(m_basis.up, m_slopes.y, depth) * m_basis.up + m_middle * m_basis.forward;
    double away = distance;
    if (m_isOrthographic) {
      placed.heightMm = distance;
      away = std::max(m_diagonal, glm::distance(m_camera.target, m_camera.position));
    }
    placed.position = placed.target - away * m_basis.forward;
    return placed;
  }

private:
  // The outermost voxel along a direction: how far across and how far behind it lies.
  glm::dvec2 seen(const glm::dvec3& across, const glm::dvec3& direction) const {
    const glm::dvec3 from = m_outermost.along(direction) - m_anchor;
    return {glm::dot(from, across), glm::dot(from, m_basis.forward)};
  }

  Sides sides(const glm::dvec3& across, double slope) const {
    const glm::dvec3 tilt = slope * m_basis.forward;
    return {slope, seen(across, across - tilt), seen(across, -across - tilt)};
  }

  double distanceOf(double leastMm, double near) const {
    const double depth =
        std::max(sides(m_basis.right, m_slopes.x).depth(), sides(m_basis.up, m_slopes.y).depth());
    return m_middle + std::max(depth, leastMm / 2.0 / std::min(m_slopes.x, m_slopes.y) - near);
  }

  double heightOf(double leastMm, double aspect) const {
    const Sides wide = sides(m_basis.right, 0.0);
    const Sides high = sides(m_basis.up, 0.0);
    const double width = std::max(wide.high.x - wide.low.x, leastMm);
    const double height = std::max(high.high.x - high.low.x, leastMm);
    return std::max(width / aspect, height) / framedShare;
  }

  // The place across at which an eye so far before the middle has as much on both sides. The slope of the
  // edges that fit is found by Newton's rule, which ends soon where functions are made of straight pieces,
  // and by halves where it leaves what is known of the place.
  double centre(const glm::dvec3& across, double slope, double depth) const {
    if (m_isOrthographic)
      return sides(across, 0.0).centre();
    double below = 0.0;
    double above = slope;
    Sides found = sides(across, slope);
    for (int i = 0; i < mostSteps; ++i) {
      // Positive where the edges have to open.
      const double lack =
          found.high.x - found.low.x - found.slope * (found.high.y + found.low.y + 2.0 * depth);
      (lack > 0.0 ? below : above) = found.slope;
      double next = found.slope + lack / (found.high.y + found.low.y + 2.0 * depth);
      if (!(next >= below && next <= above) || i % 8 == 7)
        next = (below + above) / 2.0;
      if (std::abs(next - found.slope) <= 1e-12 * slope)
        break;
      found = sides(across, next);
    }
    return found.centre();
  }

  static constexpr int mostSteps = 60;

  const Camera& m_camera;
  CameraBasis m_basis;
  glm::dvec3 m_anchor;
  double m_diagonal;
  Outermost m_outermost;
  glm::dvec2 m_slopes; // of the edges within which everything stays, across and up
  double m_middle;
  double m_distance;
  bool m_isOrthographic;
};

} // namespace

Camera framed(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect) {
  const Framer framer(camera, grid, visible, aspect);
  return framer.at(framer.distance());
}

double framedDistance(const std::vector<Camera>& cameras, const Grid& grid, const VisibleVoxels& visible,
                      double aspect, const Effort& effort) {
  std::vector<double> distances(cameras.size());
  forEachPiece(static_cast<int>(cameras.size()), effort, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    distances[place] = Framer(cameras[place], grid, visible, aspect).distance();
  });
  return std::ranges::max(distances);
}

Camera framedFrom(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect,
                  double distance) {
  return Framer(camera, grid, visible, aspect).at(distance);
}

Camera framedCamera(const Scene& scene, double aspect, const Effort& effort) {
  return framed(scene.camera, scene.volume->grid(), visibleVoxels(scene, effort), aspect);
}

Camera framedView(const Scene& scene, StandardView view, double aspect, const Effort& effort) {
  const Grid& grid = scene.volume->grid();
  return framed(standardView(scene.camera, grid, view), grid, visibleVoxels(scene, effort), aspect);
}

Camera refitted(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspectBefore,
                double aspect) {
  const Camera before = framed(camera, grid, visible, aspectBefore);
  const Camera after = framed(camera, grid, visible, aspect);
  Camera placed = camera;
  placed.target += after.target - before.target;
  glm::dvec3 away = camera.position - camera.target;
  if (camera.projection == Camera::Projection::orthographic)
    placed.heightMm *= after.heightMm / before.heightMm;
  else
    away *= glm::length(after.position - after.target) / glm::length(before.position - before.target);
  placed.position = placed.target + away;
  return placed;
}

bool isFramed(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect) {
  const Camera fit = framed(camera, grid, visible, aspect);
  const double allowed = 1e-6 * boxDiagonalMm(grid);
  const bool isAsHigh = camera.projection == Camera::Projection::perspective ||
                        std::abs(camera.heightMm - fit.heightMm) <= allowed;
  return isAsHigh && glm::distance(camera.target, fit.target) <= allowed &&
         glm::distance(camera.position, fit.position) <= allowed;
}

bool seesAny(const Camera& camera, const Grid& grid, const VisibleVoxels& visible, double aspect) {
  const CameraBasis basis = basisOf(camera);
  const Outermost outermost(grid, visible);
  // How far the voxels reach from the eye along a direction of any length.
  const auto reach = [&](const glm::dvec3& direction) {
    return glm::dot(outermost.along(direction) - camera.position, direction);
  };
  const auto isWithinEdge = [&](const glm::dvec3& inwards, double half) {
    return camera.projection == Camera::Projection::orthographic
               ? reach(inwards) >= -half
               : reach(inwards + half * basis.forward) >= 0.0;
  };
  const double high = halfHeight(camera);
  return reach(basis.forward) > 0.0 && isWithinEdge(basis.up, high) && isWithinEdge(-basis.up, high) &&
         isWithinEdge(basis.right, aspect * high) && isWithinEdge(-basis.right, aspect * high);
}

} // namespace limn
