// SPDX-License-Identifier: GPL-3.0-or-later
// The integral along a ray, piece by piece (CellPieces-inl.h), each to its share of the tolerance
// (scene/steps/CellRule.h): nested quadrature over nodes that are halved until the light of a piece stands
// still.
#if defined(LIMN_CPU_CELL_MARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_CELL_MARCH_INL_H
#undef LIMN_CPU_CELL_MARCH_INL_H
#else
#define LIMN_CPU_CELL_MARCH_INL_H
#endif

#include "cpu/simd/CellPieces-inl.h"
#include "scene/steps/CellRule.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// Some consecutive pieces of a ray, integrated together.
template <VoxelSource::Kind kind>
class PieceBatch {
public:
  PieceBatch(const PictureTerms& terms, const Samples<kind>& samples)
      : m_terms(terms), m_samples(samples), m_limit(static_cast<float>(largestPieceChange(*terms.fineness))),
        m_readsGradient(terms.effects.has(Effect::gradient) && !terms.effects.has(Effect::xray)),
        m_changesOpacity(terms.effects.hasAny(opacityChanges)),
        m_isLimited(!terms.effects.has(Effect::unlimited)) {}

  Pieces& pieces() { return m_pieces; }

  /// Takes the next pieces of a ray; false where none is left. Where gradients or looks of labels decide what
  /// absorbs, pieces that show nothing are dropped at once: which pieces are computed together must not
  /// depend on whether empty blocks were leapt over, because what reaches a piece is estimated from those
  /// before it.
  bool fillFrom(PieceMaker<kind>& maker) {
    m_pieces.count = 0;
    m_isBegun = m_changesOpacity;
    m_isAbsorbed = m_changesOpacity || m_samples.looks.areAny();
    bool isMore = true;
    while (isMore && m_pieces.count < most) {
      const int first = m_pieces.count;
      isMore = maker.fill(m_pieces);
      if (!m_isAbsorbed)
        break;
      if (isMore) {
        if (m_isBegun)
          begin(first, m_pieces.count);
        else
          absorbFrom(first);
        dropUnseen(first);
      }
    }
    return m_pieces.count > 0;
  }

  /// Adds the light of the pieces to a sum; of those whose light does not stand still part by part, `cuts`
  /// times at most.
  void addTo(Sum& sum, int cuts) {
    for (int first = 0; first < m_pieces.count && !sum.hasEnded;) {
      const int behind = behindSeen(first, sum.transmittance);
      integrate(first, behind, sum.transmittance);
      take(first, behind, sum, cuts);
      first = behind;
    }
  }

private:
  static constexpr int most = Pieces::most;
  static constexpr int last = cellNodes - 1; // node

  // What is known of the pieces at one node.
  struct Node {
    HWY_ALIGN float extinction[most]; // over the unit distance
    HWY_ALIGN float color[3][most];
    HWY_ALIGN float slope[3][most] = {}; // defined beside the pieces, too: registers hold several

    void move(int from, int to) {
      extinction[to] = extinction[from];
      for (int i = 0; i < 3; ++i) {
        color[i][to] = color[i][from];
        slope[i][to] = slope[i][from];
      }
    }
  };

  // What a piece absorbs and the light that it adds.
  struct Gathered {
    VF alpha;
    V3 color;
  };

  static constexpr std::uint32_t bitsOfPieces(int first, int behind) {
    return (1u << behind) - (1u << first);
  }

  // The piece behind those that light from behind `first` seems to reach: where nothing but the curve decides
  // what absorbs, that is known without a look at the gradients. Pieces behind it wait.
  HWY_NOINLINE int behindSeen(int first, double transmittance) {
    if (m_changesOpacity || m_terms.effects.has(Effect::xray))
      return m_pieces.count;
    if (!m_isAbsorbed)
      absorbFrom(first);
    for (int part = 0; part < most; part += lanes())
      hn::Store(oneMinusExpNeg(depthOf(part)), floats, m_alpha + part);
    for (int n = first; n < m_pieces.count; ++n) {
      transmittance -= transmittance * m_alpha[n];
      if (transmittance <= m_terms.lastTransmittance)
        return n + 1;
    }
    return m_pieces.count;
  }

  // What the pieces from `first` on absorb at both ends and the middle.
  HWY_INLINE void absorbFrom(int first) {
    for (int node = 0; node <= last; node += last / 2)
      absorb(node, bitsOfPieces(first, m_pieces.count));
  }

  // What a piece absorbs as one panel, as an optical depth.
  HWY_INLINE VF depthOf(int part) const {
    const VF length = hn::Sub(hn::Load(floats, m_pieces.to + part), hn::Load(floats, m_pieces.from + part));
    const VF ends = hn::Add(hn::Load(floats, m_nodes[0].extinction + part),
                            hn::Load(floats, m_nodes[last].extinction + part));
    const VF mean = hn::MulAdd(all(2.0f / 3.0f), hn::Load(floats, m_nodes[last / 2].extinction + part),
                               hn::Mul(all(1.0f / 6.0f), ends));
    return hn::Mul(mean, hn::Mul(length, all(m_terms.perUnitDistance)));
  }

  // Finds the light of pieces `first` to before `behind`, given what reaches the first.
  HWY_NOINLINE void integrate(int first, int behind, double transmittance) {
    if (!m_isBegun)
      begin(first, behind);
    m_end = m_pieces.to[behind - 1];
    for (int i = 0; i < 3; ++i)
      m_endSlope[i] = m_nodes[last].slope[i][behind - 1];
    estimate();
    std::uint32_t open = worthMore(first, behind, transmittance);
    for (int stride = last / 4; open != 0 && stride >= 1; stride /= 2) {
      for (int node = stride; node < last; node += 2 * stride) {
        if (m_readsGradient)
          findSlopes(node, open);
        evaluate(node, open, true);
      }
      open = refine(stride, open);
    }
    m_moving = open;
  }

  // Looks at both ends and the middle of some pieces.
  void begin(int first, int behind) {
    const std::uint32_t open = bitsOfPieces(first, behind);
    if (m_readsGradient) {
      findSlopes(0, open);
      findSlopesOfAll(last / 2, first, behind);
      findSlopesOfAll(last, first, behind);
      shareSlopes(first, behind);
    }
    for (int node = 0; node <= last; node += last / 2)
      evaluate(node, open, m_changesOpacity);
  }

  // Drops the pieces from `first` on that absorb nothing wherever they were looked at.
  HWY_NOINLINE void dropUnseen(int first) {
    int kept = first;
    for (int n = first; n < m_pieces.count; ++n) {
      bool shows = false;
      for (int node = 0; node <= last; node += last / 2)
        shows = shows || m_nodes[node].extinction[n] > 0.0f;
      if (shows && kept < n) {
        m_pieces.move(n, kept);
        for (int node = 0; node <= last; node += last / 2)
          m_nodes[node].move(n, kept);
      }
      kept += shows ? 1 : 0;
    }
    m_pieces.count = kept;
  }

  // What reaches each piece, and which of them add so much light that one estimate does not do.
  std::uint32_t worthMore(int first, int behind, double transmittance) {
    std::uint32_t open = 0;
    const bool ends = !m_terms.effects.has(Effect::xray);
    for (int n = first; n < behind; ++n) {
      m_reaching[n] = static_cast<float>(transmittance);
      if (ends && transmittance <= m_terms.lastTransmittance)
        continue;
      const double taken = transmittance * m_alpha[n];
      transmittance -= taken;
      if (taken > double(m_limit) * faintPieces)
        open |= 1u << n;
    }
    return open;
  }

  HWY_INLINE VF placesOf(int node, int part) const {
    const VF from = hn::Load(floats, m_pieces.from + part);
    if (node == 0)
      return from;
    const VF to = hn::Load(floats, m_pieces.to + part);
    return node == last ? to : hn::MulAdd(all(shareOf(node)), hn::Sub(to, from), from);
  }

  static constexpr float shareOf(int node) { return static_cast<float>(node) / static_cast<float>(last); }

  // The slopes of the field at a node of some pieces. Where one piece ends and the next begins they are the
  // same.
  HWY_NOINLINE void findSlopes(int node, std::uint32_t open) {
    Node& at = m_nodes[node];
    HWY_ALIGN float places[most + HWY_MAX_BYTES / 4];
    HWY_ALIGN float wanted[most + HWY_MAX_BYTES / 4];
    for (int part = 0; part < most; part += lanes())
      hn::Store(placesOf(node, part), floats, places + part);
    int pieceOf[most];
    int count = 0;
    for (; open != 0; open &= open - 1) {
      const int n = std::countr_zero(open);
      if (node == 0 && isJoined(n))
        continue;
      wanted[count] = places[n];
      pieceOf[count++] = n;
    }
    for (int done = 0; done < count; done += lanes()) {
      const int here = std::min(lanes(), count - done);
      for (int lane = here; lane < lanes(); ++lane)
        wanted[done + lane] = wanted[done];
      const V3 index = m_samples.indexAt(hn::LoadU(floats, wanted + done));
      const V3 slope = slopeAt(m_terms, m_samples.field, index, here);
      HWY_ALIGN float found[3][HWY_MAX_BYTES / 4];
      hn::Store(slope.x, floats, found[0]);
      hn::Store(slope.y, floats, found[1]);
      hn::Store(slope.z, floats, found[2]);
      for (int axis = 0; axis < 3; ++axis)
        for (int lane = 0; lane < here; ++lane)
          at.slope[axis][pieceOf[done + lane]] = found[axis][lane];
    }
  }

  // The same of pieces side by side, and perhaps of some before them.
  HWY_INLINE void findSlopesOfAll(int node, int first, int behind) {
    for (int part = first / lanes() * lanes(); part < behind; part += lanes()) {
      const V3 slope = slopeAt(m_terms, m_samples.field, m_samples.indexAt(placesOf(node, part)),
                               std::min(lanes(), behind - part));
      hn::Store(slope.x, floats, m_nodes[node].slope[0] + part);
      hn::Store(slope.y, floats, m_nodes[node].slope[1] + part);
      hn::Store(slope.z, floats, m_nodes[node].slope[2] + part);
    }
  }

  // Whether a piece begins where the one before ends.
  bool isJoined(int n) const { return m_pieces.from[n] == (n == 0 ? m_end : m_pieces.to[n - 1]); }

  void shareSlopes(int first, int behind) {
    for (int n = first; n < behind; ++n)
      if (isJoined(n))
        for (int axis = 0; axis < 3; ++axis)
          m_nodes[0].slope[axis][n] = n == 0 ? m_endSlope[axis] : m_nodes[last].slope[axis][n - 1];
  }

  // Which of the pieces that registers hold together are open.
  HWY_INLINE static std::uint32_t openIn(std::uint32_t open, int part) {
    return open >> part & ((1u << lanes()) - 1);
  }

  // The opacities over the unit distance that curve and region give at a node.
  HWY_INLINE VF opacityAt(int node, int part, VF within) const {
    const VF opacity = ofSegment(3, within, part);
    return m_pieces.areWhole ? opacity : hn::Mul(opacity, m_samples.weightAt(placesOf(node, part)));
  }

  // What looks of labels make of a node, their opacities times a factor.
  HWY_INLINE Looks::Mixed mixedAt(int node, int part, VF factor) const {
    const VF scalar = scalarAt(node, part);
    const Mask every = hn::Eq(scalar, scalar);
    return m_samples.looks.mixedAt(m_samples.indexAt(placesOf(node, part)), scalar, factor, every,
                                   Looks::Colors::ofAll);
  }

  // What lies at a node of some pieces absorbs, where no gradient changes that.
  HWY_INLINE void absorb(int node, std::uint32_t open) {
    for (int part = 0; part < most; part += lanes()) {
      if (openIn(open, part) == 0)
        continue;
      if (m_samples.looks.areAny()) {
        hn::Store(mixedAt(node, part, all(1.0f)).extinction, floats, m_nodes[node].extinction + part);
        continue;
      }
      const VF within = hn::Sub(scalarAt(node, part), hn::Load(floats, m_pieces.start + part));
      hn::Store(minusLog1mOpacity(opacityAt(node, part, within)), floats, m_nodes[node].extinction + part);
    }
  }

  // Extinction, unless it is known, and lit colour at a node of some pieces.
  HWY_NOINLINE void evaluate(int node, std::uint32_t open, bool withExtinction) {
    if (m_terms.effects.has(Effect::xray)) {
      absorb(node, open);
      return;
    }
    for (int part = 0; part < most; part += lanes())
      if (openIn(open, part) != 0)
        light(node, part, withExtinction);
  }

  HWY_INLINE void light(int node, int part, bool withExtinction) {
    Node& at = m_nodes[node];
    const VF within = hn::Sub(scalarAt(node, part), hn::Load(floats, m_pieces.start + part));
    Gradients gradients{zero(), hn::Zero(floats), hn::Zero(floats)};
    if (m_readsGradient)
      gradients = m_samples.light.gradientsOf({hn::Load(floats, at.slope[0] + part),
                                               hn::Load(floats, at.slope[1] + part),
                                               hn::Load(floats, at.slope[2] + part)});
    V3 material;
    if (m_samples.looks.areAny()) {
      const VF factor = m_changesOpacity ? m_samples.light.opacityFactor(gradients) : all(1.0f);
      const Looks::Mixed mixed = mixedAt(node, part, factor);
      if (withExtinction)
        hn::Store(mixed.extinction, floats, at.extinction + part);
      material = mixed.color;
    } else {
      if (withExtinction) {
        VF opacity = opacityAt(node, part, within);
        if (m_changesOpacity)
          opacity = hn::Mul(opacity, m_samples.light.opacityFactor(gradients));
        hn::Store(minusLog1mOpacity(opacity), floats, at.extinction + part);
      }
      material = {ofSegment(0, within, part), ofSegment(1, within, part), ofSegment(2, within, part)};
    }
    const V3 color = m_samples.shaded(clamped(material, 0.0f, 1.0f), gradients, placesOf(node, part));
    hn::Store(color.x, floats, at.color[0] + part);
    hn::Store(color.y, floats, at.color[1] + part);
    hn::Store(color.z, floats, at.color[2] + part);
  }

  HWY_INLINE VF scalarAt(int node, int part) const {
    const float s = shareOf(node), r = 1.0f - s;
    const VF b0 = hn::Load(floats, m_pieces.cubic[0] + part), b1 = hn::Load(floats, m_pieces.cubic[1] + part),
             b2 = hn::Load(floats, m_pieces.cubic[2] + part), b3 = hn::Load(floats, m_pieces.cubic[3] + part);
    // As what it differs from its begin, so that what is constant stays so.
    const VF rest = hn::MulAdd(
        all(3.0f * r * r * s), hn::Sub(b1, b0),
        hn::MulAdd(all(3.0f * r * s * s), hn::Sub(b2, b0), hn::Mul(all(s * s * s), hn::Sub(b3, b0))));
    return hn::Min(hn::Max(hn::Add(b0, rest), hn::Load(floats, m_pieces.low + part)),
                   hn::Load(floats, m_pieces.high + part));
  }

  HWY_INLINE VF ofSegment(int channel, VF within, int part) const {
    return hn::MulAdd(within, hn::Load(floats, m_pieces.slopes[channel] + part),
                      hn::Load(floats, m_pieces.values[channel] + part));
  }

  // The first estimate of all pieces.
  void estimate() {
    for (int part = 0; part < most; part += lanes())
      keep(gatheredBy(part, last / 2), part);
  }

  HWY_INLINE void keep(const Gathered& found, int part) {
    hn::Store(found.alpha, floats, m_alpha + part);
    hn::Store(found.color.x, floats, m_color[0] + part);
    hn::Store(found.color.y, floats, m_color[1] + part);
    hn::Store(found.color.z, floats, m_color[2] + part);
  }

  // Estimates some pieces anew from twice the nodes. Returns those whose light has changed by too much.
  HWY_NOINLINE std::uint32_t refine(int stride, std::uint32_t open) {
    std::uint32_t tooFar = 0;
    for (int part = 0; part < most; part += lanes()) {
      const std::uint32_t here = openIn(open, part);
      if (here == 0)
        continue;
      const Gathered found = gatheredBy(part, stride);
      const VF alpha = hn::Load(floats, m_alpha + part);
      const V3 color{hn::Load(floats, m_color[0] + part), hn::Load(floats, m_color[1] + part),
                     hn::Load(floats, m_color[2] + part)};
      const VF change =
          hn::Max(hn::Max(hn::Abs(hn::Sub(found.color.x, color.x)), hn::Abs(hn::Sub(found.color.y, color.y))),
                  hn::Max(hn::Abs(hn::Sub(found.color.z, color.z)), hn::Abs(hn::Sub(found.alpha, alpha))));
      const VF moved = m_terms.effects.has(Effect::xray) ? change : hn::Max(change, unforeseen(part, stride));
      const VF ofPixel = hn::Mul(moved, hn::Load(floats, m_reaching + part));
      tooFar |= (bitsOf(hn::Gt(ofPixel, all(m_limit))) & here) << part;
      HWY_ALIGN float isOpen[HWY_MAX_BYTES / 4];
      for (int lane = 0; lane < lanes(); ++lane)
        isOpen[lane] = (here >> lane & 1u) != 0 ? 1.0f : 0.0f;
      const Mask mask = hn::Gt(hn::Load(floats, isOpen), hn::Zero(floats));
      keep({hn::IfThenElse(mask, found.alpha, alpha), chosen(mask, found.color, color)}, part);
    }
    return tooFar;
  }

  // How much light the newest nodes, of this stride, add that the quadratics through those before did not
  // foresee. Sums may agree by chance, as where light sets in within a piece; two nodes hardly do.
  HWY_INLINE VF unforeseen(int part, int stride) const {
    VF sum = hn::Zero(floats);
    VF left = all(1.0f);
    const VF length = hn::Sub(hn::Load(floats, m_pieces.to + part), hn::Load(floats, m_pieces.from + part));
    const VF units = hn::Mul(length, all(m_terms.perUnitDistance * 2.0f * shareOf(stride)));
    for (int node = 0; node < last; node += 4 * stride) {
      const Node &a = m_nodes[node], &b = m_nodes[node + 2 * stride], &c = m_nodes[node + 4 * stride];
      sum = hn::MulAdd(absorbedAround(node + stride, part, units, left),
                       surprise(m_nodes[node + stride], a, b, c, part), sum);
      sum = hn::MulAdd(absorbedAround(node + 3 * stride, part, units, left),
                       surprise(m_nodes[node + 3 * stride], c, b, a, part), sum);
    }
    return sum;
  }

  // What the half panel around a node absorbs of the light that is left.
  HWY_INLINE VF absorbedAround(int node, int part, VF units, VF& left) const {
    const VF alpha = oneMinusExpNeg(hn::Mul(units, hn::Load(floats, m_nodes[node].extinction + part)));
    const VF taken = hn::Mul(left, alpha);
    left = hn::Sub(left, taken);
    return taken;
  }

  // By how much a colour a quarter of the way from `a` to `c` lies off the quadratic.
  HWY_INLINE static VF surprise(const Node& at, const Node& a, const Node& b, const Node& c, int part) {
    VF most = hn::Zero(floats);
    for (int i = 0; i < 3; ++i) {
      const VF expected = hn::MulAdd(all(0.375f), hn::Load(floats, a.color[i] + part),
                                     hn::MulSub(all(0.75f), hn::Load(floats, b.color[i] + part),
                                                hn::Mul(all(0.125f), hn::Load(floats, c.color[i] + part))));
      most = hn::Max(most, hn::Abs(hn::Sub(hn::Load(floats, at.color[i] + part), expected)));
    }
    return most;
  }

  // The panels of some pieces put together, each between three nodes of this stride.
  HWY_INLINE Gathered gatheredBy(int part, int stride) const {
    const VF length = hn::Sub(hn::Load(floats, m_pieces.to + part), hn::Load(floats, m_pieces.from + part));
    const VF units = hn::Mul(length, all(m_terms.perUnitDistance * 2.0f * shareOf(stride)));
    Gathered sum = panel(0, stride, part, units);
    for (int node = 2 * stride; node < last; node += 2 * stride) {
      const Gathered next = panel(node, stride, part, units);
      const VF left = hn::Sub(all(1.0f), sum.alpha);
      sum.color = {hn::MulAdd(left, next.color.x, sum.color.x), hn::MulAdd(left, next.color.y, sum.color.y),
                   hn::MulAdd(left, next.color.z, sum.color.z)};
      sum.alpha = hn::MulAdd(left, next.alpha, sum.alpha);
    }
    return sum;
  }

  // Extinction κ and lit colour c are quadratics through three nodes. With T = exp(-τ), and τ in closed form,
  // ∫Tκc ds = αc(0) + ∫(T - T(1))c' ds: exact for one colour however opaque, and by Gauss's three points.
  HWY_INLINE Gathered panel(int node, int stride, int part, VF units) const {
    const Node &a = m_nodes[node], &b = m_nodes[node + stride], &c = m_nodes[node + 2 * stride];
    const VF k0 = hn::Mul(units, hn::Load(floats, a.extinction + part));
    const VF k1 = hn::Mul(units, hn::Load(floats, b.extinction + part));
    const VF k2 = hn::Mul(units, hn::Load(floats, c.extinction + part));
    Gathered result;
    result.alpha =
        oneMinusExpNeg(hn::MulAdd(all(2.0f / 3.0f), k1, hn::Mul(all(1.0f / 6.0f), hn::Add(k0, k2))));
    result.color = zero();
    if (m_terms.effects.has(Effect::xray))
      return result;
    VF behind[3]; // each point, what is absorbed, with its weight
    for (int g = 0; g < 3; ++g) {
      const GaussPoint& at = gaussPoints[g];
      const VF depth =
          hn::MulAdd(all(at.depth[0]), k0, hn::MulAdd(all(at.depth[1]), k1, hn::Mul(all(at.depth[2]), k2)));
      behind[g] =
          hn::Mul(all(at.weight), hn::Sub(result.alpha, oneMinusExpNeg(hn::Max(depth, hn::Zero(floats)))));
    }
    // c' is a line: its value at the begin, and what it gains.
    const VF constant = hn::Add(hn::Add(behind[0], behind[1]), behind[2]);
    const VF linear = hn::MulAdd(
        all(gaussPoints[0].place), behind[0],
        hn::MulAdd(all(gaussPoints[1].place), behind[1], hn::Mul(all(gaussPoints[2].place), behind[2])));
    result.color = {channel(0, a, b, c, part, result.alpha, constant, linear),
                    channel(1, a, b, c, part, result.alpha, constant, linear),
                    channel(2, a, b, c, part, result.alpha, constant, linear)};
    // Where light jumps between nodes, the quadratic through them runs over what colours can be.
    if (m_isLimited)
      result.color = {hn::Min(hn::Max(result.color.x, hn::Zero(floats)), result.alpha),
                      hn::Min(hn::Max(result.color.y, hn::Zero(floats)), result.alpha),
                      hn::Min(hn::Max(result.color.z, hn::Zero(floats)), result.alpha)};
    return result;
  }

  HWY_INLINE static VF channel(int i, const Node& a, const Node& b, const Node& c, int part, VF alpha,
                               VF constant, VF linear) {
    const VF c0 = hn::Load(floats, a.color[i] + part);
    const VF d1 = hn::Sub(hn::Load(floats, b.color[i] + part), c0);
    const VF d2 = hn::Sub(hn::Load(floats, c.color[i] + part), c0);
    const VF begin = hn::MulSub(all(4.0f), d1, d2);
    const VF gain = hn::MulSub(all(4.0f), d2, hn::Mul(all(8.0f), d1));
    return hn::MulAdd(alpha, c0, hn::MulAdd(constant, begin, hn::Mul(linear, gain)));
  }

  // Composites the pieces front to back.
  HWY_NOINLINE void take(int first, int behind, Sum& sum, int cuts) {
    const bool ends = !m_terms.effects.has(Effect::xray);
    HWY_ALIGN float reaching[most] = {};
    for (int n = first; n < behind && !sum.hasEnded; ++n) {
      if ((m_moving >> n & 1u) != 0 && cuts > 0) {
        addParts(n, sum, cuts - 1);
        continue;
      }
      reaching[n] = static_cast<float>(sum.transmittance);
      sum.transmittance -= sum.transmittance * m_alpha[n];
      sum.hasEnded = ends && sum.transmittance <= m_terms.lastTransmittance;
    }
    for (int part = 0; part < behind; part += lanes()) {
      const VF weight = hn::Load(floats, reaching + part);
      sum.color = {hn::MulAdd(weight, hn::Load(floats, m_color[0] + part), sum.color.x),
                   hn::MulAdd(weight, hn::Load(floats, m_color[1] + part), sum.color.y),
                   hn::MulAdd(weight, hn::Load(floats, m_color[2] + part), sum.color.z)};
    }
  }

  // Cuts a piece into equal parts, so that only those in which something happens are looked at more closely.
  HWY_NOINLINE void addParts(int n, Sum& sum, int cuts) const {
    PieceBatch parts(m_terms, m_samples);
    Pieces& pieces = parts.pieces();
    pieces.areWhole = m_pieces.areWhole;
    pieces.count = cellParts;
    for (int part = 0; part < cellParts; ++part)
      cutPiece(m_pieces, n, part, pieces);
    parts.addTo(sum, cuts);
  }

  const PictureTerms& m_terms;
  const Samples<kind>& m_samples;
  float m_limit;
  bool m_readsGradient, m_changesOpacity;
  bool m_isLimited;          // lit colours lie within 0..1
  bool m_isBegun = false;    // ends and middles of all pieces are known
  bool m_isAbsorbed = false; // at least what absorbs there
  Pieces m_pieces;
  float m_end = -1.0f; // of the last piece that was taken
  float m_endSlope[3] = {};
  std::uint32_t m_moving = 0; // whose light does not stand still
  HWY_ALIGN float m_alpha[most] = {}, m_color[3][most] = {}, m_reaching[most] = {};
  Node m_nodes[cellNodes];
};

/// The last sample of a ray's equal steps before what may show, lengths behind the span's begin.
inline double beforeSeen(const PictureTerms& terms, const Ray& ray) {
  const double stepMm = (ray.span.end - ray.span.begin) / ray.count;
  return std::max(0.0, (ray.from - 1 + double(ray.offset)) * stepMm / terms.lengthMm);
}

/// One ray, cell by cell.
template <VoxelSource::Kind kind>
class CellMarch {
public:
  /// Nothing shows before `from`, lengths behind the span's begin.
  CellMarch(const PictureTerms& terms, const Ray& ray, double from)
      : m_terms(terms), m_ray(inLengths(terms, ray)), m_samples(terms, m_ray),
        m_maker(terms, m_samples, from), m_batch(terms, m_samples) {}

  glm::vec4 gathered() {
    Sum sum{zero(), 1.0, false};
    addTo(sum);
    return pixelOf(sum, m_terms.effects);
  }

  /// Adds what lies in the span to what lies before it.
  void addTo(Sum& sum) {
    while (!sum.hasEnded && m_batch.fillFrom(m_maker))
      m_batch.addTo(sum, cellCuts);
  }

private:
  const PictureTerms& m_terms;
  Ray m_ray;
  Samples<kind> m_samples;
  PieceMaker<kind> m_maker;
  PieceBatch<kind> m_batch;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
