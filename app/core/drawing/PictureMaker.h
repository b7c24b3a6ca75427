// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ImageError.h"
#include "accuracy/sweep/ErrorByChance.h"
#include "app/core/drawing/EngineChoice.h"
#include "engine/PathFigures.h"
#include "glsl/textures/GraphicsMemory.h"
#include "scene/PictureFigures.h"
#include "scene/Scene.h"
#include "scene/basics/Effort.h"
#include "scene/basics/Image.h"

#include <functional>
#include <string>
#include <vector>

namespace limn {

/// A picture and what was noteworthy about making it.
struct MadePicture {
  Image image;
  Scene scene; ///< with which it was drawn
  Engine drawnBy;
  std::string engine;         ///< renderer string, or "reference (double precision)"
  std::vector<Message> notes; ///< one sentence each
  /// Known to have steps that see the transfer function, so that pictures of smaller ones tell its error
  /// (accuracy/ErrorEstimate).
  bool canBeEstimated = false;
  ImageError ofFilter; ///< what the driver's weights between voxels add (accuracy/Tolerance); see tellsFilter
  Message steps;       ///< with which it keeps its tolerance, a sentence; empty where none were looked for
  /// Of a picture of physical light.
  std::optional<PathFigures> paths{};
  double pathSeconds = 0.0;
  Image radiance{}; ///< linear, times alpha
};

/// Everything that a picture tells, a sentence each.
std::vector<Message> remarksOf(const MadePicture& picture);

/// How exact a picture of physical light is by its own paths, one sentence of ASCII; empty of any other.
std::string exactnessOf(const MadePicture& picture);

/// How pictures are drawn.
struct MakingOptions {
  std::optional<Engine> engine; ///< absent: the ray caster or the CPU engine, whichever is faster and there
  /// The ray caster's volume takes at most so much on the graphics card, MB: a larger one is drawn with fewer
  /// voxels, or by the CPU engine where that may be chosen.
  double textureMb = anyMb;
  EngineMemory memory; ///< is asked which engine is the faster; found by a trial where it does not know
  Effort effort; ///< threads of the CPU engine and the reference; told and asked between strips or tiles
  /// Whether pictures tell `ofFilter`, for which others are drawn beside each; otherwise those alone whose
  /// tolerance that may exceed.
  bool tellsFilter = false;
  bool isFilm = false; ///< of such pictures the first stands for all
};

/// Who draws a scene where nobody chose, as `makeEach` finds out: the CPU engine without OpenGL, where the
/// voxels stay on disk and where light on its way is followed, otherwise the faster one.
Engine engineFor(const Scene& scene, const EngineMemory& memory);

/// Takes the picture of the scene at `index`.
using TakePicture = std::function<void(std::size_t index, MadePicture picture)>;

/// Draws one picture per scene with one renderer, sharing its textures, and hands on each before it draws the
/// next. A scene with a tolerance gets the steps that keep it, where it does not have them already
/// (accuracy/Tolerance). Throws Error; Cancelled.
void makeEach(const std::vector<Scene>& scenes, const glm::ivec2& size, const MakingOptions& order,
              const TakePicture& take);

/// The same, all together. `threads` 0 uses every core.
std::vector<MadePicture> makePictures(const std::vector<Scene>& scenes, const glm::ivec2& size,
                                      std::optional<Engine> engine, int threads, double textureMb = anyMb,
                                      const EngineMemory& memory = {});

/// The picture of a scene that rays of the CPU engine make elsewhere, such as on many machines: `draw` is
/// asked for it, and before where a tolerance asks for steps of its own. Throws what it throws.
MadePicture pictureDrawnBy(const std::function<Image(const Scene& scene, const glm::ivec2& size)>& draw,
                           const Scene& scene, const glm::ivec2& size, const std::string& name);

/// Draws what the figures need (scene/PictureFigures.h) with the ray caster, the CPU engine or the reference.
/// Throws Error.
PictureFigures measureFigures(const Scene& scene, const glm::ivec2& size, Engine engine, int threads);

/// How many samples each pixel took of the picture of a scene: those of error-controlled steps, or the number
/// of equal ones. Throws Error, of kind usage for engines that count none.
std::vector<int> countSamples(const Scene& scene, const glm::ivec2& size, Engine engine, int threads);

/// Draws pixels with the reference.
DrawPrecisely preciselyBy(int threads, std::function<bool()> isCancelled);

/// What exact pixels drawn at random say of a picture (accuracy/sweep/ErrorByChance); absent where they do
/// not settle, where the voxels stay on disk, or where light travels. Throws Cancelled.
std::optional<ErrorByChance> chanceOf(const Scene& scene, const Image& picture, const Effort& effort);

/// Where pixels drawn at random say more than the tolerance that a picture was asked to keep, by estimate, a
/// sentence that says so, and what to ask for; otherwise empty.
Message noteBeyondTolerance(const Scene& asked, const ErrorByChance& found);

/// Two pictures of one height side by side.
Image sideBySide(const Image& left, const Image& right);

} // namespace limn
