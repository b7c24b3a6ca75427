// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/effects/EffectSet.h"

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// How a transfer function is looked up. Tables reach over the volume's range and are read with linear
/// interpolation.
enum class TableFormat {
  exact,          ///< the very segments between control points, no table
  floats1024,     ///< RGBA32F, 1024 entries
  floats256,      ///< RGBA32F, 256 entries
  bytes256,       ///< RGBA8, 256 entries: colour and opacity in steps of 1/255
  correctedFloats ///< RGBA32F, 256 entries that hold the opacity of a step in place of the unit distance
};

/// How the scalars lie in their texture.
enum class VolumeFormat {
  r32f,
  r16, ///< fixed point over three times the volume's range, which holds the apron's extrapolated texels too
  r8   ///< fixed point over the volume's range, to which the apron's texels are clamped: 256 levels are few
};

/// Where in its step a sample is taken.
enum class SamplePlace { middle, front };

/// Where the gradient of a sample comes from.
enum class GradientFormat {
  onTheFly,  ///< central differences, six fetches
  forward,   ///< forward differences, four fetches
  halves,    ///< one fetch of RGBA16F: vectors made before, not normalised
  directions ///< one fetch of RGBA8: unit directions and moduli made before
};

/// By which weights voxels are mixed where the program leaves that to the driver.
enum class FilterWeights {
  driver,
  eightBits ///< the driver's place between voxels rounded to 1/256, as graphics cards have it: what tests
            ///< know of a card without one. In no list of variants, so that no command draws with it
};

/// What is interpolated between voxels: the scalar, or what the transfer function makes of each.
enum class ClassificationOrder {
  afterInterpolation,
  beforeInHalves, ///< RGBA16F, colours premultiplied by opacity
  beforeInBytes   ///< RGBA8, the same
};

/// The decisions about accuracy that can be taken otherwise than this program takes them, to measure what
/// each costs in error and time. The defaults are the program's own. Where a picture has no use for one (a
/// projection that gathers nothing, an unlit model) it changes nothing.
struct Decisions {
  TableFormat table = TableFormat::exact;
  VolumeFormat volume = VolumeFormat::r32f;
  SamplePlace place = SamplePlace::middle; ///< of samples; pre-integrated steps have none
  GradientFormat gradients = GradientFormat::onTheFly;
  ClassificationOrder classification = ClassificationOrder::afterInterpolation; ///< of samples
  FilterWeights weights = FilterWeights::driver;
  bool operator==(const Decisions&) const = default;
};

/// Whether the gradient is read from a texture made before.
inline bool storesGradients(const Decisions& decisions) {
  return decisions.gradients == GradientFormat::halves || decisions.gradients == GradientFormat::directions;
}

/// One decision about accuracy taken in one way, all others being the program's own.
struct DecisionVariant {
  std::string group; ///< "look-up table"
  std::string name;  ///< "8 bits, 256 entries"
  bool isDefault = false;
  Decisions decisions;
  std::optional<double> earlyTermination; ///< takes the place of the scene's
};

/// Every way in which this program can take each decision, group by group, its own first.
std::vector<DecisionVariant> decisionVariants();

/// Those that can show in a picture of the scene, which calls for `effects`: a maximum (MIP) has no opacity
/// to correct, an unlit picture no gradient.
std::vector<DecisionVariant> decisionVariants(const Scene& scene, EffectSet effects);

} // namespace limn
