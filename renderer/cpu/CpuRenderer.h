// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/SceneData.h"
#include "cpu/paths/NoiseFilter.h"
#include "cpu/paths/PathPicture.h"
#include "engine/DrawingEngine.h"

namespace limn {

/// Draws scenes on the processor in single precision, on several threads. Keeps what it made of one scene for
/// the next. Needs no OpenGL.
class CpuRenderer {
public:
  /// Stepping over empty space changes no bit of a picture; tests switch it off to show that.
  enum class EmptySpace { skipped, sampled };

  /// By which weights voxels are mixed at a sample. In 8 bits, as graphics cards have them, its place between
  /// voxels is rounded to 1/256: what tests know of a card without one, beside GLSL that does the same
  /// (glsl/decisions/Decisions). No command draws so. What keeps a tolerance takes no samples and stays.
  enum class Weights { floats, eightBits };

  /// How error-controlled steps are taken: cell by cell, as the reference takes them, or where it can be in
  /// equal steps first and cell by cell only where those tell that they are too few (cpu/README.md), which
  /// errs as much with the same fineness and takes less time.
  enum class Tolerance { cells, stepsFirst };

  /// `threads` of the processor, 0: all. Throws Error (usage) where LIMN_CPU_TARGET asks for what the
  /// processor does not have (cpu/simd/InstructionSet.h).
  explicit CpuRenderer(int threads = 0, EmptySpace emptySpace = EmptySpace::skipped,
                       Weights weights = Weights::floats, Tolerance tolerance = Tolerance::cells);

  /// As whoever draws for users does.
  CpuRenderer(int threads, Tolerance tolerance)
      : CpuRenderer(threads, EmptySpace::skipped, Weights::floats, tolerance) {}

  /// The pixels of `tile` of a picture of `size` pixels: premultiplied RGBA without background. Any tiling
  /// and any number of threads give the same picture bit for bit. Asks `isCancelled`, which may be empty, at
  /// least every 10 ms; true ends it with Cancelled. Throws Error.
  Image draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
             const std::function<bool()>& isCancelled = {});

  Image render(const Scene& scene, const glm::ivec2& size);

  /// How far the paths of a picture of physical light are, and the linear radiance that they found times
  /// alpha; absent where it is not among the last few drawn. `draw` follows as many paths of each pixel as
  /// the scene asks for (pathsOf) and goes on from those that were followed before.
  std::optional<PathFigures> pathFigures(const Scene& scene, const glm::ivec2& size) const;
  std::optional<Image> radiance(const Scene& scene, const glm::ivec2& size) const;
  /// A picture of physical light without the noise that its paths left, as far as a filter can tell it from
  /// what is there (cpu/paths/NoiseFilter); absent as above. Throws Cancelled.
  std::optional<cpu::FilteredPaths> withoutNoise(const Scene& scene, const glm::ivec2& size,
                                                 const Effort& effort = {});
  /// How many paths of each pixel a picture goes on from (DrawingEngine).
  int followedPaths(const Scene& scene, const glm::ivec2& size) const;
  /// Of each pixel the standard error of the worst of its display colours, 255 levels, rows from the top;
  /// less than 0 where nothing is covered. Empty where it is not among the last few drawn.
  std::vector<float> pathErrors(const Scene& scene, const glm::ivec2& size) const;

  /// The same without some effects, and without what cannot be had without them, to measure what they cost;
  /// where light travels and some is given, in that.
  Image drawWithout(EffectSet leftOut, const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                    const LightVolumes* light = nullptr);

  /// What is found on nodes of the light that travels in a scene, as for a picture of it; none where none
  /// does, or it is found along paths.
  LightVolumes lightOf(const Scene& scene);

  /// The picture whose light terms are not limited (DEFINITION section 4).
  Image renderUnlimited(const Scene& scene, const glm::ivec2& size);

  /// What the scene calls for and why. Reads the volume where it is not the one drawn last.
  EffectPlan plan(const Scene& scene, const std::function<bool()>& isCancelled = {});

  /// On which that depends beside the scene's own numbers.
  SceneFacts sceneFacts(const Scene& scene, const std::function<bool()>& isCancelled = {});

  /// Reads the scene's volume, on this renderer's threads; tells `effort` how far it is. Throws Cancelled.
  void makeReady(const Scene& scene, const Effort& effort) { m_data.makeReady(scene, effort); }
  double steepestPerMm() { return m_data.steepestPerMm(); }
  const GradientScale& gradientScale() const { return m_data.gradientScale(); }
  double memoryMb() const { return m_data.memoryMb() + 1e-6 * static_cast<double>(m_paths.bytes()); }

  /// One sentence where rays get fewer samples than asked for, otherwise empty.
  const Message& limitation() const { return m_limitation; }

  /// Who draws: "CPU engine (AVX2, 2 threads)".
  std::string name() const;

private:
  using Choose = EffectSet (*)(EffectSet needed, EffectSet others);
  Image drawWith(const Scene& scene, const glm::ivec2& size, const PixelRect& tile, Choose choose,
                 EffectSet others, const std::function<bool()>& isCancelled,
                 const LightVolumes* light = nullptr);

  Image drawPaths(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                  const std::function<bool()>& isCancelled);

  int m_threads;
  cpu::SceneData m_data;
  cpu::PathPictures m_paths;
  Message m_limitation;
};

} // namespace limn
