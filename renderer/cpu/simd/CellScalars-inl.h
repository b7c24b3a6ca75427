// SPDX-License-Identifier: GPL-3.0-or-later
// What projections need that look at scalars alone, found cell by cell and so exactly: the largest and the
// smallest are those of cubics, their mean is an integral of cubics, a surface is where one first takes the
// isovalue.
#if defined(LIMN_CPU_CELL_SCALARS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_CELL_SCALARS_INL_H
#undef LIMN_CPU_CELL_SCALARS_INL_H
#else
#define LIMN_CPU_CELL_SCALARS_INL_H
#endif

#include "cpu/rays/CellWalk.h"
#include "cpu/simd/ChordCubic-inl.h"
#include "cpu/simd/Samples-inl.h"
#include "scene/steps/CellRule.h"

#include <bit>
#include <limits>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// The chords of one ray, some of them at a time.
template <VoxelSource::Kind kind>
class CellScalars {
public:
  /// Nothing is looked at before `from`, lengths behind the span's begin.
  CellScalars(const PictureTerms& terms, const Ray& ray, double from)
      : m_terms(terms), m_ray(inLengths(terms, ray)), m_samples(terms, m_ray), m_walk(terms, m_ray, from) {}

  /// The largest, smallest or all scalars that are kept: {the largest, {minus the smallest or {their
  /// integral, then the lengths of what is kept.
  glm::dvec2 scalars() {
    if (m_terms.effects.has(Effect::average))
      return integral();
    const float sign = m_terms.effects.has(Effect::mip) ? 1.0f : -1.0f;
    while (next())
      for (int part = 0; part < m_count; part += lanes())
        findLargest(sign, part);
    if (m_largest == nothing)
      return {-std::numeric_limits<double>::infinity(), 0.0};
    return {m_largest, 1.0};
  }

  /// Where the field first reaches the isovalue in what is kept, lengths behind the span's begin; absent
  /// where it stays below.
  std::optional<double> firstHit() {
    while (next())
      for (int part = 0; part < m_count; part += lanes()) {
        VF cubic[4];
        findScalars(part, cubic);
        const VF high = hn::Max(hn::Max(cubic[0], cubic[1]), hn::Max(cubic[2], cubic[3]));
        std::uint32_t open = bitsOf(hn::Ge(high, all(m_terms.isovalue))) & validIn(part);
        if (open != 0)
          keep(cubic);
        for (; open != 0; open &= open - 1) {
          const int lane = std::countr_zero(open);
          if (const std::optional<float> at = hitIn(part, lane)) {
            const int chord = part + lane;
            return m_entries[chord] + double(*at) * (double(m_exits[chord]) - m_entries[chord]);
          }
        }
      }
    return std::nullopt;
  }

private:
  static constexpr int most = 8;
  static constexpr float nothing = -3e38f;

  // Parts of a chord in which enough is kept.
  struct Kept {
    int count = 0;
    float from[2] = {}, to[2] = {};
  };

  bool next() {
    m_count = m_walk.next(m_entries, m_exits, most);
    for (int chord = m_count; chord < most && m_count > 0; ++chord)
      m_entries[chord] = m_exits[chord] = m_exits[m_count - 1];
    return m_count > 0;
  }

  // Which of the chords that registers hold together there are.
  std::uint32_t validIn(int part) const { return ((1u << m_count) - 1) >> part & ((1u << lanes()) - 1); }

  HWY_INLINE V3 indexAt(const float* places, int part) const {
    return m_samples.indexAt(hn::Load(floats, places + part));
  }

  HWY_INLINE void findScalars(int part, VF cubic[4]) const {
    m_samples.field.cubicsAlong(indexAt(m_entries, part), indexAt(m_exits, part), cubic);
  }

  HWY_NOINLINE void findWeights(int part) {
    const V3 from = indexAt(m_entries, part), to = indexAt(m_exits, part);
    const VoxelSource& region = m_terms.region;
    VF weight[4];
    if (region.kind == VoxelSource::Kind::byte)
      Field<VoxelSource::Kind::byte>(region).cubicsAlong(from, to, weight);
    else
      Field<VoxelSource::Kind::half>(region).cubicsAlong(from, to, weight);
    for (int i = 0; i < 4; ++i)
      hn::Store(weight[i], floats, m_weights[i]);
  }

  HWY_INLINE void keep(const VF cubic[4]) {
    for (int i = 0; i < 4; ++i)
      hn::Store(cubic[i], floats, m_cubics[i]);
  }

  HWY_INLINE ChordCubic cubicOf(int lane) const {
    return {{m_cubics[0][lane], m_cubics[1][lane], m_cubics[2][lane], m_cubics[3][lane]}};
  }

  // Of the chord in a lane.
  Kept keptIn(int lane) const {
    Kept kept;
    const ChordCubic weight{{m_weights[0][lane], m_weights[1][lane], m_weights[2][lane], m_weights[3][lane]}};
    const auto least = static_cast<float>(keptWeight);
    if (weight.high() < least)
      return kept;
    if (weight.low() >= least) {
      kept.to[kept.count++] = 1.0f;
      return kept;
    }
    float places[4] = {};
    int count = 1;
    weight.addTurns(0.0f, 1.0f, places, count);
    places[count++] = 1.0f;
    bool isIn = weight.b[0] >= least;
    for (int i = 0; i + 1 < count; ++i) {
      if ((weight.at(places[i + 1]) >= least) == isIn)
        continue;
      const float at = weight.crossing(places[i], places[i + 1], least, !isIn);
      if (isIn)
        kept.to[kept.count++] = at;
      else
        kept.from[kept.count] = at;
      isIn = !isIn;
    }
    if (isIn)
      kept.to[kept.count++] = 1.0f;
    return kept;
  }

  // The largest scalar, or minus the smallest, of some chords and those before.
  HWY_NOINLINE void findLargest(float sign, int part) {
    VF cubic[4];
    findScalars(part, cubic);
    for (int i = 0; i < 4; ++i)
      cubic[i] = hn::Mul(all(sign), cubic[i]);
    const VF ends = hn::Max(cubic[0], cubic[3]);
    const VF hull = hn::Max(hn::Max(cubic[1], cubic[2]), ends);
    // Most chords cannot hold more than what is known.
    const std::uint32_t open = bitsOf(hn::Gt(hull, all(m_largest))) & validIn(part);
    if (open == 0)
      return;
    if (m_terms.effects.has(Effect::region)) {
      keep(cubic);
      findWeights(part);
      for (std::uint32_t rest = open; rest != 0; rest &= rest - 1)
        lookIn(std::countr_zero(rest));
      return;
    }
    const VF largest = hn::Max(ends, largestInside(cubic));
    HWY_ALIGN float found[HWY_MAX_BYTES / 4];
    hn::Store(largest, floats, found);
    for (std::uint32_t rest = open; rest != 0; rest &= rest - 1)
      m_largest = std::max(m_largest, found[std::countr_zero(rest)]);
  }

  // The value at the maximum between a cubic's ends; at its begin where there is none.
  HWY_INLINE static VF largestInside(const VF cubic[4]) {
    const VF d0 = hn::Sub(cubic[1], cubic[0]), d1 = hn::Sub(cubic[2], cubic[1]),
             d2 = hn::Sub(cubic[3], cubic[2]);
    const VF half = hn::Sub(d1, d0);
    const VF second = hn::Sub(hn::Sub(d2, d1), half);
    const VF square = hn::NegMulAdd(second, d0, hn::Mul(half, half));
    const VF root = hn::Sqrt(hn::Max(square, hn::Zero(floats)));
    // Where the slope falls through 0, by the one of two quotients that cancels nothing.
    const Mask falls = hn::Le(half, hn::Zero(floats));
    const VF above = hn::IfThenElse(falls, d0, hn::Neg(hn::Add(half, root)));
    const VF below = hn::IfThenElse(falls, hn::Sub(root, half), second);
    const VF s = hn::Div(above, below);
    const VF zero = hn::Zero(floats), one = all(1.0f);
    const Mask isInside = hn::And(hn::Gt(square, zero), hn::And(hn::Gt(s, zero), hn::Lt(s, one)));
    const VF at = hn::IfThenElseZero(isInside, s);
    const VF r = hn::Sub(one, at);
    const VF rest =
        hn::MulAdd(hn::Mul(all(3.0f), hn::Mul(hn::Mul(r, r), at)), d0,
                   hn::MulAdd(hn::Mul(all(3.0f), hn::Mul(hn::Mul(r, at), at)), hn::Sub(cubic[2], cubic[0]),
                              hn::Mul(hn::Mul(hn::Mul(at, at), at), hn::Sub(cubic[3], cubic[0]))));
    return hn::Add(cubic[0], rest);
  }

  // The largest of the kept parts of one chord.
  void lookIn(int lane) {
    const ChordCubic cubic = cubicOf(lane);
    const Kept kept = keptIn(lane);
    for (int n = 0; n < kept.count; ++n) {
      float places[4] = {kept.from[n], kept.to[n], 0.0f, 0.0f};
      int count = 2;
      cubic.addTurns(kept.from[n], kept.to[n], places, count);
      for (int i = 0; i < count; ++i)
        m_largest = std::max(m_largest, cubic.at(places[i]));
    }
  }

  // One by one, so that the sum does not depend on which chords are computed together.
  glm::dvec2 integral() {
    glm::dvec2 sum(0.0);
    const bool isPart = m_terms.effects.has(Effect::region);
    while (next())
      for (int part = 0; part < m_count; part += lanes()) {
        VF cubic[4];
        findScalars(part, cubic);
        keep(cubic);
        if (isPart)
          findWeights(part);
        for (std::uint32_t rest = validIn(part); rest != 0; rest &= rest - 1) {
          const int lane = std::countr_zero(rest);
          const double length = double(m_exits[part + lane]) - m_entries[part + lane];
          if (isPart)
            sum += length * keptIntegral(lane);
          else
            sum += length * glm::dvec2(cubicOf(lane).mean(), 1.0);
        }
      }
    return sum;
  }

  glm::dvec2 keptIntegral(int lane) const {
    const ChordCubic cubic = cubicOf(lane);
    const Kept kept = keptIn(lane);
    glm::dvec2 sum(0.0);
    for (int n = 0; n < kept.count; ++n)
      sum +=
          (double(kept.to[n]) - kept.from[n]) * glm::dvec2(cubic.part(kept.from[n], kept.to[n]).mean(), 1.0);
    return sum;
  }

  // Where the isovalue is first met on the kept parts of one chord, 0..1.
  HWY_NOINLINE std::optional<float> hitIn(int part, int lane) {
    const ChordCubic cubic = cubicOf(lane);
    Kept kept;
    if (m_terms.effects.has(Effect::region)) {
      findWeights(part);
      kept = keptIn(lane);
    } else {
      kept.to[kept.count++] = 1.0f;
    }
    for (int n = 0; n < kept.count; ++n) {
      float places[4] = {kept.from[n], 0.0f, 0.0f, 0.0f};
      int count = 1;
      if (cubic.at(places[0]) >= m_terms.isovalue)
        return places[0];
      cubic.addTurns(kept.from[n], kept.to[n], places, count);
      places[count++] = kept.to[n];
      for (int i = 0; i + 1 < count; ++i)
        if (cubic.at(places[i + 1]) >= m_terms.isovalue)
          return cubic.crossing(places[i], places[i + 1], m_terms.isovalue, true);
    }
    return std::nullopt;
  }

  const PictureTerms& m_terms;
  Ray m_ray;
  Samples<kind> m_samples;
  CellWalk m_walk;
  int m_count = 0;
  float m_largest = nothing;
  HWY_ALIGN float m_entries[most] = {}, m_exits[most] = {};
  HWY_ALIGN float m_cubics[4][HWY_MAX_BYTES / 4] = {}, m_weights[4][HWY_MAX_BYTES / 4] = {};
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
