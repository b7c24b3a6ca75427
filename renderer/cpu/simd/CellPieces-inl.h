// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a ray on which everything is smooth: within one cell the scalars are a cubic, and within one
// segment of the function its colours and opacities are linear in them.
#if defined(LIMN_CPU_CELL_PIECES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_CELL_PIECES_INL_H
#undef LIMN_CPU_CELL_PIECES_INL_H
#else
#define LIMN_CPU_CELL_PIECES_INL_H
#endif

#include "cpu/rays/CellWalk.h"
#include "cpu/simd/BlocksAlike-inl.h"
#include "cpu/simd/ChordCubic-inl.h"
#include "cpu/simd/Samples-inl.h"
#include "scene/steps/CellRule.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// Some consecutive pieces, column by column. As many on every instruction set, so that all decide alike.
struct Pieces {
  static constexpr int most = 8;
  static constexpr int room = 2 * most; ///< registers are stored whole behind the last piece

  int count = 0;
  bool areWhole = true;                           ///< a region is known to keep all of each
  HWY_ALIGN float from[room] = {}, to[room] = {}; ///< lengths behind the span's begin
  HWY_ALIGN float cubic[4][room] = {};            ///< Bernstein coefficients of the scalars
  HWY_ALIGN std::int32_t segment[room] = {};      ///< of the function, that all of a piece lies in
  HWY_ALIGN float start[most] = {}, low[most] = {}, high[most] = {}; ///< of the segment; the scalars it holds
  HWY_ALIGN float values[4][most] = {}, slopes[4][most] = {};        ///< its colour and opacity

  void move(int n, int place) {
    for (float* column : {from, to, start, low, high})
      column[place] = column[n];
    segment[place] = segment[n];
    for (int i = 0; i < 4; ++i) {
      cubic[i][place] = cubic[i][n];
      values[i][place] = values[i][n];
      slopes[i][place] = slopes[i][n];
    }
  }
};

/// Gives piece `n` the part from `a` to `b` of a cubic on 0..1.
HWY_INLINE void cutCubic(const ChordCubic& cubic, float a, float b, Pieces& pieces, int n) {
  const ChordCubic part = cubic.part(a, b);
  for (int i = 0; i < 4; ++i)
    pieces.cubic[i][n] = part.b[i];
}

/// Makes part `part` of piece `n` a piece of its own, at that place among others.
inline void cutPiece(const Pieces& of, int n, int part, Pieces& pieces) {
  const float a = static_cast<float>(part) / cellParts, b = static_cast<float>(part + 1) / cellParts;
  const float length = of.to[n] - of.from[n];
  pieces.from[part] = of.from[n] + a * length;
  pieces.to[part] = part + 1 == cellParts ? of.to[n] : of.from[n] + b * length;
  const ChordCubic cubic{{of.cubic[0][n], of.cubic[1][n], of.cubic[2][n], of.cubic[3][n]}};
  cutCubic(cubic, a, b, pieces, part);
  pieces.segment[part] = of.segment[n];
  pieces.start[part] = of.start[n];
  pieces.low[part] = of.low[n];
  pieces.high[part] = of.high[n];
  for (int channel = 0; channel < 4; ++channel) {
    pieces.values[channel][part] = of.values[channel][n];
    pieces.slopes[channel][part] = of.slopes[channel][n];
  }
}

/// Cuts a ray into pieces, as far as they show.
template <VoxelSource::Kind kind>
class PieceMaker {
public:
  /// Nothing shows before `from`, lengths behind the span's begin.
  PieceMaker(const PictureTerms& terms, const Samples<kind>& samples, double from)
      : m_samples(samples), m_table(*terms.function), m_isPart(terms.effects.has(Effect::region)),
        m_whole(terms, samples.ray), m_walk(terms, samples.ray, from) {}

  /// Adds the next pieces that show to those that are there; false where none is left.
  bool fill(Pieces& pieces) {
    const int before = pieces.count;
    if (before == 0)
      pieces.areWhole = true;
    while (pieces.count < Pieces::most && (isInCell() || m_open != 0 || walk())) {
      if (isInCell())
        cut(pieces);
      else if (const std::uint32_t run = wholeCells(Pieces::most - pieces.count); run != 0)
        addWhole(run, pieces);
      else
        enterCell();
    }
    if (pieces.count == before)
      return false;
    describe(pieces);
    return true;
  }

private:
  static constexpr int cells = 8;
  static constexpr float leastShare = 1e-6f; // of a chord, by which a cut goes on at least

  // What the first and the last segment hold, which reach on without end.
  static constexpr float lowest = -3e38f, highest = 3e38f;

  bool isInCell() const { return m_shares < 1.0f; }

  // Goes on to the next cells in some of which something may show.
  bool walk() {
    while (m_open == 0) {
      m_count = m_walk.next(m_entries, m_exits, cells);
      if (m_count == 0)
        return false;
      look();
    }
    return true;
  }

  // The next open cells, `most` at most, that lie in one segment each.
  std::uint32_t wholeCells(int most) const {
    const std::uint32_t others = m_open & ~m_inSegment;
    std::uint32_t run = others == 0 ? m_open : m_open & ((others & (~others + 1)) - 1);
    while (std::popcount(run) > most)
      run ^= std::bit_floor(run);
    return run;
  }

  // Takes some open cells as they are.
  HWY_NOINLINE void addWhole(std::uint32_t run, Pieces& pieces) {
    m_open ^= run;
    pieces.areWhole = pieces.areWhole && m_areWhole;
    for (int part = 0; part < cells; part += lanes()) {
      const auto bits = static_cast<std::uint8_t>(run >> part & ((1u << lanes()) - 1));
      if (bits == 0)
        continue;
      const std::uint8_t bytes[8] = {bits};
      const Mask taken = hn::LoadMaskBits(floats, bytes);
      const auto add = [&](const float* column, float* to) {
        hn::StoreU(hn::Compress(hn::Load(floats, column + part), taken), floats, to + pieces.count);
      };
      add(m_entries, pieces.from);
      add(m_exits, pieces.to);
      for (int i = 0; i < 4; ++i)
        add(m_cubics[i], pieces.cubic[i]);
      hn::StoreU(hn::Compress(hn::Load(ints, m_segments + part), hn::RebindMask(ints, taken)), ints,
                 pieces.segment + pieces.count);
      pieces.count += std::popcount(bits);
    }
  }

  // Goes on to the next open cell, to cut it.
  void enterCell() {
    m_cell = std::countr_zero(m_open);
    m_open &= m_open - 1;
    for (int i = 0; i < 4; ++i)
      m_cubic.b[i] = m_cubics[i][m_cell];
    m_lowest = m_cubic.low();
    m_highest = m_cubic.high();
    m_segment = static_cast<std::size_t>(m_segments[m_cell]);
    m_shares = 0.0f;
  }

  // The scalars in the cells that were walked, in which of them something may show, and which lie in one
  // segment.
  HWY_NOINLINE void look() {
    for (int cell = m_count; cell < cells; ++cell)
      m_entries[cell] = m_exits[cell] = m_exits[m_count - 1];
    m_inSegment = 0;
    m_areWhole = !m_isPart || m_whole.isWhole(m_entries[0], m_exits[m_count - 1]);
    for (int part = 0; part < m_count; part += lanes()) {
      VF cubic[4];
      m_samples.field.cubicsAlong(m_samples.indexAt(hn::Load(floats, m_entries + part)),
                                  m_samples.indexAt(hn::Load(floats, m_exits + part)), cubic);
      const VF low = hn::Min(hn::Min(cubic[0], cubic[1]), hn::Min(cubic[2], cubic[3]));
      const VF high = hn::Max(hn::Max(cubic[0], cubic[1]), hn::Max(cubic[2], cubic[3]));
      Mask seen = m_samples.function.mayBeSeenBetween(low, high);
      if (!m_areWhole)
        seen = hn::And(seen, hn::Gt(largestWeight(part), hn::Zero(floats)));
      if (hn::AllFalse(floats, seen))
        continue;
      const VI segment = m_samples.function.segmentsOf(cubic[0]);
      const VF start = m_samples.function.startOf(segment);
      const Mask isInOne =
          hn::And(hn::Lt(high, endOf(segment)), hn::Not(hn::Lt(low, beginOf(segment, start))));
      // An opacity that is linear shows somewhere if it does at an end.
      const VF slope = m_samples.function.template slopeOf<3>(segment);
      const VF gain = hn::Max(hn::Mul(hn::Sub(low, start), slope), hn::Mul(hn::Sub(high, start), slope));
      const Mask shows =
          hn::Gt(hn::Add(gain, m_samples.function.template valueOf<3>(segment)), hn::Zero(floats));
      m_open |= bitsOf(hn::And(seen, hn::Or(shows, hn::Not(isInOne)))) << part;
      m_inSegment |= bitsOf(isInOne) << part;
      for (int i = 0; i < 4; ++i)
        hn::Store(cubic[i], floats, m_cubics[i] + part);
      hn::Store(segment, ints, m_segments + part);
    }
    m_open &= (1u << m_count) - 1;
  }

  // The scalars that segments hold.
  HWY_INLINE VF beginOf(VI segment, VF start) const {
    const Mask isFirst = hn::RebindMask(floats, hn::Eq(segment, hn::Zero(ints)));
    return hn::IfThenElse(isFirst, all(lowest), start);
  }

  HWY_INLINE VF endOf(VI segment) const {
    const Mask isLast = hn::RebindMask(floats, hn::Eq(segment, hn::Set(ints, m_table.segmentCount - 1)));
    return hn::IfThenElse(isLast, all(highest), m_samples.function.endOf(segment));
  }

  // Adds to pieces what their segments say.
  HWY_NOINLINE void describe(Pieces& pieces) const {
    const Function& function = m_samples.function;
    for (int part = 0; part < pieces.count; part += lanes()) {
      const VI segment = hn::Load(ints, pieces.segment + part);
      const VF start = function.startOf(segment);
      hn::Store(start, floats, pieces.start + part);
      hn::Store(beginOf(segment, start), floats, pieces.low + part);
      hn::Store(endOf(segment), floats, pieces.high + part);
      hn::Store(function.template valueOf<0>(segment), floats, pieces.values[0] + part);
      hn::Store(function.template valueOf<1>(segment), floats, pieces.values[1] + part);
      hn::Store(function.template valueOf<2>(segment), floats, pieces.values[2] + part);
      hn::Store(function.template valueOf<3>(segment), floats, pieces.values[3] + part);
      hn::Store(function.template slopeOf<0>(segment), floats, pieces.slopes[0] + part);
      hn::Store(function.template slopeOf<1>(segment), floats, pieces.slopes[1] + part);
      hn::Store(function.template slopeOf<2>(segment), floats, pieces.slopes[2] + part);
      hn::Store(function.template slopeOf<3>(segment), floats, pieces.slopes[3] + part);
    }
    // A look is asked for its own value: where it steps at the end of a piece, for that on this side.
    if (m_samples.looks.areAny())
      for (int n = 0; n < pieces.count; ++n)
        pieces.high[n] = std::nextafter(pieces.high[n], pieces.low[n]);
  }

  // The most that the kept region leaves of opacities in some cells.
  HWY_NOINLINE VF largestWeight(int part) const {
    const V3 from = m_samples.indexAt(hn::Load(floats, m_entries + part));
    const V3 to = m_samples.indexAt(hn::Load(floats, m_exits + part));
    const VoxelSource& region = m_samples.terms.region;
    VF weight[4];
    if (region.kind == VoxelSource::Kind::byte)
      Field<VoxelSource::Kind::byte>(region).cubicsAlong(from, to, weight);
    else
      Field<VoxelSource::Kind::half>(region).cubicsAlong(from, to, weight);
    return hn::Max(hn::Max(weight[0], weight[1]), hn::Max(weight[2], weight[3]));
  }

  // Cuts the next piece off the cell, up to where the scalars leave the segment.
  HWY_NOINLINE void cut(Pieces& pieces) {
    const glm::vec4* texels = &m_table.segments[4 * m_segment];
    const bool isFirst = m_segment == 0;
    const bool isLast = static_cast<int>(m_segment) + 1 == m_table.segmentCount;
    const float low = isFirst ? lowest : texels[2].x;
    const float high = isLast ? highest : texels[2].y;
    const float from = m_shares;
    std::size_t next = m_segment;
    m_shares = 1.0f;
    if (m_highest >= high || m_lowest < low)
      leave(from, low, high, next);
    // An opacity that is linear shows somewhere if it does at an end.
    const float faint = std::clamp(m_lowest, low, high) - texels[2].x;
    const float dense = std::clamp(m_highest, low, high) - texels[2].x;
    const bool shows = std::max(faint * texels[1].a, dense * texels[1].a) + texels[0].a > 0.0f;
    if (shows && m_shares > from)
      add(pieces, from);
    m_segment = next;
  }

  // Finds where behind `from` the scalars first leave [low, high), and for which segment.
  void leave(float from, float low, float high, std::size_t& next) {
    float places[4] = {from, 0.0f, 0.0f, 0.0f};
    int count = 1;
    m_cubic.addTurns(from, 1.0f, places, count);
    places[count++] = 1.0f;
    for (int i = 0; i + 1 < count; ++i) {
      const float end = m_cubic.at(places[i + 1]);
      const bool isAbove = end >= high;
      if (!isAbove && !(end < low))
        continue;
      m_shares = std::max(m_cubic.crossing(places[i], places[i + 1], isAbove ? high : low, isAbove),
                          from + leastShare);
      // Steps of the function are segments of no length.
      do
        next += isAbove ? 1 : -1;
      while (!(m_table.segments[4 * next + 2].y > m_table.segments[4 * next + 2].x) && next > 0 &&
             static_cast<int>(next) + 1 < m_table.segmentCount);
      if (m_shares < 1.0f)
        return;
      m_shares = 1.0f;
      return;
    }
  }

  void add(Pieces& pieces, float from) {
    const int n = pieces.count++;
    pieces.areWhole = pieces.areWhole && m_areWhole;
    const float begin = m_entries[m_cell], length = m_exits[m_cell] - begin;
    pieces.from[n] = from == 0.0f ? begin : begin + from * length;
    pieces.to[n] = m_shares == 1.0f ? m_exits[m_cell] : begin + m_shares * length;
    cutCubic(m_cubic, from, m_shares, pieces, n);
    pieces.segment[n] = static_cast<std::int32_t>(m_segment);
  }

  const Samples<kind>& m_samples;
  const PiecewiseTable& m_table;
  const bool m_isPart; // a region is kept
  WholeAlong m_whole;
  CellWalk m_walk;
  int m_count = 0;               // of the chords that were walked
  std::uint32_t m_open = 0;      // which of them are yet to be taken
  std::uint32_t m_inSegment = 0; // which of them lie in one segment
  bool m_areWhole = true;        // a region is known to keep all of each
  int m_cell = 0;                // the one that is cut
  float m_shares = 1.0f;         // of its chord that are cut
  std::size_t m_segment = 0;
  ChordCubic m_cubic;
  float m_lowest = 0.0f, m_highest = 0.0f;
  HWY_ALIGN float m_entries[cells] = {}, m_exits[cells] = {};
  HWY_ALIGN float m_cubics[4][cells] = {};
  HWY_ALIGN std::int32_t m_segments[cells] = {};
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
