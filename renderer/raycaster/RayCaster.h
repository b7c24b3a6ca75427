// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "glsl/decisions/Decisions.h"
#include "glsl/textures/GraphicsMemory.h"
#include "scene/Scene.h"
#include "scene/light/LightGrid.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// Draws scenes with GLSL on the current OpenGL context (3.0 or newer). Owns textures and programs and keeps
/// them while scenes share them: a new control point uploads a small table, a new camera nothing. A program
/// that draws the same picture is used until there is time to compile one that holds no more than needed.
/// All calls, construction and destruction included, need the same context to be current.
class RayCaster {
public:
  /// Pictures drawn off screen go to the driver in squares of this many pixels, which no watchdog takes for a
  /// hang.
  static constexpr int tileSize = 256;

  /// Stepping over empty space changes no bit of a picture; tests and benchmarks switch it off to show that.
  enum class EmptySpace { skipped, sampled };

  /// A program holds what the scene calls for, or beyond it every effect that has a neutral value: the same
  /// picture bit for bit, slower. Tests and benchmarks compare the two.
  enum class Programs { specialised, allEffects };

  /// `room`: what volumes may take on the graphics card. Throws Error (openGl) where the driver lacks what
  /// drawing needs, naming it.
  explicit RayCaster(EmptySpace emptySpace = EmptySpace::skipped, Programs programs = Programs::specialised,
                     const Decisions& decisions = {}, const VolumeRoom& room = {});
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// Who tells what is known of the light that comes to a scene's places, asked before each drawing of a
  /// scene in which light travels; without one it is found when it is first needed, which takes up to
  /// seconds.
  using KnowLight = std::function<LightVolumes(const Scene&)>;
  void askForLight(KnowLight knowLight);

  /// Draws the pixels of `tile` of a picture of `size` pixels into the bound framebuffer as premultiplied
  /// RGBA without background; pixels outside the volume become zero. Any tiling gives the same picture bit
  /// for bit. The framebuffer's lower left corner is the picture's.
  void draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile);

  /// Draws a whole picture off screen in 32-bit floats and reads it back. Tells `effort` how far it is and
  /// asks it after each tile whether to end, with Cancelled.
  Image render(const Scene& scene, const glm::ivec2& size, const Effort& effort = {});

  /// The picture whose light terms are neither clamped nor compressed (DEFINITION section 4), which shows by
  /// how much they overflow. Not limited to 0..1.
  Image renderUnlimited(const Scene& scene, const glm::ivec2& size);

  /// The number of samples of each pixel's ray, row by row from the top, 0 where it misses the volume: what
  /// tests and error figures need beside the picture.
  std::vector<int> sampleCounts(const Scene& scene, const glm::ivec2& size);

  /// What the scene calls for and why. Uploads the scene if it is not the one drawn last.
  EffectPlan plan(const Scene& scene);

  /// On which that depends beside the scene's own numbers.
  SceneFacts sceneFacts(const Scene& scene);

  /// Compiles one of the programs that the scene may soon want and has not yet: its own, of one with
  /// shadows that of its pictures while something moves, then for each of the `neighbours` of the scene one
  /// with every effect that has a neutral value, which can stand in when a slider leaves or crosses that
  /// value. Measures of the volume what those need. Draws one pixel in the middle of a picture of `size` into
  /// the bound framebuffer. For when there is time, over a picture of no account; false when nothing is left
  /// to do.
  bool warmUp(const Scene& scene, const glm::ivec2& size);

  /// Uploads a piece of what the scene needs of its volume, some ten ms long, where it is not there yet; the
  /// share that is, 1 once it is whole.
  double makeReady(const Scene& scene);

  /// Uploads and measures what a picture of the scene needs, without drawing: to time it.
  void prepare(const Scene& scene);

  /// What the volume takes on the graphics card, MB (10⁶ bytes): its scalars and whatever decisions keep for
  /// each voxel beside them.
  double volumeMb() const;

  /// Leaves effects, and what cannot be had without them, out of the pictures drawn from here on, to measure
  /// what they cost: with exactly the program of the rest, even where none is left out (the empty set).
  /// Absent: draws whole pictures again, with whatever program can.
  void leaveOut(std::optional<EffectSet> effects);

  /// What is known of the light that travels in a scene, asked as for a picture of it; none where none does.
  LightVolumes lightOf(const Scene& scene);

  /// Draws in this light, and asks nobody, whatever scene is drawn from here on. Absent: asks again.
  void holdLight(const std::optional<LightVolumes>& light);

  /// The assembled fragment shader with which the scene is drawn; empty where nothing is visible.
  std::string fragmentShader(const Scene& scene);

  /// What can be told of the scene before it is drawn: the plan, and whether every ray gets the samples that
  /// its step asks for and no program need be compiled.
  DrawingFacts facts(const Scene& scene);

  /// How many shader programs were compiled so far: editing a control point must not raise it.
  int compiledPrograms() const;

  /// Of the weights by which the driver mixes voxels; `mostFilterBits` where it weighs in floats.
  int filterBits();

  /// The gradient moduli that the scene drawn last was lit with; meaningful where its lighting reads r.
  const GradientScale& gradientScale() const;

  /// A sentence each where the volume had to be down-sampled to fit the driver's textures and where the last
  /// picture's step would have needed too many samples; empty otherwise.
  Message limitation() const;

private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

} // namespace limn
