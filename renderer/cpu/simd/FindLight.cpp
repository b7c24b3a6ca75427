// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/simd/FindLight.h"

// Highway compiles what follows once for each instruction set, this file included by itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/simd/FindLight.cpp"
#include <hwy/foreach_target.h>
// The order matters.
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "cpu/simd/Samples-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// Highway's dispatch asks for them; requireInstructionSet() refuses such processors.
void findDirectHere(const PictureTerms&, const LightNodes&, std::span<const std::int32_t>, std::uint8_t*) {}
void findAmbientHere(const PictureTerms&, const LightNodes&, std::span<const std::int32_t>,
                     std::array<std::uint8_t, 4>*) {}

#else

// Behind so many lengths what a path meets is seen from afar, by many nodes alike: steps may be longer.
constexpr float farLengths = 8.5f;

// A tenth of a level of the brightest light.
constexpr float leastLeft = 5e-4f;

// What comes of a light that has a direction to several nodes: in twice and twice as many of its directions
// until two changes on end are smaller than a step of the nodes' codes.
template <VoxelSource::Kind kind>
class DirectLightAt {
public:
  DirectLightAt(const TravelTerms& travel, const LightMarch<kind>& march)
      : m_travel(travel), m_march(march) {}

  HWY_NOINLINE VF of(const V3& index) const {
    const std::vector<glm::vec3>& directions = *m_travel.towardsLight;
    const auto total = static_cast<int>(directions.size());
    Means means{hn::Ge(all(1.0f), hn::Zero(floats)), hn::Lt(all(1.0f), hn::Zero(floats)), all(-1.0f)};
    VF sum = hn::Zero(floats);
    int count = 0;
    for (int until = std::min(fewest, total);; until = std::min(2 * until, total)) {
      for (; count < until; ++count)
        sum = hn::Add(sum, along(index, all(directions[static_cast<std::size_t>(count)]), means.open));
      if (!goesOn(sum, until, total, means))
        return means.mean;
    }
  }

private:
  static constexpr int fewest = 16;
  static constexpr float leastChange = 1.0f / 512.0f;

  // The means of places so far: of open ones they go on.
  struct Means {
    Mask open, isStill;
    VF mean;
  };

  HWY_NOINLINE VF along(const V3& index, const V3& direction, Mask open) const {
    const VF near = m_march.transmittance(index, direction, m_travel.from, farLengths, m_travel.step, open);
    const Mask isLeft = hn::And(open, hn::Gt(near, all(leastLeft)));
    if (hn::AllFalse(floats, isLeft))
      return hn::Zero(floats);
    const VF far = m_march.transmittance(index, direction, farLengths, 1e30f, m_travel.farStep, isLeft);
    return hn::IfThenElseZero(isLeft, hn::Mul(near, far));
  }

  // Keeps the means of open places, and closes those that two changes on end have left alone. Whether any is
  // open.
  HWY_INLINE static bool goesOn(VF sum, int count, int total, Means& means) {
    const VF next = hn::Mul(sum, all(1.0f / static_cast<float>(count)));
    const Mask stands = hn::Lt(hn::Abs(hn::Sub(next, means.mean)), all(leastChange));
    means.mean = hn::IfThenElse(means.open, next, means.mean);
    // What is all or nothing in twice the fewest directions is taken to be so in all.
    const Mask isPlain = hn::Or(hn::Gt(next, all(1.0f - leastLeft)), hn::Lt(next, all(leastLeft)));
    const Mask stays =
        count > fewest ? hn::Or(isPlain, hn::And(stands, means.isStill)) : hn::And(stands, means.isStill);
    means.open = hn::AndNot(stays, means.open);
    means.isStill = stands;
    return count < total && !hn::AllFalse(floats, means.open);
  }

  const TravelTerms& m_travel;
  const LightMarch<kind>& m_march;
};

// The nodes of a picture's grid, as many at a time as registers hold.
template <VoxelSource::Kind kind>
class Nodes {
public:
  Nodes(const PictureTerms& terms, const LightNodes& nodes)
      : m_terms(terms), m_travel(terms.travel), m_nodes(nodes), m_samples(terms, m_noRay),
        m_march(terms, m_samples.field, m_samples.function, m_samples.light, m_samples.looks) {}

  void direct(std::span<const std::int32_t> numbers, std::uint8_t* out) const {
    const DirectLightAt<kind> light(m_travel, m_march);
    for (std::size_t begin = 0; begin < numbers.size(); begin += static_cast<std::size_t>(lanes())) {
      const V3 index = indexOf(numbers, begin);
      const VF comes = light.of(index);
      HWY_ALIGN float codes[most];
      // What comes from afar alone is smooth in tissue, too.
      const Mask every = hn::Ge(comes, hn::Zero(floats));
      hn::Store(codeOf(comes, m_travel.from > 0.0f ? every : mayBeSeen(index, comes)), floats, codes);
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes()) && begin + lane < numbers.size();
           ++lane)
        out[numbers[begin + lane]] = static_cast<std::uint8_t>(codes[lane]);
    }
  }

  void ambient(std::span<const std::int32_t> numbers, std::array<std::uint8_t, 4>* out) const {
    const Mask every = hn::Ge(all(1.0f), hn::Zero(floats));
    for (std::size_t begin = 0; begin < numbers.size(); begin += static_cast<std::size_t>(lanes())) {
      const V3 index = indexOf(numbers, begin);
      VF sum = hn::Zero(floats);
      V3 lean = zero();
      for (const glm::vec3& direction : *m_travel.onSphere) {
        const VF comes =
            m_march.transmittance(index, all(direction), m_travel.from, m_travel.reach, m_travel.step, every);
        sum = hn::Add(sum, comes);
        lean = {hn::MulAdd(comes, all(direction.x), lean.x), hn::MulAdd(comes, all(direction.y), lean.y),
                hn::MulAdd(comes, all(direction.z), lean.z)};
      }
      const float per = 1.0f / static_cast<float>(m_travel.onSphere->size());
      const VF comes = hn::Mul(sum, all(per));
      HWY_ALIGN float codes[4][most];
      hn::Store(codeOf(comes, mayBeSeen(index, comes)), floats, codes[0]);
      hn::Store(codeAlong(hn::Mul(lean.x, all(2.0f * per))), floats, codes[1]);
      hn::Store(codeAlong(hn::Mul(lean.y, all(2.0f * per))), floats, codes[2]);
      hn::Store(codeAlong(hn::Mul(lean.z, all(2.0f * per))), floats, codes[3]);
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes()) && begin + lane < numbers.size();
           ++lane)
        for (std::size_t part = 0; part < 4; ++part)
          out[numbers[begin + lane]][part] = static_cast<std::uint8_t>(codes[part][lane]);
    }
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;

  // Voxel indices of the nodes from `begin` on; behind the last, of the last.
  HWY_INLINE V3 indexOf(std::span<const std::int32_t> numbers, std::size_t begin) const {
    HWY_ALIGN float at[3][most];
    for (int lane = 0; lane < lanes(); ++lane) {
      const std::size_t place = std::min(begin + static_cast<std::size_t>(lane), numbers.size() - 1);
      const std::int32_t row = numbers[place] / m_nodes.count.x;
      const glm::dvec3 node(numbers[place] % m_nodes.count.x, row % m_nodes.count.y, row / m_nodes.count.y);
      const glm::vec3 index(m_terms.centre + m_nodes.first + node * m_nodes.stride);
      for (int axis = 0; axis < 3; ++axis)
        at[axis][lane] = index[axis];
    }
    return {hn::Load(floats, at[0]), hn::Load(floats, at[1]), hn::Load(floats, at[2])};
  }

  // Whether a place may be seen from anywhere. Where half of the light comes it may; else it is looked
  // around: what hides a place lies near it.
  HWY_INLINE Mask mayBeSeen(const V3& index, VF comes) const {
    Mask seen = hn::Ge(comes, all(0.5f));
    for (int corner = 0; corner < 27; ++corner) {
      const glm::vec3 towards(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
      // Sides and corners of a cube.
      const int axes = (towards.x != 0.0f) + (towards.y != 0.0f) + (towards.z != 0.0f);
      if (axes != 1 && axes != 3)
        continue;
      const Mask unknown = hn::Not(seen);
      if (hn::AllFalse(floats, unknown))
        break;
      const VF clear = m_march.transmittance(index, all(glm::normalize(towards)), 0.0f, aroundLengths,
                                             m_travel.step, unknown);
      seen = hn::Or(seen, hn::And(unknown, hn::Gt(clear, all(leastSeen))));
    }
    return seen;
  }

  HWY_INLINE static VF codeOf(VF share, Mask known) {
    return hn::IfThenElseZero(known, hn::Floor(hn::MulAdd(share, all(254.0f), all(1.5f))));
  }

  HWY_INLINE static VF codeAlong(VF share) {
    return clamped(hn::Floor(hn::MulAdd(share, all(254.0f), all(127.5f))), 0.0f, 255.0f);
  }

  static constexpr float aroundLengths = 12.0f;
  // What a node says that less of is seen would change no level.
  static constexpr float leastSeen = 0.02f;

  const PictureTerms& m_terms;
  const TravelTerms& m_travel;
  const LightNodes& m_nodes;
  Ray m_noRay; // of the samples, which are places in the volume
  Samples<kind> m_samples;
  LightMarch<kind> m_march;
};

template <VoxelSource::Kind kind>
struct OfKind {
  static void find(const PictureTerms& terms, const LightNodes& nodes, std::span<const std::int32_t> numbers,
                   std::uint8_t* out) {
    Nodes<kind>(terms, nodes).direct(numbers, out);
  }
  static void find(const PictureTerms& terms, const LightNodes& nodes, std::span<const std::int32_t> numbers,
                   std::array<std::uint8_t, 4>* out) {
    Nodes<kind>(terms, nodes).ambient(numbers, out);
  }
};

template <class Out>
void findHere(const PictureTerms& terms, const LightNodes& nodes, std::span<const std::int32_t> numbers,
              Out* out) {
  switch (terms.voxels.kind) {
  case VoxelSource::Kind::byte:
    return OfKind<VoxelSource::Kind::byte>::find(terms, nodes, numbers, out);
  case VoxelSource::Kind::signedByte:
    return OfKind<VoxelSource::Kind::signedByte>::find(terms, nodes, numbers, out);
  case VoxelSource::Kind::half:
    return OfKind<VoxelSource::Kind::half>::find(terms, nodes, numbers, out);
  case VoxelSource::Kind::signedHalf:
    return OfKind<VoxelSource::Kind::signedHalf>::find(terms, nodes, numbers, out);
  case VoxelSource::Kind::single:
    break;
  }
  OfKind<VoxelSource::Kind::single>::find(terms, nodes, numbers, out);
}

void findDirectHere(const PictureTerms& terms, const LightNodes& nodes, std::span<const std::int32_t> numbers,
                    std::uint8_t* out) {
  findHere(terms, nodes, numbers, out);
}

void findAmbientHere(const PictureTerms& terms, const LightNodes& nodes,
                     std::span<const std::int32_t> numbers, std::array<std::uint8_t, 4>* out) {
  findHere(terms, nodes, numbers, out);
}

#endif

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "cpu/simd/InstructionSet.h"

namespace limn::cpu {

HWY_EXPORT(findDirectHere);
HWY_EXPORT(findAmbientHere);

void findDirect(const PictureTerms& terms, const LightNodes& nodes, std::span<const std::int32_t> numbers,
                std::uint8_t* out) {
  requireInstructionSet();
  HWY_DYNAMIC_DISPATCH(findDirectHere)(terms, nodes, numbers, out);
}

void findAmbient(const PictureTerms& terms, const LightNodes& nodes, std::span<const std::int32_t> numbers,
                 std::array<std::uint8_t, 4>* out) {
  requireInstructionSet();
  HWY_DYNAMIC_DISPATCH(findAmbientHere)(terms, nodes, numbers, out);
}

} // namespace limn::cpu

#endif
