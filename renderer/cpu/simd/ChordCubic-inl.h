// SPDX-License-Identifier: GPL-3.0-or-later
// What a trilinear field is along a chord within one of its cells: a cubic.
#if defined(LIMN_CPU_CHORD_CUBIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_CHORD_CUBIC_INL_H
#undef LIMN_CPU_CHORD_CUBIC_INL_H
#else
#define LIMN_CPU_CHORD_CUBIC_INL_H
#endif

#include "cpu/simd/Math-inl.h"

#include <algorithm>
#include <cmath>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// A cubic on 0..1 by its Bernstein coefficients, whose hull holds it.
struct ChordCubic {
  float b[4] = {};

  float low() const { return std::min(std::min(b[0], b[1]), std::min(b[2], b[3])); }
  float high() const { return std::max(std::max(b[0], b[1]), std::max(b[2], b[3])); }
  float mean() const { return 0.25f * (b[0] + b[1] + b[2] + b[3]); }

  float at(float s) const {
    const float r = 1.0f - s;
    return r * r * (r * b[0] + 3.0f * s * b[1]) + s * s * (3.0f * r * b[2] + s * b[3]);
  }

  float slopeAt(float s) const {
    const float r = 1.0f - s;
    return 3.0f * (r * r * (b[1] - b[0]) + 2.0f * r * s * (b[2] - b[1]) + s * s * (b[3] - b[2]));
  }

  /// The part from `from` to `to` as a cubic of its own.
  ChordCubic part(float from, float to) const {
    if (from == 0.0f && to == 1.0f)
      return *this;
    return {{polar(from, from, from), polar(from, from, to), polar(from, to, to), polar(to, to, to)}};
  }

  /// Adds the places between `from` and `to` where it turns, in order: two at most.
  void addTurns(float from, float to, float* places, int& count) const {
    const double d0 = double(b[1]) - b[0], d1 = double(b[2]) - b[1], d2 = double(b[3]) - b[2];
    if (d0 * d1 >= 0.0 && d1 * d2 >= 0.0 && d0 * d2 >= 0.0)
      return;
    const double second = d0 - 2.0 * d1 + d2, half = d1 - d0;
    const double root = half * half - second * d0;
    if (root <= 0.0)
      return;
    // Of both quotients the one that cancels nothing.
    const double q = -(half + std::copysign(std::sqrt(root), half));
    double one = second != 0.0 ? q / second : 2.0;
    double other = q != 0.0 ? d0 / q : 2.0;
    if (other < one)
      std::swap(one, other);
    for (const double at : {one, other})
      if (at > from && at < to)
        places[count++] = static_cast<float>(at);
  }

  /// Where it comes to a value between two places, from one to the other of which it runs one way: by
  /// Newton's steps from the chord, and halves where one would leave what is known to hold it.
  float crossing(float from, float to, float value, bool rises) const {
    const float atFrom = at(from) - value, atTo = at(to) - value;
    if (rises ? atFrom >= 0.0f : atFrom < 0.0f)
      return from;
    float s = from + (to - from) * (atFrom / (atFrom - atTo));
    for (int k = 0; k < mostNewtonSteps; ++k) {
      const float found = at(s) - value;
      (rises == (found < 0.0f) ? from : to) = s;
      float next = s - found / slopeAt(s);
      if (!(next > from && next < to))
        next = 0.5f * (from + to);
      const float step = std::abs(next - s);
      s = next;
      // The next step would be its square, and less than floats tell.
      if (step < 1e-5f)
        break;
    }
    return s;
  }

private:
  HWY_INLINE static float mixed(float p, float q, float w) { return p + w * (q - p); }

  HWY_INLINE float polar(float x, float y, float z) const {
    const float p0 = mixed(b[0], b[1], x), p1 = mixed(b[1], b[2], x), p2 = mixed(b[2], b[3], x);
    return mixed(mixed(p0, p1, y), mixed(p1, p2, y), z);
  }

  static constexpr int mostNewtonSteps = 24;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
