// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/EllipseVoxels.h"

#include "planes/PlaneGrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

// What lies on a border by the numbers that were given shall not lie beyond it by their rounding; as shares
// of a semi-axis and of a slice.
constexpr double onBorder = 1e-9;

// The mean and the squared distances from it, value by value (Welford).
class RunningFigures {
public:
  void add(double value) {
    ++m_figures.voxels;
    const double before = value - m_figures.mean;
    m_figures.mean += before / static_cast<double>(m_figures.voxels);
    m_squares += before * (value - m_figures.mean);
    m_figures.lowest = m_figures.voxels == 1 ? value : std::min(m_figures.lowest, value);
    m_figures.highest = m_figures.voxels == 1 ? value : std::max(m_figures.highest, value);
  }

  EllipseFigures figures() const {
    EllipseFigures figures = m_figures;
    if (figures.voxels > 0)
      figures.deviation = std::sqrt(m_squares / static_cast<double>(figures.voxels));
    return figures;
  }

private:
  EllipseFigures m_figures;
  double m_squares = 0.0;
};

// Among the voxels those that can lie in a box around a place, both ends included.
struct VoxelReach {
  glm::ivec3 first;
  glm::ivec3 last;
};

VoxelReach voxelsAround(const Grid& grid, const glm::dvec3& centreMm, const PlaneAxes& axes,
                        const glm::dvec3& halfMm) {
  glm::dvec3 lower(std::numeric_limits<double>::max()), upper(-std::numeric_limits<double>::max());
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [&](int bit) { return corner & bit ? 1.0 : -1.0; };
    const glm::dvec3 index =
        worldToIndex(grid, centreMm + side(1) * halfMm.x * axes.right + side(2) * halfMm.y * axes.down +
                               side(4) * halfMm.z * axes.forward);
    lower = glm::min(lower, index);
    upper = glm::max(upper, index);
  }
  // Clamped before they become integers: an ellipse may lie a kilometre away.
  const glm::dvec3 last(grid.dims - 1);
  return {glm::ivec3(glm::clamp(glm::floor(lower), glm::dvec3(0.0), last + 1.0)),
          glm::ivec3(glm::clamp(glm::ceil(upper), glm::dvec3(-1.0), last))};
}

} // namespace

EllipseShape shapeOf(const Measurement& ellipse) {
  const PlaneAxes axes = axesOf(ellipse.plane.value_or(PatientPlane::axial));
  const glm::dvec3 across = ellipse.placesMm[1] - ellipse.placesMm[0];
  return {middleMm(ellipse),
          glm::abs(glm::dvec2(glm::dot(across, axes.right), glm::dot(across, axes.down))) / 2.0};
}

EllipseFigures ellipseFigures(const Volume& volume, const Measurement& ellipse) {
  const Grid& grid = volume.grid();
  const PatientPlane plane = ellipse.plane.value_or(PatientPlane::axial);
  const PlaneAxes axes = axesOf(plane);
  const EllipseShape shape = shapeOf(ellipse);
  const glm::dvec2& half = shape.semiAxesMm;
  const double step = sliceStepMm(grid, plane);
  const auto isInside = [&](const glm::dvec3& fromCentre) {
    if (std::floor(glm::dot(fromCentre, axes.forward) / step + 0.5 + onBorder) != 0.0)
      return false;
    const double x = glm::dot(fromCentre, axes.right) / half.x;
    const double y = glm::dot(fromCentre, axes.down) / half.y;
    return x * x + y * y <= 1.0 + onBorder;
  };
  RunningFigures running;
  if (half.x > 0.0 && half.y > 0.0) {
    const VoxelReach reach = voxelsAround(grid, shape.centreMm, axes, {half, step});
    const VoxelMask& invalid = volume.invalidMask();
    const Rescale& rescale = volume.rescale();
    visitVoxels(volume, [&](const auto& stored) {
      for (int k = reach.first.z; k <= reach.last.z; ++k)
        for (int j = reach.first.y; j <= reach.last.y; ++j)
          for (int i = reach.first.x; i <= reach.last.x; ++i) {
            const std::size_t voxel = voxelOffset(grid.dims, i, j, k);
            if (isInside(indexToWorld(grid, {i, j, k}) - shape.centreMm) &&
                (invalid.empty() || !invalid[voxel]))
              running.add(rescale.slope * static_cast<double>(stored[voxel]) + rescale.intercept);
          }
    });
  }
  EllipseFigures figures = running.figures();
  figures.areaMm2 = std::numbers::pi * half.x * half.y;
  return figures;
}

std::vector<Measured> measuredIn(const Volume* volume, const std::vector<Measurement>& measurements,
                                 const std::vector<Measured>& before) {
  const auto liesAs = [](const Measurement& a, const Measurement& b) {
    return a.kind == b.kind && a.plane == b.plane && a.placesMm == b.placesMm;
  };
  std::vector<Measured> measured;
  for (const Measurement& one : measurements) {
    measured.push_back({one, {}});
    if (one.kind != Measurement::Kind::ellipse)
      continue;
    const auto known =
        std::ranges::find_if(before, [&](const Measured& other) { return liesAs(other.measurement, one); });
    const glm::dvec2 half = shapeOf(one).semiAxesMm;
    EllipseFigures& figures = measured.back().ellipse;
    if (known != before.end())
      figures = known->ellipse;
    else if (volume)
      figures = ellipseFigures(*volume, one);
    else
      figures.areaMm2 = std::numbers::pi * half.x * half.y;
  }
  return measured;
}

} // namespace limn
