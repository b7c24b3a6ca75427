// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneMeasures.h"

#include "planes/EllipseVoxels.h"
#include "widgets/MeasureText.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

std::vector<glm::dvec3> handlesOf(const Measurement& measurement) {
  if (measurement.kind != Measurement::Kind::ellipse)
    return measurement.placesMm;
  const PlaneAxes axes = axesOf(*measurement.plane);
  const EllipseShape shape = shapeOf(measurement);
  const glm::dvec3 right = shape.semiAxesMm.x * axes.right;
  const glm::dvec3 down = shape.semiAxesMm.y * axes.down;
  return {shape.centreMm - right, shape.centreMm + right, shape.centreMm - down, shape.centreMm + down,
          shape.centreMm};
}

// The place of two that lies further against an axis, or along it, is led to where `placeMm` lies along it.
void leadAlong(std::vector<glm::dvec3>& placesMm, const glm::dvec3& axis, bool isFurther,
               const glm::dvec3& placeMm) {
  const bool firstIsFurther = glm::dot(placesMm[0], axis) > glm::dot(placesMm[1], axis);
  glm::dvec3& led = placesMm[firstIsFurther == isFurther ? 0 : 1];
  led += glm::dot(placeMm - led, axis) * axis;
}

Measurement withEllipseHandleAt(Measurement ellipse, std::size_t handle, const glm::dvec3& placeMm) {
  const PlaneAxes axes = axesOf(*ellipse.plane);
  if (handle == ellipseCorner)
    ellipse.placesMm[1] = placeMm;
  else if (handle < 4)
    leadAlong(ellipse.placesMm, handle < 2 ? axes.right : axes.down, handle % 2 == 1, placeMm);
  else
    for (const glm::dvec3 moved = placeMm - middleMm(ellipse); glm::dvec3 & corner : ellipse.placesMm)
      corner += moved;
  return ellipse;
}

} // namespace

bool isInSlice(const PlaneContent& content, PatientPlane plane, const Measurement& measurement) {
  if (measurement.kind != Measurement::Kind::mark && measurement.plane != plane)
    return false;
  const glm::dvec3 across = axesOf(plane).forward;
  const double half = sliceStepMm(content.volume->grid(), plane) / 2.0;
  const glm::dvec3 crosshair = crosshairOf(content);
  return std::ranges::all_of(measurement.placesMm, [&](const glm::dvec3& place) {
    return std::abs(glm::dot(place - crosshair, across)) <= half;
  });
}

std::vector<MeasureShape> measureShapes(const PlaneContent& content, PatientPlane plane,
                                        const PlaneFrame& frame) {
  std::vector<MeasureShape> shapes;
  for (std::size_t number = 0; number < content.measured.size(); ++number) {
    const Measured& measured = content.measured[number];
    if (!measured.measurement.isShown || !isInSlice(content, plane, measured.measurement))
      continue;
    MeasureShape shape{number,
                       measured.measurement.kind,
                       {},
                       measureNoteText(measured, *content.volume),
                       content.inHand == number};
    for (const glm::dvec3& place : handlesOf(measured.measurement))
      shape.places.push_back(pointOf(frame, place));
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

Measurement begunAt(Measurement::Kind kind, PatientPlane plane, const glm::dvec3& placeMm,
                    const std::vector<Measured>& others) {
  Measurement begun{kind, plane, std::vector<glm::dvec3>(placesOf(kind), placeMm)};
  if (kind == Measurement::Kind::mark)
    begun.name = freeName(measurementsOf(others));
  return begun;
}

Measurement withHandleAt(Measurement measurement, std::size_t handle, const glm::dvec3& placeMm, bool isNew) {
  if (measurement.kind == Measurement::Kind::ellipse)
    return withEllipseHandleAt(std::move(measurement), handle, placeMm);
  std::vector<glm::dvec3>& places = measurement.placesMm;
  places[handle] = placeMm;
  if (isNew && measurement.kind == Measurement::Kind::angle && handle == 1)
    places[2] = placeMm;
  return measurement;
}

} // namespace limn
