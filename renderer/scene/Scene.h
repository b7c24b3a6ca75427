// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/light/Shading.h"
#include "scene/regions/Region.h"
#include "scene/view/Camera.h"
#include "scene/volume/Volume.h"

#include <memory>
#include <optional>

namespace limn {

/// Fog (DEFINITION section 6; lecture, "OpenGL fog"): weighs a sample's colour by its distance to the eye.
struct Fog {
  enum class Mode { none, linear, exp, exp2 };
  Mode mode = Mode::none;
  glm::dvec3 color{0.0};
  double densityPerMm = 0.0; ///< ≥ 0; exp and exp2
  double startMm = 0.0;
  double endMm = 1000.0; ///< linear
  bool operator==(const Fog&) const = default;
};

/// The part of the volume box that is drawn, as fractions along the grid axes, 0 ≤ lower < upper ≤ 1.
struct CropBox {
  glm::dvec3 lower{0.0};
  glm::dvec3 upper{1.0};
  bool operator==(const CropBox&) const = default;
};

/// How the samples along a ray become one pixel (DEFINITION section 7).
enum class Projection { composite, mip, minip, average, xray, isosurface, compositeIsosurface };

/// Whether each step integrates the function exactly along its segment: where samples alone would not resolve
/// the function, wherever that is possible, or never.
enum class Preintegration { automatic, always, never };

/// How an engine finds what comes of light that travels (DEFINITION section 11): on a fine grid or a coarse
/// one; or along paths that are spread over a ray's samples, which are few at rest and fewer while something
/// moves (fine nodes that are there serve as well; an engine that follows no paths takes both grids), or so
/// many that they tell how far off the others are. A tolerance asks for as many as it needs.
enum class LightDetail { fine, coarse, spread, moving, sampled };

/// What the picture costs and how close it comes to the integral.
struct Quality {
  double stepVoxels = 0.5; ///< in units of the smallest spacing, > 0
  Preintegration preintegrated = Preintegration::automatic;
  double earlyTermination = 0.998; ///< stop where alpha reaches it, 0 < e ≤ 1; 1 = never
  bool jitter = false;
  /// The error wished for, in levels, > 0: error-controlled steps (LocalSteps) in place of equal ones where
  /// the projection integrates. A renderer draws with `fineness`; accuracy/Tolerance finds it for a picture.
  std::optional<double> toleranceLevels;
  std::optional<double> fineness; ///< of error-controlled steps; absent: the one that heads commonly need
  /// Whether a picture needs voxels weighed more finely than a graphics card does, which accuracy/Tolerance
  /// finds, too; nothing else draws differently with it.
  bool ownWeights = false;
  LightDetail light = LightDetail::spread; ///< no file keeps it
  /// Of physical light, how many of each pixel are followed in a picture on its way; 0: those followed before
  /// are shown; absent: as many as the model's `until` asks for (pathsOf). No file keeps it.
  std::optional<int> paths{};
  bool operator==(const Quality&) const = default;
};

/// Whether an engine that knows light from grids alone takes a fine one.
inline bool asksFineLight(const Quality& quality) {
  return quality.light == LightDetail::fine || quality.light == LightDetail::spread;
}

/// Size of a written picture and the colour behind it (8-bit output only).
struct ImageSettings {
  int width = 512;
  int height = 512;
  glm::dvec3 background{0.05, 0.05, 0.08};
  bool operator==(const ImageSettings&) const = default;
};

/// Everything a picture depends on, as one plain value. Renderers draw from it; only the session changes it.
/// Two scenes are equal when they share the volume and agree in every number.
struct Scene {
  std::shared_ptr<const Volume> volume;
  Camera camera;
  TransferFunction transferFunction;
  Shading shading;
  std::optional<GradientOpacity> gradientOpacity;
  Fog fog;
  CropBox crop;
  Region keep;
  Projection projection = Projection::composite;
  double isovalue = 300.0;
  Quality quality;
  ImageSettings image;

  bool operator==(const Scene&) const = default;
};

} // namespace limn
