// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/presets/Landmarks.h"

#include <string>

namespace limn {

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
  std::optional<double> isovalue;     ///< of a projection that shows a surface
  std::optional<Landmarks> landmarks; ///< of the data that it was shaped on; none: in the data's own unit

  bool operator==(const Preset&) const = default;
};

/// How a scene looks, under a name: what a preset made of it shows.
Preset presetOf(const Scene& scene, const std::string& name);

/// The scene shown as the preset asks; camera, volume, crop and quality stay. The scene's shading model
/// is kept where `keepModel` (a comparison is under way), otherwise the preset's applies.
Scene withPreset(const Scene& scene, const Preset& preset, bool keepModel = false);

} // namespace limn
