// SPDX-License-Identifier: GPL-3.0-or-later
// What the samples of a ray in equal steps gave, kept so that it can be told where they were too few.
#if defined(LIMN_CPU_SAMPLE_LOG_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_SAMPLE_LOG_INL_H
#undef LIMN_CPU_SAMPLE_LOG_INL_H
#else
#define LIMN_CPU_SAMPLE_LOG_INL_H
#endif

#include "cpu/simd/Function-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// For pictures that need none.
struct NoLog {
  static constexpr bool isKept = false;
  template <class WeightAt>
  void lookBetween(int, VF, Mask, const WeightAt&) {}
  void add(VF, VF, VF, const V3&, int) {}
};

/// What lies between a sample and the one before and that neither tells of: its optical depth at most and,
/// once the log is closed, how far it may put the pixel off.
struct Missed {
  int sample;
  float most;
};

/// Samples that show, front to back, column by column.
class SampleLog {
public:
  static constexpr bool isKept = true;

  /// Samples that are judged together: as many on every instruction set.
  static constexpr int chunk = 8;

  /// Registers are read from before the first sample and stored whole behind the last, chunks likewise;
  /// groups may run over the last sample that shows.
  static constexpr int margin = 16;
  static_assert(margin >= 2 * chunk && chunk % (hn::MaxLanes(floats)) == 0);

  /// Of a ray's samples that may show; the function is what classifies them, and gradients make its opacities
  /// `mostFactor` times as large at most.
  SampleLog(const PiecewiseTable& table, const Function& function, const Ray& ray, float mostFactor)
      : m_table(table), m_function(function), m_units(ray.units), m_mostFactor(mostFactor),
        m_room(static_cast<std::size_t>(ray.to - ray.from + 3 * margin)),
        m_columns(new float[columns * m_room]) {
    for (int column : {stepColumn, alphaColumn})
      std::fill_n(m_columns.get() + column * m_room, margin, column == stepColumn ? nowhere : 0.0f);
  }

  /// Looks for segments of the function that the scalars ran through between the samples of the group from
  /// sample `i` on, or between them and the last of the group before, and for peaks between two. `weightAt`
  /// gives the share of a sample's opacity that a region keeps.
  template <class WeightAt>
  HWY_INLINE void lookBetween(int i, VF scalar, Mask isInside, const WeightAt& weightAt) {
    const VI segment = m_function.segmentsOf(scalar);
    HWY_ALIGN std::int32_t segments[HWY_MAX_BYTES / 4 + 1];
    HWY_ALIGN float scalars[HWY_MAX_BYTES / 4 + 1];
    segments[0] = m_lastSegment < 0 ? hn::GetLane(segment) : m_lastSegment;
    scalars[0] = m_lastScalar;
    hn::StoreU(segment, ints, segments + 1);
    hn::StoreU(scalar, floats, scalars + 1);
    m_lastSegment = segments[lanes()];
    m_lastScalar = scalars[lanes()];
    const auto isSame = hn::RebindMask(floats, hn::Eq(segment, hn::LoadU(ints, segments)));
    for (std::uint32_t bits = bitsOf(hn::AndNot(isSame, isInside)); bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      float most = mostBetween(segments[lane], scalars[lane], segments[lane + 1], scalars[lane + 1]);
      if (most > 0.0f)
        most *= std::max(weightAt(i + lane - 1), weightAt(i + lane));
      if (most > 0.0f)
        m_missed.push_back({i + lane, most * m_units / std::abs(scalars[lane + 1] - scalars[lane])});
    }
  }

  /// Adds the first `count` samples of some: where they lie in steps, what each takes of the light that
  /// reaches it, its share of the pixel, and its lit colour.
  HWY_INLINE void add(VF step, VF alpha, VF share, const V3& lit, int count) {
    hn::StoreU(step, floats, steps() + m_count);
    hn::StoreU(alpha, floats, alphas() + m_count);
    hn::StoreU(share, floats, shares() + m_count);
    hn::StoreU(lit.x, floats, colors(0) + m_count);
    hn::StoreU(lit.y, floats, colors(1) + m_count);
    hn::StoreU(lit.z, floats, colors(2) + m_count);
    m_count += count;
  }

  /// To be called once, behind the last sample. Behind one that left no light nothing counts: how far the ray
  /// was looked at there depends on which samples were computed together.
  void close(bool hasEnded) {
    if (hasEnded) {
      int last = m_count;
      while (last > 0 && !(shares()[last - 1] > 0.0f))
        --last;
      const float end = last > 0 ? steps()[last - 1] : 0.0f;
      std::erase_if(m_missed,
                    [end](const Missed& missed) { return static_cast<float>(missed.sample) > end; });
    }
    float reaching = 1.0f;
    int n = 0;
    for (Missed& missed : m_missed) {
      for (; n < m_count && steps()[n] < static_cast<float>(missed.sample); ++n)
        reaching -= shares()[n];
      missed.most = reaching * -std::expm1(-missed.most);
    }
    for (int lane = 0; lane < margin; ++lane) {
      steps()[m_count + lane] = nowhere;
      alphas()[m_count + lane] = shares()[m_count + lane] = 0.0f;
    }
  }

  int count() const { return m_count; }
  const std::vector<Missed>& missed() const { return m_missed; }

  float* steps() const { return columnAt(stepColumn); }
  float* alphas() const { return columnAt(alphaColumn); }
  float* shares() const { return columnAt(shareColumn); }
  float* colors(int channel) const { return columnAt(colorColumn + channel); }
  float* errors() const { return columnAt(errorColumn); } ///< room for what is found of each

private:
  enum { stepColumn, alphaColumn, shareColumn, colorColumn, errorColumn = colorColumn + 3, columns };
  static constexpr float nowhere = -10.0f;

  float* columnAt(int column) const {
    return m_columns.get() + static_cast<std::size_t>(column) * m_room + margin;
  }

  const glm::vec4* texelsOf(int segment) const {
    return &m_table.segments[4 * static_cast<std::size_t>(segment)];
  }

  static float opacityIn(const glm::vec4* texels, float scalar) {
    return texels[0].a + texels[1].a * (scalar - texels[2].x);
  }

  float extinctionOf(float opacity) const {
    return -std::log1p(-std::clamp(m_mostFactor * opacity, 0.0f, 1.0f - 1e-7f));
  }

  // The extinction over the unit distance, times scalars, of what lies between two scalars and neither tells
  // of: segments between theirs or, where these meet, half of the peak above both. At most.
  float mostBetween(int one, float a, int other, float b) const {
    if (one > other) {
      std::swap(one, other);
      std::swap(a, b);
    }
    if (one + 1 == other) {
      const glm::vec4 *before = texelsOf(one), *behind = texelsOf(other);
      const float peak = std::max(opacityIn(before, before[2].y), behind[0].a);
      const float ends = std::max(opacityIn(before, a), opacityIn(behind, b));
      return peak > ends ? 0.5f * (b - a) * (extinctionOf(peak) - extinctionOf(ends)) : 0.0f;
    }
    float sum = 0.0f;
    for (int segment = one + 1; segment < other; ++segment) {
      const glm::vec4* texels = texelsOf(segment);
      const float width = texels[2].y - texels[2].x;
      if (width > 0.0f)
        sum += width * extinctionOf(std::max(texels[0].a, opacityIn(texels, texels[2].y)));
    }
    return sum;
  }

  const PiecewiseTable& m_table;
  const Function& m_function;
  float m_units; // a step in unit distances
  float m_mostFactor;
  std::size_t m_room;
  std::unique_ptr<float[]> m_columns; // not set to 0: most of it is never read
  std::vector<Missed> m_missed;
  int m_count = 0;
  std::int32_t m_lastSegment = -1; // of the last sample that was looked at
  float m_lastScalar = 0.0f;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
