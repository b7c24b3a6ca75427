// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/SceneArguments.h"
#include "app/core/drawing/PictureMaker.h"

namespace limn {

/// What may be said to `limn render`.
struct RenderArguments {
  SceneArguments scene;
  std::string out;
  std::string engine = "auto";
  int threads = 0;
  bool printsFigures = false;
  bool filtersNoise = false;
  bool json = false; ///< what was drawn is told on stdout, for machines
  bool skipsExisting = false;
  std::string samplesSpent; ///< empty: not wanted
  double textureMb = anyMb; ///< the most that the volume may take on the graphics card
};

/// Adds SOURCE and the options; what is given is written to `arguments`, which lives until the command has
/// run.
void addRenderOptions(CommandSyntax& command, RenderArguments& arguments);

/// Draws one picture of each scene, all of one size.
using MakeAll =
    std::function<std::vector<MadePicture>(const std::vector<Scene>& scenes, const glm::ivec2& size)>;

/// Reads what is asked for, has it drawn, writes the picture, and tells what was noteworthy. Throws Error.
void runRender(const RenderArguments& arguments, const MakeAll& make);

} // namespace limn
