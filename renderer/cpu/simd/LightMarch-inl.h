// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of light to places past what stands in its way (DEFINITION section 11), along paths that are
// marched, several places at a time. What is found of a place does not depend on the others.
#if defined(LIMN_CPU_LIGHT_MARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_LIGHT_MARCH_INL_H
#undef LIMN_CPU_LIGHT_MARCH_INL_H
#else
#define LIMN_CPU_LIGHT_MARCH_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Field-inl.h"
#include "cpu/simd/Function-inl.h"
#include "cpu/simd/Light-inl.h"
#include "cpu/simd/Looks-inl.h"
#include "scene/steps/BlockRanges.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// Axes of which the third is a unit vector, of each place (T. Duff and others, Building an orthonormal
/// basis, revisited, JCGT 6 (2017)).
struct Axes {
  HWY_INLINE explicit Axes(const V3& axis) : third(axis) {
    const VF sign = hn::CopySign(all(1.0f), axis.z);
    const VF a = hn::Div(all(-1.0f), hn::Add(sign, axis.z));
    const VF b = hn::Mul(hn::Mul(axis.x, axis.y), a);
    first = {hn::MulAdd(hn::Mul(sign, hn::Mul(axis.x, axis.x)), a, all(1.0f)), hn::Mul(sign, b),
             hn::Neg(hn::Mul(sign, axis.x))};
    second = {b, hn::MulAdd(hn::Mul(axis.y, axis.y), a, sign), hn::Neg(axis.y)};
  }

  HWY_INLINE V3 of(const glm::vec3& v) const {
    return {hn::MulAdd(first.x, all(v.x), hn::MulAdd(second.x, all(v.y), hn::Mul(third.x, all(v.z)))),
            hn::MulAdd(first.y, all(v.x), hn::MulAdd(second.y, all(v.y), hn::Mul(third.y, all(v.z)))),
            hn::MulAdd(first.z, all(v.x), hn::MulAdd(second.z, all(v.y), hn::Mul(third.z, all(v.z))))};
  }

  V3 first, second, third;
};

/// Marches paths of light through a picture's volume.
template <VoxelSource::Kind kind>
class LightMarch {
public:
  LightMarch(const PictureTerms& terms, const Field<kind>& field, const Function& function,
             const Light& light, const Looks& looks)
      : m_terms(terms), m_field(field), m_function(function), m_light(light), m_looks(looks),
        m_hasSurface(terms.effects.has(Effect::isosurface) || terms.effects.has(Effect::hybrid)),
        m_hasDepth(!terms.effects.has(Effect::isosurface)) {}

  /// exp(-τ) from voxel indices along unit directions (of the grid's axes, in mm), from `from` to `reach`
  /// lengths on, in steps of at most `step` lengths; 0 where a surface stands in the way, anything where not
  /// `wanted`. Each path is divided equally, as a ray is.
  HWY_NOINLINE VF transmittance(const V3& index, const V3& direction, float from, float reach, float step,
                                Mask wanted) const {
    const V3 perLength{hn::Mul(direction.x, all(perLengthAlong(0))),
                       hn::Mul(direction.y, all(perLengthAlong(1))),
                       hn::Mul(direction.z, all(perLengthAlong(2)))};
    const VF begin = entryOf(index, perLength, from);
    const VF span = hn::Sub(exitOf(index, perLength, reach), begin);
    Mask isOpen = hn::And(wanted, hn::Gt(span, hn::Zero(floats)));
    VF depth = hn::Zero(floats);
    if (hn::AllFalse(floats, isOpen))
      return all(1.0f);
    const VF count = hn::Max(hn::Ceil(hn::Mul(span, all(1.0f / step))), all(1.0f));
    const VF length = hn::Div(hn::IfThenElseZero(isOpen, span), count);
    // Voxels a step along the axis that is followed most.
    const VF fastest =
        hn::Mul(length, hn::Max(hn::Max(hn::Abs(perLength.x), hn::Abs(perLength.y)), hn::Abs(perLength.z)));
    const VF perUnit = hn::Mul(length, all(m_terms.perUnitDistance));
    Mask isBlocked = hn::Lt(all(0.0f), hn::Zero(floats));
    if (m_hasSurface) { // a path may begin behind it
      isBlocked = hitAt(alongFrom(index, perLength, begin), isOpen);
      isOpen = hn::AndNot(isBlocked, isOpen);
    }
    for (float i = 0.0f;;) {
      isOpen = hn::And(isOpen, hn::Lt(all(i), count));
      if (hn::AllFalse(floats, isOpen))
        break;
      const VF at = hn::MulAdd(all(i + 0.5f), length, begin);
      const V3 place = alongFrom(index, perLength, at);
      if (const float leap = leapFrom(place, fastest, isOpen); leap > 0.0f) {
        i += leap;
        continue;
      }
      const VF scalar = m_field.scalarAt(place);
      if (m_hasSurface) {
        const Mask isHit = keptOf(place, hn::And(isOpen, hn::Ge(scalar, all(m_terms.isovalue))));
        isBlocked = hn::Or(isBlocked, isHit);
        isOpen = hn::AndNot(isHit, isOpen);
      }
      if (m_hasDepth) {
        const VF extinction = extinctionAt(place, scalar, isOpen);
        depth = hn::MulAdd(hn::IfThenElseZero(isOpen, extinction), perUnit, depth);
        isOpen = hn::And(isOpen, hn::Lt(depth, all(nothingLeft)));
      }
      i += 1.0f;
    }
    return hn::IfThenZeroElse(isBlocked, expNeg(depth));
  }

  /// The extinction per length `length` lengths from places along unit directions; of a surface, and behind
  /// it, more than anything shines through.
  HWY_NOINLINE VF extinctionAlong(const V3& index, const V3& direction, float length) const {
    const V3 place{hn::MulAdd(direction.x, all(length * perLengthAlong(0)), index.x),
                   hn::MulAdd(direction.y, all(length * perLengthAlong(1)), index.y),
                   hn::MulAdd(direction.z, all(length * perLengthAlong(2)), index.z)};
    const Mask isInside = insideOf(place);
    VF extinction = hn::Zero(floats);
    const VF scalar = m_field.scalarAt(place);
    if (m_hasDepth)
      extinction = hn::Mul(extinctionAt(place, scalar, isInside), all(m_terms.perUnitDistance));
    if (m_hasSurface)
      extinction = hn::IfThenElse(keptOf(place, hn::And(isInside, hn::Ge(scalar, all(m_terms.isovalue)))),
                                  all(1e3f), extinction);
    return hn::IfThenElseZero(isInside, extinction);
  }

private:
  HWY_INLINE Mask insideOf(const V3& place) const {
    return hn::And(hn::And(within(place.x, 0), within(place.y, 1)), within(place.z, 2));
  }

  HWY_INLINE Mask within(VF at, int axis) const {
    return hn::And(hn::Ge(at, all(static_cast<float>(m_terms.box.lower[axis] + m_terms.centre[axis]))),
                   hn::Lt(at, all(static_cast<float>(m_terms.box.upper[axis] + m_terms.centre[axis]))));
  }

  // Of light that has passed so much less than the code of a node tells is left.
  static constexpr float nothingLeft = 10.0f;

  HWY_INLINE float perLengthAlong(int axis) const { return static_cast<float>(1.0 / m_terms.spacing[axis]); }

  HWY_INLINE static V3 alongFrom(const V3& index, const V3& perLength, VF at) {
    return {hn::MulAdd(at, perLength.x, index.x), hn::MulAdd(at, perLength.y, index.y),
            hn::MulAdd(at, perLength.z, index.z)};
  }

  // Which places lie on or behind a surface.
  HWY_INLINE Mask hitAt(const V3& place, Mask wanted) const {
    return keptOf(place, hn::And(wanted, hn::Ge(m_field.scalarAt(place), all(m_terms.isovalue))));
  }

  // Where paths from nodes beside the box come into it, at least `from`; beyond everything where they never
  // do.
  HWY_INLINE VF entryOf(const V3& index, const V3& perLength, float from) const {
    VF begin = all(from);
    const VF along[3] = {perLength.x, perLength.y, perLength.z}, at[3] = {index.x, index.y, index.z};
    for (int axis = 0; axis < 3; ++axis) {
      const VF lower = all(static_cast<float>(m_terms.box.lower[axis] + m_terms.centre[axis]));
      const VF upper = all(static_cast<float>(m_terms.box.upper[axis] + m_terms.centre[axis]));
      const Mask isStill = hn::Lt(hn::Abs(along[axis]), all(1e-12f));
      const Mask isOutside = hn::Or(hn::Lt(at[axis], lower), hn::Gt(at[axis], upper));
      const VF face = hn::IfThenElse(hn::Gt(along[axis], hn::Zero(floats)), lower, upper);
      const VF entry = hn::Div(hn::Sub(face, at[axis]), hn::IfThenElse(isStill, all(1.0f), along[axis]));
      const VF never = hn::IfThenElseZero(isOutside, all(1e30f));
      begin = hn::Max(begin, hn::IfThenElse(isStill, never, entry));
    }
    return begin;
  }

  // Where paths leave the box, or `reach`.
  HWY_INLINE VF exitOf(const V3& index, const V3& perLength, float reach) const {
    VF end = all(reach);
    const VF along[3] = {perLength.x, perLength.y, perLength.z}, at[3] = {index.x, index.y, index.z};
    for (int axis = 0; axis < 3; ++axis) {
      const Mask isStill = hn::Lt(hn::Abs(along[axis]), all(1e-12f));
      const Mask isUp = hn::Gt(along[axis], hn::Zero(floats));
      const VF face =
          hn::IfThenElse(isUp, all(static_cast<float>(m_terms.box.upper[axis] + m_terms.centre[axis])),
                         all(static_cast<float>(m_terms.box.lower[axis] + m_terms.centre[axis])));
      const VF safe = hn::IfThenElse(isStill, all(1.0f), along[axis]);
      const VF exit = hn::Div(hn::Sub(face, at[axis]), safe);
      end = hn::Min(end, hn::IfThenElse(isStill, all(1e30f), exit));
    }
    return end;
  }

  // How many steps from here on lie in empty blocks on all open paths.
  HWY_INLINE float leapFrom(const V3& place, VF fastest, Mask isOpen) const {
    const BlocksAlike& empty = m_terms.empty;
    if (!empty.distances)
      return 0.0f;
    const VI x = blockOf(place.x, 0), y = blockOf(place.y, 1), z = blockOf(place.z, 2);
    HWY_ALIGN std::int32_t rows[most], inRow[most], distances[most];
    hn::Store(hn::Add(hn::Mul(z, hn::Set(ints, empty.blocks.y)), y), ints, rows);
    hn::Store(x, ints, inRow);
    for (int lane = 0; lane < lanes(); ++lane)
      distances[lane] = empty.distances[static_cast<std::size_t>(rows[lane]) * empty.blocks.x +
                                        static_cast<std::size_t>(inRow[lane])];
    const VF distance = hn::ConvertTo(floats, hn::Load(ints, distances));
    if (!hn::AllFalse(floats, hn::And(isOpen, hn::Lt(distance, all(0.5f)))))
      return 0.0f;
    const VF voxels = hn::Mul(hn::Sub(distance, all(1.0f)), all(static_cast<float>(blockSize)));
    const VF steps = hn::Div(voxels, hn::Max(fastest, all(1e-20f)));
    const float least =
        hn::GetLane(hn::MinOfLanes(floats, hn::IfThenElse(isOpen, hn::Floor(steps), all(60000.0f))));
    return std::max(1.0f, least);
  }

  HWY_INLINE VI blockOf(VF index, int axis) const {
    const VF block = hn::Floor(hn::Mul(index, all(1.0f / blockSize)));
    const auto first = static_cast<float>(m_terms.empty.first[axis]);
    const auto last = static_cast<float>(m_terms.empty.first[axis] + m_terms.empty.blocks[axis] - 1);
    return intOf(hn::Sub(clamped(block, first, last), all(first)));
  }

  HWY_INLINE VF weightAt(const V3& index) const {
    return m_terms.region.kind == VoxelSource::Kind::byte
               ? Field<VoxelSource::Kind::byte>(m_terms.region).scalarAt(index)
               : Field<VoxelSource::Kind::half>(m_terms.region).scalarAt(index);
  }

  HWY_INLINE Mask keptOf(const V3& index, Mask wanted) const {
    if (!m_terms.effects.has(Effect::region) || hn::AllFalse(floats, wanted))
      return wanted;
    return hn::And(wanted, hn::Ge(weightAt(index), all(0.5f)));
  }

  // Over the unit distance.
  HWY_NOINLINE VF extinctionAt(const V3& index, VF scalar, Mask wanted) const {
    const bool changes = m_terms.effects.hasAny(opacityChanges);
    if (m_looks.areAny()) {
      const VF factor = changes ? factorAt(index) : all(1.0f);
      const Looks::Mixed mixed = m_looks.mixedAt(index, scalar, factor, wanted, Looks::Colors::ofNone);
      return hn::IfThenElseZero(mixed.seen, mixed.extinction);
    }
    VF opacity;
    const Mask seen = m_function.opacityWhereSeen(scalar, wanted, opacity);
    if (hn::AllFalse(floats, seen))
      return hn::Zero(floats);
    if (m_terms.effects.has(Effect::region))
      opacity = hn::Mul(opacity, weightAt(index));
    if (changes)
      opacity = hn::Mul(opacity, factorAt(index));
    return hn::IfThenElseZero(seen, minusLog1mOpacity(opacity));
  }

  HWY_INLINE VF factorAt(const V3& index) const {
    return m_light.opacityFactor(m_light.gradientsOf(slopeAt(m_terms, m_field, index, lanes())));
  }

  static constexpr int most = HWY_MAX_BYTES / 4;

  const PictureTerms& m_terms;
  const Field<kind>& m_field;
  const Function& m_function;
  const Light& m_light;
  const Looks& m_looks;
  bool m_hasSurface, m_hasDepth;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
