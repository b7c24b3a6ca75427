// SPDX-License-Identifier: GPL-3.0-or-later
// How far blocks are alike along a ray: such as show nothing, and such as a region keeps wholly.
#if defined(LIMN_CPU_BLOCKS_ALIKE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_BLOCKS_ALIKE_INL_H
#undef LIMN_CPU_BLOCKS_ALIKE_INL_H
#else
#define LIMN_CPU_BLOCKS_ALIKE_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Math-inl.h"
#include "cpu/simd/Rays-inl.h"
#include "scene/steps/EmptySpace.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// The steps of a ray in units of blocks that are alike (shaders/empty_space.glsl).
class StepsAlike {
public:
  /// Of pre-integrated steps both ends must lie in such blocks: they are before and behind their samples.
  StepsAlike(const BlocksAlike& blocks, const Ray& ray, bool isPreintegrated)
      : m_alike(blocks), m_behind(isPreintegrated ? 1.0f : 0.0f) {
    if (!blocks.distances)
      return;
    for (int axis = 0; axis < 3; ++axis) {
      const float before = isPreintegrated ? ray.offset * ray.stride[axis] : 0.0f;
      m_first[axis] = (ray.first[axis] - before) / blockSize;
      m_advance[axis] = ray.stride[axis] / blockSize;
      const bool isStill = std::abs(m_advance[axis]) < 1e-20f;
      m_samples[axis] = isStill ? 0.0f : 1.0f / m_advance[axis];
      m_still[axis] = isStill ? 60000.0f : 0.0f;
    }
  }

  /// How many samples from sample `i` on lie in blocks alike.
  HWY_INLINE int samplesFrom(int i) const {
    const float steps = stepsFrom(static_cast<float>(i));
    return steps == 0.0f ? 0 : static_cast<int>(clampedCount(std::ceil(steps) - m_behind));
  }

  /// How many steps from `at`, itself in steps, lie in blocks alike; 0 where that one does not.
  HWY_INLINE float stepsFrom(float at) const {
    if (!m_alike.distances)
      return 0.0f;
    const glm::vec3 p = m_first + at * m_advance;
    const glm::ivec3 last = m_alike.first + m_alike.blocks - 1;
    const glm::ivec3 block = glm::clamp(glm::ivec3(glm::floor(p)), m_alike.first, last);
    const glm::ivec3 place = block - m_alike.first;
    const std::uint8_t distance = m_alike.distances[voxelOffset(m_alike.blocks, place.x, place.y, place.z)];
    if (distance == 0)
      return 0.0f;
    // Leave the cube of blocks through the face ahead on each axis, the nearest first.
    const float reach = static_cast<float>(distance) - 0.5f;
    const glm::vec3 steps = (glm::vec3(block) + 0.5f - p) * m_samples + reach * glm::abs(m_samples) + m_still;
    return clampedCount(std::min({steps.x, steps.y, steps.z}));
  }

private:
  HWY_INLINE static float clampedCount(float steps) { return std::clamp(steps, 0.0f, 60000.0f); }

  const BlocksAlike& m_alike;
  float m_behind;
  glm::vec3 m_first{0.0f}, m_advance{0.0f};
  glm::vec3 m_samples{0.0f}; // per block along each axis; 0 where the ray does not follow the axis
  glm::vec3 m_still{0.0f};   // beyond all samples where the ray does not follow the axis
};

/// How far along a ray a region keeps everything, so that its weights need not be read.
class WholeAlong {
public:
  WholeAlong(const PictureTerms& terms, const Ray& ray) : m_steps(terms.whole, ray, false) {}

  /// Whether it is known to keep all between two places, in steps; quick where each is behind those before.
  HWY_INLINE bool isWhole(float from, float to) {
    if (from < m_from || to > m_to) {
      m_from = from;
      m_to = from + m_steps.stepsFrom(from);
    }
    return to < m_to;
  }

private:
  StepsAlike m_steps;
  float m_from = 0.0f, m_to = 0.0f;
};

/// Lets rays begin with their first sample that does not lie in an empty block. Twin of StepsAlike for
/// several rays: a leap waits for the distance of the one before, and those of other rays use the time.
HWY_NOINLINE void leapToFirst(const BlocksAlike& empty, bool isPreintegrated, Rays& rays) {
  const VF behind = all(isPreintegrated ? 1.0f : 0.0f);
  const VF perBlock = all(1.0f / blockSize);
  VF first[3], advance[3], samples[3], reaches[3], still[3];
  for (int axis = 0; axis < 3; ++axis) {
    const VF stride = hn::Load(floats, rays.stride[axis].of);
    VF start = hn::Load(floats, rays.first[axis].of);
    if (isPreintegrated)
      start = hn::NegMulAdd(hn::Load(floats, rays.offset.of), stride, start);
    first[axis] = hn::Mul(start, perBlock);
    advance[axis] = hn::Mul(stride, perBlock);
    const Mask isStill = hn::Lt(hn::Abs(advance[axis]), all(1e-20f));
    samples[axis] =
        hn::IfThenZeroElse(isStill, hn::Div(all(1.0f), hn::IfThenElse(isStill, all(1.0f), advance[axis])));
    reaches[axis] = hn::Abs(samples[axis]);
    still[axis] = hn::IfThenElseZero(isStill, all(60000.0f));
  }
  const glm::ivec3 last = empty.first + empty.blocks - 1;
  const auto blocksPerRow = static_cast<std::size_t>(empty.blocks.x);
  const VI rowsPerSlice = hn::Set(ints, empty.blocks.y);
  const VF end = hn::ConvertTo(floats, hn::Load(ints, rays.to.of));
  VF i = hn::ConvertTo(floats, hn::Load(ints, rays.from.of));
  Mask isMoving = hn::Lt(i, end);
  while (!hn::AllFalse(floats, isMoving)) {
    VF p[3], block[3];
    VI place[3];
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = hn::MulAdd(i, advance[axis], first[axis]);
      block[axis] =
          clamped(hn::Floor(p[axis]), static_cast<float>(empty.first[axis]), static_cast<float>(last[axis]));
      place[axis] = hn::Sub(intOf(block[axis]), hn::Set(ints, empty.first[axis]));
    }
    const VI row = hn::Add(hn::Mul(place[2], rowsPerSlice), place[1]);
    HWY_ALIGN std::int32_t rowsOf[HWY_MAX_BYTES / 4], inRow[HWY_MAX_BYTES / 4], distances[HWY_MAX_BYTES / 4];
    hn::Store(row, ints, rowsOf);
    hn::Store(place[0], ints, inRow);
    for (std::size_t lane = 0; lane < hn::MaxLanes(ints); ++lane)
      distances[lane] = empty.distances[static_cast<std::size_t>(rowsOf[lane]) * blocksPerRow +
                                        static_cast<std::size_t>(inRow[lane])];
    const VF distance = hn::ConvertTo(floats, hn::Load(ints, distances));
    // Leave the cube of blocks through the face ahead on each axis, the nearest first.
    const VF reach = hn::Sub(distance, all(0.5f));
    VF alike = all(60000.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const VF toMiddle = hn::Sub(hn::Add(block[axis], all(0.5f)), p[axis]);
      alike = hn::Min(
          alike, hn::Add(hn::MulAdd(toMiddle, samples[axis], still[axis]), hn::Mul(reach, reaches[axis])));
    }
    alike = hn::Sub(hn::Ceil(alike), behind);
    isMoving =
        hn::And(isMoving, hn::And(hn::Gt(distance, hn::Zero(floats)), hn::Gt(alike, hn::Zero(floats))));
    i = hn::IfThenElse(isMoving, hn::Add(i, alike), i);
    isMoving = hn::And(isMoving, hn::Lt(i, end));
  }
  hn::Store(hn::ConvertTo(ints, hn::Min(i, end)), ints, rays.from.of);
}

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
