// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace limn {

/// An ellipsoid of one tissue with axes along the world axes. Later parts cover earlier ones.
struct PhantomPart {
  glm::dvec3 centreMm;
  glm::dvec3 radiiMm;
  double hu;
  double edgeMm; ///< width over which the part fades in, measured along its shortest radius
};

/// The anatomy of the phantom, in painting order. LPS: +x left, +y posterior, +z superior.
std::vector<PhantomPart> phantomParts();

/// A head made of formulas, in patient space LPS, centred on the origin: skin, fat, muscle, a skull of two
/// tables with diploë between them, brain with ventricles, orbits, sinuses, teeth and one metal filling.
/// Every part is an ellipsoid with a soft edge, so its value is known everywhere. HU values are
/// rounded from W. A. Kalender, Computed Tomography (3rd ed., 2011), table of CT numbers, and U. Schneider et
/// al., Phys. Med. Biol. 41 (1996) 111, table 2.
double phantomValue(const glm::dvec3& worldMm);

/// How the phantom is sampled.
struct PhantomSpec {
  double spacingMm = 1.0; ///< isotropic, > 0; the field of view is 192 × 232 × 272 mm
  double noiseHu = 0.0;   ///< standard deviation of additive Gaussian noise, ≥ 0
  std::uint64_t seed = 1; ///< the same seed gives the same noise on every machine
  bool operator==(const PhantomSpec&) const = default;
};

/// Samples the phantom at voxel centres as int16 HU, on all cores. `isCancelled` may be empty; true ends the
/// work with Cancelled. Throws Error (usage) for a spacing that gives no or too many (> 2³¹) voxels.
std::shared_ptr<const Volume> phantomVolume(const PhantomSpec& spec,
                                            const std::function<bool()>& isCancelled = {});

} // namespace limn
