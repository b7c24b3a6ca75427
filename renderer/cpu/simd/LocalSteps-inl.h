// SPDX-License-Identifier: GPL-3.0-or-later
// Error-controlled steps (scene/steps/LocalSteps.h). Each piece of a ray depends on the one before, so
// several are planned ahead as if none had to be taken again, their samples are computed together, and the
// pieces are then taken one by one: as far as the plan holds. What is taken is what taking them singly would
// take.
#if defined(LIMN_CPU_LOCAL_STEPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_LOCAL_STEPS_INL_H
#undef LIMN_CPU_LOCAL_STEPS_INL_H
#else
#define LIMN_CPU_LOCAL_STEPS_INL_H
#endif

#include "cpu/simd/Samples-inl.h"
#include "scene/steps/BlockWalk.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// One ray in error-controlled steps (scene/steps/LocalSteps.h).
template <VoxelSource::Kind kind>
class LocalMarch {
public:
  LocalMarch(const PictureTerms& terms, const Ray& ray)
      : m_terms(terms), m_local(*terms.local), m_ray(inLengths(terms, ray)), m_samples(terms, m_ray),
        m_limit(mostChange(m_local.fineness)) {
    m_place.walk.emplace(m_local, framedRay(terms.frame, ray.pixel.x, ray.pixel.y, terms.size), ray.span);
  }

  /// The same ray from where it enters the brick that is drawn to where it leaves it; its span is empty where
  /// it passes by.
  static Ray inBrick(const PictureTerms& terms, Ray ray) {
    ray.span = partInBrick(terms, framedRay(terms.frame, ray.pixel.x, ray.pixel.y, terms.size), ray.span);
    return ray;
  }

  glm::vec4 gathered() {
    Sum sum{zero(), 1.0, false};
    takeFirst();
    while (!sum.hasEnded && plan(sum.transmittance)) {
      compute();
      take(sum);
    }
    return pixelOf(sum, m_terms.effects);
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;

  // Where on the ray a piece begins, and with which steps it is to be taken.
  struct Place {
    std::optional<BlockWalk> walk; ///< in the block that holds it
    bool isInBlock = false;
    bool isBehindEmpty = true; ///< nothing lies at the piece's begin
    bool startsBlock = false;
    int rung = 0;
    int blockRung = 0;
    double within = 0.0; ///< of the block's chord, mm
  };

  struct Piece {
    Place place;
    double length = 0.0; ///< mm
    bool isLast = false; ///< of its block
  };

  // The sample at the begin of the ray.
  void takeFirst() {
    const auto shaded = m_samples.at(hn::Zero(floats), hn::FirstN(floats, 1));
    const bool isSeen = (bitsOf(shaded.seen) & 1u) != 0;
    m_before = {isSeen ? hn::GetLane(shaded.extinction) : 0.0f,
                {hn::GetLane(shaded.color.x), hn::GetLane(shaded.color.y), hn::GetLane(shaded.color.z)}};
    m_place.isBehindEmpty = false;
  }

  // Moves to a block in which there is something; false behind the ray's end.
  bool enterBlock(Place& place, double transmittance) const {
    while (place.walk->enterNext()) {
      place.within = 0.0;
      if (place.walk->rungs().isEmpty) {
        place.isBehindEmpty = true;
        place.rung = 0;
        continue;
      }
      place.isInBlock = place.startsBlock = true;
      place.blockRung = rungIn(place.walk->rungs(), m_local.fineness, transmittance);
      place.rung = std::max(place.rung, place.blockRung);
      return true;
    }
    return false;
  }

  // Plans as many pieces as are computed together, from the place on; false where none is left.
  bool plan(double transmittance) {
    m_planned = 0;
    Place place = m_place;
    while (m_planned < lanes()) {
      if (!place.isInBlock && !enterBlock(place, transmittance))
        break;
      Piece& piece = m_pieces[m_planned++];
      const double chord = place.walk->exit() - place.walk->entry();
      const double rest = chord - place.within;
      piece.place = place;
      const bool hasSpentAll = m_spent + m_planned > mostLocalSamples;
      piece.length = hasSpentAll ? rest : pieceOf(rest, m_local.stepMm(place.rung));
      piece.isLast = piece.length == rest;
      const double end =
          piece.isLast ? place.walk->exit() : place.walk->entry() + (place.within + piece.length);
      m_ends[m_planned - 1] = static_cast<float>(end / m_terms.lengthMm);
      m_halves[m_planned - 1] = static_cast<float>(0.5 * piece.length / m_terms.lengthMm);
      moveBehind(piece, place);
    }
    return m_planned > 0;
  }

  static void moveBehind(const Piece& piece, Place& place) {
    place.startsBlock = place.isBehindEmpty = false;
    place.within += piece.length;
    place.isInBlock = !piece.isLast;
  }

  // The samples at the ends of the planned pieces, and what either half of each would add alone.
  HWY_NOINLINE void compute() {
    const VF ends = hn::Load(floats, m_ends);
    const VF units = hn::Mul(hn::Load(floats, m_halves), all(m_terms.perUnitDistance));
    const auto shaded = m_samples.at(ends, hn::FirstN(floats, static_cast<std::size_t>(m_planned)));
    const VF extinction = hn::IfThenElseZero(shaded.seen, shaded.extinction);
    const VF alpha = oneMinusExpNeg(hn::Mul(extinction, units));
    const V3 color = scaled(shaded.color, alpha);
    keep(extinction, shaded.color);
    HWY_ALIGN float isOld[most];
    for (int lane = 0; lane < most; ++lane)
      isOld[lane] = lane < m_planned && m_pieces[lane].place.isBehindEmpty ? 0.0f : 1.0f;
    const VF old = hn::Load(floats, isOld);
    const VF alphaBefore = oneMinusExpNeg(hn::Mul(hn::Mul(old, hn::LoadU(floats, m_extinctions)), units));
    const V3 colorBefore = scaled(
        {hn::LoadU(floats, m_reds), hn::LoadU(floats, m_greens), hn::LoadU(floats, m_blues)}, alphaBefore);
    const VF change =
        hn::Max(hn::Max(hn::Abs(hn::Sub(color.x, colorBefore.x)), hn::Abs(hn::Sub(color.y, colorBefore.y))),
                hn::Max(hn::Abs(hn::Sub(color.z, colorBefore.z)), hn::Abs(hn::Sub(alpha, alphaBefore))));
    hn::Store(change, floats, m_changes);
    hn::Store(alphaBefore, floats, m_alphasBefore);
    hn::Store(alpha, floats, m_alphas);
    m_colorBefore = colorBefore;
    m_color = color;
  }

  // Stores the samples behind the one before the first of them.
  HWY_INLINE void keep(VF extinction, const V3& color) {
    m_extinctions[0] = m_before.extinction;
    m_reds[0] = m_before.color.r;
    m_greens[0] = m_before.color.g;
    m_blues[0] = m_before.color.b;
    hn::StoreU(extinction, floats, m_extinctions + 1);
    hn::StoreU(color.x, floats, m_reds + 1);
    hn::StoreU(color.y, floats, m_greens + 1);
    hn::StoreU(color.z, floats, m_blues + 1);
  }

  // Takes the planned pieces one by one until one was planned otherwise than it is to be taken.
  HWY_NOINLINE void take(Sum& sum) {
    HWY_ALIGN float sharesBefore[most] = {};
    HWY_ALIGN float shares[most] = {};
    const double last = m_terms.lastTransmittance;
    const bool ends = !m_terms.effects.has(Effect::xray);
    int rung = m_pieces[0].place.rung;
    int taken = 0;
    for (; taken < m_planned; ++taken) {
      const Piece& piece = m_pieces[taken];
      m_place = piece.place;
      if (piece.place.startsBlock) {
        m_place.blockRung = rungIn(m_place.walk->rungs(), m_local.fineness, sum.transmittance);
        const int entered = piece.place.isBehindEmpty && taken > 0 ? 0 : rung;
        rung = taken > 0 ? std::max(entered, m_place.blockRung) : rung;
      }
      m_place.rung = rung;
      if (rung != piece.place.rung || m_place.blockRung != piece.place.blockRung)
        break;
      ++m_spent;
      const double change = 2.0 * sum.transmittance * m_changes[taken];
      if (m_spent <= mostLocalSamples && isToBeRefined(change, m_limit, rung)) {
        m_place.rung = refinedRung(rung, change, m_limit);
        break;
      }
      sharesBefore[taken] = static_cast<float>(sum.transmittance);
      sum.transmittance -= sum.transmittance * m_alphasBefore[taken];
      shares[taken] = static_cast<float>(sum.transmittance);
      sum.transmittance -= sum.transmittance * m_alphas[taken];
      rung = relaxedRung(rung, m_place.blockRung, change, m_limit);
      m_place.rung = rung;
      moveBehind(piece, m_place);
      m_before = {m_extinctions[taken + 1], {m_reds[taken + 1], m_greens[taken + 1], m_blues[taken + 1]}};
      if (ends && sum.transmittance <= last) {
        sum.hasEnded = true;
        break;
      }
    }
    const VF ofBefore = hn::Load(floats, sharesBefore);
    const VF ofHere = hn::Load(floats, shares);
    sum.color = {hn::MulAdd(ofBefore, m_colorBefore.x, hn::MulAdd(ofHere, m_color.x, sum.color.x)),
                 hn::MulAdd(ofBefore, m_colorBefore.y, hn::MulAdd(ofHere, m_color.y, sum.color.y)),
                 hn::MulAdd(ofBefore, m_colorBefore.z, hn::MulAdd(ofHere, m_color.z, sum.color.z))};
  }

  struct Sample {
    float extinction = 0.0f;
    glm::vec3 color{0.0f};
  };

  const PictureTerms& m_terms;
  const LocalStepTerms& m_local;
  Ray m_ray;
  Samples<kind> m_samples;
  double m_limit;
  Place m_place;
  Sample m_before; // at the place
  int m_spent = 0;
  int m_planned = 0;
  Piece m_pieces[most];
  HWY_ALIGN float m_ends[most] = {}, m_halves[most] = {}, m_changes[most] = {};
  HWY_ALIGN float m_alphasBefore[most] = {}, m_alphas[most] = {};
  float m_extinctions[most + 1] = {}, m_reds[most + 1] = {}, m_greens[most + 1] = {}, m_blues[most + 1] = {};
  V3 m_colorBefore, m_color;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
