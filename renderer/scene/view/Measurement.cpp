// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/Measurement.h"

#include "scene/volume/Grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

// The axis of the world (LPS) across a plane of the patient, and the plane across an axis.
int axisAcross(PatientPlane plane) {
  return plane == PatientPlane::axial ? 2 : plane == PatientPlane::coronal ? 1 : 0;
}

PatientPlane planeAcross(const glm::dvec3& direction) {
  const auto isNearer = [&](PatientPlane a, PatientPlane b) {
    return std::abs(direction[axisAcross(a)]) < std::abs(direction[axisAcross(b)]);
  };
  return *std::ranges::max_element(patientPlanes, isNearer);
}

} // namespace

std::vector<Measurement> measurementsMoved(std::vector<Measurement> measurements, const Grid& from,
                                           const Grid& to) {
  const glm::dmat3 turn = to.direction * glm::transpose(from.direction);
  for (Measurement& one : measurements) {
    for (glm::dvec3& place : one.placesMm)
      place = indexToWorld(to, worldToIndex(from, place));
    if (one.plane)
      one.plane = planeAcross(turn[axisAcross(*one.plane)]);
  }
  return measurements;
}

double lengthMm(const Measurement& distance) {
  return glm::length(distance.placesMm[1] - distance.placesMm[0]);
}

std::optional<double> angleDegrees(const Measurement& angle) {
  const glm::dvec3 first = angle.placesMm[0] - angle.placesMm[1];
  const glm::dvec3 second = angle.placesMm[2] - angle.placesMm[1];
  if (first == glm::dvec3(0.0) || second == glm::dvec3(0.0))
    return std::nullopt;
  // The cosine alone loses half of its digits near 0 and 180 degrees.
  return std::atan2(glm::length(glm::cross(first, second)), glm::dot(first, second)) * 180.0 /
         std::numbers::pi;
}

glm::dvec3 middleMm(const Measurement& measurement) {
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& place : measurement.placesMm)
    middle += place / static_cast<double>(measurement.placesMm.size());
  return middle;
}

std::string freeName(const std::vector<Measurement>& measurements) {
  for (int number = 1;; ++number)
    if (std::string name = std::to_string(number);
        std::ranges::find(measurements, name, &Measurement::name) == measurements.end())
      return name;
}

std::vector<Measurement> measurementsOf(const std::vector<Measured>& measured) {
  std::vector<Measurement> measurements;
  measurements.reserve(measured.size());
  for (const Measured& one : measured)
    measurements.push_back(one.measurement);
  return measurements;
}

} // namespace limn
