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

  /// Draws in the light that travels in this scene from here on, whatever scene is drawn; comes first. False
  /// while it is still being found, on a thread beside: nothing waits for it. That of the first scene is
  /// known.
  virtual bool useLightOf(const Scene& scene) = 0;

  /// On which the effects of a scene depend beside its own numbers.
  virtual SceneFacts factsOf(const Scene& scene) const = 0;

  /// Whether it draws such a scene at all.
  virtual bool canDraw(const Scene&) const { return true; }

  /// Draws a tile of a picture of `size` pixels without some effects, and what cannot be had without them.
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
/// occlusion it tells what they bring to the picture, too. What is off can be measured in a scene that has it
/// besides, one row after the other, because such a scene may need light and fields of its own.
class EffectCosts {
public:
  /// `rows` are those of the scene's plan; what is off costs nothing and is not measured, unless that is
  /// asked for. A crop box is measured against the whole volume, a surface against the composite.
  EffectCosts(const Scene& scene, const glm::ivec2& size, const std::vector<EffectRow>& rows, int frames = 7);

  /// Has what is off measured, too, where it can be switched on alone (withUsualEffect). Before all steps.
  void addWhatIsOff(const CostedDrawing& drawing);

  /// Draws the next frame, one whole picture, with the same drawing each time. False when none is left. Where
  /// `isWaiting` afterwards it drew none, because light is still being found.
  bool step(CostedDrawing& drawing);
  bool isWaiting() const { return m_isWaiting; }

  bool isComplete() const { return m_next == m_turns.size(); }
  double fraction() const; ///< of the frames, 0..1

  /// One per row; absent where the row is off and before all is measured.
  std::vector<std::optional<EffectCost>> costs() const;

  /// One per row: what the picture would take more with an effect that is off, and what that would bring to
  /// it; absent where it is on, was not measured, or not all is measured yet.
  std::vector<std::optional<EffectCost>> wouldCosts() const;

  /// The median time of the whole picture, ms; 0 before all is measured.
  double wholeMs() const;

  const glm::ivec2& size() const { return m_size; }
  int frames() const { return m_frames; }

private:
  // A scene with a row's effects, and one without.
  struct Variant {
    std::size_t row = 0;
    Scene with, without;
    EffectSet leftOut;                      ///< without, where it is in the picture
    bool isOff = false;                     ///< in the picture, which then is the one without
    std::vector<double> withMs;             ///< of the pictures drawn beside those without
    std::vector<double> ms;                 ///< without
    std::optional<PictureChange> brought{}; ///< by what is left out
  };
  // What is done with one picture of a variant.
  enum class Purpose { calibrate, prepare, compare, measure };
  struct Turn {
    Purpose purpose = Purpose::measure;
    std::size_t variant = 0;
    bool isWith = true;
  };
  void planPicture();
  void planRounds(std::size_t first, std::size_t end);
  void draw(CostedDrawing& drawing, const Turn& turn);
  std::vector<std::optional<EffectCost>> costsOf(bool areOff) const;

  Scene m_scene;
  std::vector<EffectRow> m_rows;
  std::vector<Variant> m_variants; ///< the picture alone first
  std::vector<Turn> m_turns;
  std::optional<Image> m_with; ///< the last picture to be compared with
  glm::ivec2 m_size{0};
  int m_frames = 0;
  std::size_t m_next = 0;
  bool m_isWaiting = false;
};

/// Measures the effects of a picture's plan with what draws it.
std::unique_ptr<EffectMeasurement> measurementOf(std::unique_ptr<CostedDrawing> drawing, const Scene& scene,
                                                 const glm::ivec2& size, const EffectPlan& plan);

/// The middle of the values (the mean of both for an even number); 0 for none.
double medianOf(std::vector<double> values);

/// The cost of what is in `with` and not in `without`: times of the same rounds, ms.
EffectCost costBetween(const std::vector<double>& with, const std::vector<double>& without);

} // namespace limn
