// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "scene/Scene.h"
#include "scene/effects/EffectRows.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// What draws the pictures whose times are compared, and tells what drawing takes.
class CostedDrawing {
public:
  using Work = std::function<void()>;
  virtual ~CostedDrawing() = default;

  /// Draws a tile of a picture of `size` pixels without some effects, and what cannot be had without them.
  /// All are drawn in the light that travels in the first scene: none waits for light to be found.
  virtual void draw(const Scene& scene, EffectSet leftOut, const glm::ivec2& size, const PixelRect& tile) = 0;

  /// The whole picture so drawn.
  virtual Image picture(const Scene& scene, EffectSet leftOut, const glm::ivec2& size) = 0;

  /// Comes first: draws a typical picture to find out how time is measured honestly.
  virtual void calibrate(const Work& work) = 0;

  /// The time of `work`, which draws, until all of it is drawn, ms.
  virtual double measureMs(const Work& work) = 0;

  /// How the time is measured, a phrase; empty before `calibrate`.
  virtual std::string method() const = 0;
};

/// Measures what each effect of a picture costs by leaving it out: a whole picture and one without a row's
/// effects are drawn one after the other, in turn for all rows, after one pixel each that compiles and
/// uploads. So what else the machine does weighs on both sides of a difference alike. One whole picture at
/// a time, so that a window stays awake; a drawing may take more to calibrate itself. Of shadows and
/// occlusion it tells what they bring to the picture, too.
class EffectCosts {
public:
  /// `rows` are those of the scene's plan; what is off costs nothing and is not measured. A crop box is
  /// measured against the whole volume, a surface against the composite.
  EffectCosts(const Scene& scene, const glm::ivec2& size, const std::vector<EffectRow>& rows, int frames = 7);

  /// Draws the next frame, one whole picture, with the same drawing each time. False when none is left.
  bool step(CostedDrawing& drawing);

  bool isComplete() const { return m_next == frameCount(); }
  double fraction() const; ///< of the frames, 0..1

  /// One per row; absent where the row is off and before all is measured.
  std::vector<std::optional<EffectCost>> costs() const;

  /// The median time of the whole picture, ms; 0 before all is measured.
  double wholeMs() const;

  const glm::ivec2& size() const { return m_size; }
  int frames() const { return m_frames; }

private:
  // The whole picture, or one without the effects of a row.
  struct Variant {
    Scene scene;
    EffectSet leftOut;
    std::vector<double> wholeMs; ///< of the whole pictures drawn beside it
    std::vector<double> ms;
    std::optional<PictureChange> brought{}; ///< by what is left out
  };
  // One picture that is measured: of a variant, or a whole one beside it.
  struct Turn {
    std::size_t variant = 0;
    bool isWhole = true;
  };
  int frameCount() const;
  int firstVariant() const { return m_comparesLight ? 2 : 1; }
  Turn turnAt(int measured) const;

  std::vector<Variant> m_variants;         ///< the whole picture first
  std::vector<std::size_t> m_variantOfRow; ///< 0: not measured
  bool m_comparesLight = false;            ///< the second frame is the whole picture, to be compared with
  std::optional<Image> m_whole;            ///< that
  glm::ivec2 m_size{0};
  int m_frames = 0;
  int m_next = 0;
};

/// Measures the effects of a picture's plan with what draws it.
std::unique_ptr<EffectMeasurement> measurementOf(std::unique_ptr<CostedDrawing> drawing, const Scene& scene,
                                                 const glm::ivec2& size, const EffectPlan& plan);

/// The middle of the values (the mean of both for an even number); 0 for none.
double medianOf(std::vector<double> values);

/// The cost of what is in `with` and not in `without`: times of the same rounds, ms.
EffectCost costBetween(const std::vector<double>& with, const std::vector<double>& without);

} // namespace limn
