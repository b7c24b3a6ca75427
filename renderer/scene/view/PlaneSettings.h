// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace limn {

/// The planes of the patient in which slices lie. (The folder renderer/slices is another thing: planes that
/// follow the camera and make up the 3D picture.)
enum class PatientPlane { axial, coronal, sagittal };

inline constexpr std::array patientPlanes{PatientPlane::axial, PatientPlane::coronal, PatientPlane::sagittal};

/// What stands beside the picture: nothing, the three planes of equal size, or one of them large.
enum class PlaneLayout { pictureOnly, pictureAndThree, oneLarge };

inline constexpr std::array planeLayouts{PlaneLayout::pictureOnly, PlaneLayout::pictureAndThree,
                                         PlaneLayout::oneLarge};

/// The scalars that are shown from black to white: centre ± width/2. Clinicians call the centre "level".
struct GreyWindow {
  double centre = 0.0;
  double width = 1.0; ///< > 0
  bool operator==(const GreyWindow&) const = default;
};

/// What a slice shows of what lies before and behind it.
struct Slab {
  enum class Mode { mean, maximum };
  Mode mode = Mode::mean;
  double thicknessMm = 0.0; ///< 0..`thickestSlabMm`; 0: the plane itself
  bool operator==(const Slab&) const = default;
};

inline constexpr std::array slabModes{Slab::Mode::mean, Slab::Mode::maximum};
inline constexpr double thickestSlabMm = 100.0;

/// What lies between voxel centres: the nearest voxel's value, or the trilinear one (DEFINITION section 1).
enum class PlaneInterpolation { nearest, linear };

inline constexpr std::array planeInterpolations{PlaneInterpolation::nearest, PlaneInterpolation::linear};

/// Everything that slices show beside what the scene says (volume, curve, kept region).
struct PlaneSettings {
  PlaneLayout layout = PlaneLayout::pictureOnly;
  PatientPlane large = PatientPlane::axial; ///< of `oneLarge`
  std::optional<glm::dvec3> crosshairMm;    ///< world; absent: the voxel in the middle of the volume
  std::optional<GreyWindow> window;         ///< absent: one that suits the volume
  PlaneInterpolation interpolation = PlaneInterpolation::linear;
  Slab slab;
  bool isTinted = false;      ///< by the transfer function
  bool outlinesRegion = true; ///< where a kept region ends
  bool operator==(const PlaneSettings&) const = default;
};

/// The word for a plane or a layout in session files and for object names.
inline const char* nameOf(PatientPlane plane) {
  constexpr std::array names{"axial", "coronal", "sagittal"};
  return names[static_cast<std::size_t>(plane)];
}
inline const char* nameOf(PlaneLayout layout) {
  constexpr std::array names{"picture", "picture_and_three", "one_large"};
  return names[static_cast<std::size_t>(layout)];
}
inline const char* nameOf(Slab::Mode mode) {
  constexpr std::array names{"mean", "maximum"};
  return names[static_cast<std::size_t>(mode)];
}
inline const char* nameOf(PlaneInterpolation interpolation) {
  constexpr std::array names{"nearest", "linear"};
  return names[static_cast<std::size_t>(interpolation)];
}

} // namespace limn
