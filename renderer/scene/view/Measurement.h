// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/PlaneSettings.h"

#include <string>
#include <vector>

namespace limn {

struct Grid;

/// What somebody measured or named by hand at places of the world.
struct Measurement {
  enum class Kind { distance, angle, ellipse, mark };
  Kind kind = Kind::distance;
  /// The slice in which it lies; absent: it was made in the picture, straight through space. An ellipse has
  /// one.
  std::optional<PatientPlane> plane;
  /// World millimetres. A distance has its two ends, an angle one end, its corner and the other end, an
  /// ellipse two opposite corners of the box around it (whose sides run along the plane's axes), a mark its
  /// place. They may lie outside the volume.
  std::vector<glm::dvec3> placesMm = {};
  std::string name = {}; ///< given by a person; of a mark a number at first
  bool isShown = true;
  bool operator==(const Measurement&) const = default;
};

inline constexpr std::array measurementKinds{Measurement::Kind::distance, Measurement::Kind::angle,
                                             Measurement::Kind::ellipse, Measurement::Kind::mark};

/// The word for a kind in files and for object names.
inline const char* nameOf(Measurement::Kind kind) {
  constexpr std::array names{"distance", "angle", "ellipse", "mark"};
  return names[static_cast<std::size_t>(kind)];
}

/// How many places a measurement of a kind has.
inline std::size_t placesOf(Measurement::Kind kind) {
  constexpr std::array<std::size_t, 4> counts{2, 3, 2, 1};
  return counts[static_cast<std::size_t>(kind)];
}

/// From one end of a distance to the other.
double lengthMm(const Measurement& distance);

/// Between the legs of an angle at its corner, 0..180; nothing where an end lies on the corner.
std::optional<double> angleDegrees(const Measurement& angle);

/// Measurements of voxels that lie in one grid, where the same voxels lie in another of equal dimensions and
/// spacing: on their tissue, and each slice in that plane of the patient which has become of its own.
std::vector<Measurement> measurementsMoved(std::vector<Measurement> measurements, const Grid& from,
                                           const Grid& to);

/// In the middle of all its places: where one looks to see it, world millimetres.
glm::dvec3 middleMm(const Measurement& measurement);

/// The lowest number from 1 on that no measurement is named.
std::string freeName(const std::vector<Measurement>& measurements);

/// What the voxels of an ellipse say. Without any, mean, deviation and ends are 0.
struct EllipseFigures {
  double areaMm2 = 0.0;
  std::size_t voxels = 0; ///< valid ones
  double mean = 0.0;      ///< scalar units
  double deviation = 0.0; ///< the root of the mean squared distance from the mean
  double lowest = 0.0;
  double highest = 0.0;
  bool operator==(const EllipseFigures&) const = default;
};

/// A measurement with what it says of a volume.
struct Measured {
  Measurement measurement;
  EllipseFigures ellipse; ///< of an ellipse
  bool operator==(const Measured&) const = default;
};

/// The measurements alone.
std::vector<Measurement> measurementsOf(const std::vector<Measured>& measured);

} // namespace limn
