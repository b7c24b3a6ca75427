// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/function/TransferFunction.h"
#include "scene/volume/Histogram.h"

#include <string>

namespace limn {

/// Three values by which a look moves between data without a common scale, ascending.
struct Landmarks {
  double background = 0.0; ///< of air, the 0.5 % quantile
  double object = 0.0;     ///< where tissue begins: objectThreshold, of scales cut off below beginOfObject
  double brightest = 0.0;  ///< the 99.8 % quantile
  bool operator==(const Landmarks&) const = default;
};

/// Air, the limit of tissue, dense bone: the landmarks of Hounsfield units.
inline constexpr Landmarks hounsfieldLandmarks{-1000.0, -300.0, 1500.0};

/// Of a volume's values; always ascending, by a bin at least.
Landmarks landmarksOf(const Histogram& histogram);

/// The value that lies between the landmarks `to` as `value` lies between `from`: linear from each landmark
/// to the next and beyond the outermost.
double moved(double value, const Landmarks& from, const Landmarks& to);

/// Every point moved so.
TransferFunction moved(const TransferFunction& function, const Landmarks& from, const Landmarks& to);

/// The threshold that best separates background from object (N. Otsu, IEEE Trans. SMC 9 (1979) 62), scalar
/// units.
double objectThreshold(const Histogram& histogram);

/// A named way to show a kind of data: a transfer function and, optionally, how it is lit and projected.
/// `name` and `modality` are required; what is absent leaves the scene as it is.
struct Preset {
  std::string name;
  std::string modality; ///< "CT", "MR", …
  std::string note;     ///< one sentence: what it shows; short lists have it up to a semicolon
  std::string folder;   ///< of one of the user's own, in their list; empty: none
  TransferFunction transferFunction;
  std::optional<GradientOpacity> gradientOpacity;
  std::optional<Shading> shading;
  std::optional<Projection> projection;
  std::optional<double> isovalue; ///< of a projection that shows a surface
  /// How one scene looked, all of it: normals that it does not smooth are not smooth. Of others smoothing is
  /// the volume's: what asks for none leaves what there is.
  bool isWhole = false;
  std::optional<Landmarks> landmarks; ///< of the data that it was shaped on; none: in the data's own unit

  bool operator==(const Preset&) const = default;
};

/// How a scene looks, under a name: what a preset made of it shows.
Preset presetOf(const Scene& scene, const std::string& name);

/// The scene shown as the preset asks; camera, volume, crop and quality stay, and with them how far pictures
/// of physical light that are saved are drawn. The scene's shading model
/// is kept where `keepModel` (a comparison is under way), otherwise the preset's applies.
Scene withPreset(const Scene& scene, const Preset& preset, bool keepModel = false);

} // namespace limn
