// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GpuTimer.h"
#include "raycaster/RayCaster.h"
#include "scene/effects/EffectRows.h"

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// Measures what each effect of a picture costs by leaving it out: a whole picture and one without a row's
/// effects are drawn one after the other, in turn for all rows, after one pixel each that compiles and
/// uploads. So what else the machine does weighs on both sides of a difference alike. A frame at a time, so
/// that a window stays awake. Needs the same context current for every step and for its end.
class EffectCosts {
public:
  /// `rows` are those of the scene's plan; what is off costs nothing and is not measured. A crop box is
  /// measured against the whole volume, a surface against the composite.
  EffectCosts(const Scene& scene, const glm::ivec2& size, const std::vector<EffectRow>& rows, int frames = 7);

  /// Draws the next frame into the bound framebuffer, which has room for `size` pixels. False when none is
  /// left. The caster draws whole pictures again when this returns.
  bool step(RayCaster& caster);

  bool isComplete() const { return m_next == frameCount(); }
  double fraction() const; ///< of the frames, 0..1

  /// One per row; absent where the row is off and before all is measured.
  std::vector<std::optional<EffectCost>> costs() const;

  /// The median time of the whole picture, ms; 0 before all is measured.
  double wholeMs() const;

  /// How the time was measured, a phrase; empty before the first step.
  std::string method() const { return m_timer ? m_timer->description() : std::string(); }

  const glm::ivec2& size() const { return m_size; }
  int frames() const { return m_frames; }

private:
  // The whole picture, or one without the effects of a row.
  struct Variant {
    Scene scene;
    EffectSet leftOut;
    std::vector<double> wholeMs; ///< of the whole pictures drawn beside it
    std::vector<double> ms;
  };
  // One picture that is measured: of a variant, or a whole one beside it.
  struct Turn {
    std::size_t variant = 0;
    bool isWhole = true;
  };
  int frameCount() const;
  Turn turnAt(int measured) const;
  void draw(RayCaster& caster, const Variant& variant) const;

  std::vector<Variant> m_variants;         ///< the whole picture first
  std::vector<std::size_t> m_variantOfRow; ///< 0: not measured
  glm::ivec2 m_size{0};
  int m_frames = 0;
  int m_next = 0;
  std::optional<GpuTimer> m_timer;
};

/// The middle of the values (the mean of both for an even number); 0 for none.
double medianOf(std::vector<double> values);

/// The cost of what is in `with` and not in `without`: times of the same rounds, ms.
EffectCost costBetween(const std::vector<double>& with, const std::vector<double>& without);

} // namespace limn
