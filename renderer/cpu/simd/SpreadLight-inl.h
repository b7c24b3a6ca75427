// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of light to the samples of a ray (DEFINITION section 11) along few paths, which are spread over
// them by what each adds to the pixel: as many paths a pixel, whether one surface shows or all of a haze.
#if defined(LIMN_CPU_SPREAD_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_SPREAD_LIGHT_INL_H
#undef LIMN_CPU_SPREAD_LIGHT_INL_H
#else
#define LIMN_CPU_SPREAD_LIGHT_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/LightMarch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// How far along a ray its paths are given out.
struct SpreadTurn {
  double share = 0.0;                  ///< of the pixel that earlier samples take
  float direct = 1.0f, ambient = 1.0f; ///< M of the last sample that had paths
};

/// M of samples, front to back. Path n of N belongs to the sample in which part n/N of the pixel lies. Any
/// consecutive directions of their sequence are spread evenly, so that those of a ray are together, whatever
/// samples they belong to; samples between two paths take what comes to the one before. Each pixel turns the
/// directions by an angle of its own: what is left of the error is no pattern.
template <VoxelSource::Kind kind>
class SpreadLight {
public:
  HWY_INLINE SpreadLight(const PictureTerms& terms, const LightMarch<kind>& march, const glm::ivec2& pixel)
      : m_terms(terms), m_march(march), m_count(terms.travel.spread) {
    const float angle = angleOf(pixel);
    m_cosine = std::cos(angle);
    m_sine = std::sin(angle);
  }

  /// Of as many samples as lanes, at voxel indices with normals of unit length, or zero, which take `shares`
  /// of the pixel, in this order; 0 where there is none.
  HWY_NOINLINE Reaching of(const V3& index, const V3& normal, VF shares, SpreadTurn& turn) const {
    Paths paths;
    give(shares, turn, paths);
    Reaching reaching{all(turn.direct), all(turn.ambient)};
    if (paths.total == 0)
      return reaching;
    hn::Store(index.x, floats, paths.index[0]);
    hn::Store(index.y, floats, paths.index[1]);
    hn::Store(index.z, floats, paths.index[2]);
    if (m_terms.effects.has(Effect::shadow))
      reaching.direct = directAlong(paths, turn.direct);
    if (m_terms.effects.has(Effect::occlusion))
      reaching.ambient = ambientAlong(paths, normal, turn.ambient);
    return reaching;
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;
  static constexpr float middle = 6.5f; // lengths; what is farther off is seen by many places alike

  // Which paths begin at which sample.
  struct Paths {
    int total = 0;
    int first = 0;       // of the sequence
    int begin[most + 1]; // of each sample, from the first on
    HWY_ALIGN float index[3][most];
  };

  HWY_INLINE static float angleOf(const glm::ivec2& pixel) {
    auto bits =
        static_cast<std::uint32_t>(pixel.x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(pixel.y) * 0x85ebca77u;
    bits ^= bits >> 15;
    bits *= 0x2c1b3c6du;
    bits ^= bits >> 12;
    bits *= 0x297a2d39u;
    bits ^= bits >> 15;
    return static_cast<float>(bits >> 8) * (0x1p-24f * 6.2831853f);
  }

  // How many paths begin before so much of the pixel.
  HWY_INLINE int pathsBefore(double share) const { return static_cast<int>(std::ceil(share * m_count)); }

  HWY_INLINE void give(VF shares, SpreadTurn& turn, Paths& paths) const {
    HWY_ALIGN float share[most];
    hn::Store(shares, floats, share);
    paths.first = pathsBefore(turn.share);
    for (int lane = 0; lane < lanes(); ++lane) {
      paths.begin[lane] = pathsBefore(turn.share) - paths.first;
      turn.share += share[lane];
    }
    paths.total = paths.begin[lanes()] = pathsBefore(turn.share) - paths.first;
  }

  HWY_INLINE VF directAlong(const Paths& paths, float& last) const {
    const std::vector<glm::vec3>& directions = *m_terms.travel.towardsLight;
    if (directions.size() == 1)
      return alongOne(paths, directions.front(), last);
    const glm::vec3 axis(m_terms.towardsLight);
    return along(paths, 1e30f, last, [&](int, int n) {
      const glm::vec3& v = directions[static_cast<std::size_t>(n) % directions.size()];
      return m_cosine * v + m_sine * glm::cross(axis, v) + (1.0f - m_cosine) * glm::dot(axis, v) * axis;
    });
  }

  // The only path of each sample that has any.
  HWY_INLINE VF alongOne(const Paths& paths, const glm::vec3& direction, float& last) const {
    HWY_ALIGN float means[most];
    HWY_ALIGN float comes[most];
    for (int lane = 0; lane < lanes(); ++lane)
      means[lane] = paths.begin[lane + 1] > paths.begin[lane] ? 1.0f : 0.0f;
    const Mask wanted = hn::Gt(hn::Load(floats, means), hn::Zero(floats));
    hn::Store(transmittance({hn::Load(floats, paths.index[0]), hn::Load(floats, paths.index[1]),
                             hn::Load(floats, paths.index[2])},
                            all(direction), 1e30f, wanted),
              floats, comes);
    for (int lane = 0; lane < lanes(); ++lane) {
      if (means[lane] > 0.0f)
        last = comes[lane];
      means[lane] = last;
    }
    return hn::Load(floats, means);
  }

  HWY_INLINE VF ambientAlong(const Paths& paths, const V3& normal, float& last) const {
    const Mask hasNormal = hn::Gt(dot(normal, normal), all(0.25f));
    const Axes axes(chosen(hasNormal, normal, {hn::Zero(floats), hn::Zero(floats), all(1.0f)}));
    HWY_ALIGN float first[3][most], second[3][most], third[3][most], has[most];
    store(axes.first, first);
    store(axes.second, second);
    store(axes.third, third);
    hn::Store(hn::IfThenElseZero(hasNormal, all(1.0f)), floats, has);
    const std::vector<glm::vec3>& byCosine = *m_terms.travel.byCosine;
    const std::vector<glm::vec3>& onSphere = *m_terms.travel.onSphere;
    return along(paths, m_terms.travel.reach, last, [&](int lane, int n) {
      const std::size_t at = static_cast<std::size_t>(n) % byCosine.size();
      const glm::vec3& v = has[lane] == 0.0f ? onSphere[at] : byCosine[at];
      const float x = m_cosine * v.x - m_sine * v.y, y = m_sine * v.x + m_cosine * v.y;
      if (has[lane] == 0.0f)
        return glm::vec3(x, y, v.z);
      return glm::vec3(first[0][lane] * x + second[0][lane] * y + third[0][lane] * v.z,
                       first[1][lane] * x + second[1][lane] * y + third[1][lane] * v.z,
                       first[2][lane] * x + second[2][lane] * y + third[2][lane] * v.z);
    });
  }

  HWY_INLINE static void store(const V3& v, float (&to)[3][most]) {
    hn::Store(v.x, floats, to[0]);
    hn::Store(v.y, floats, to[1]);
    hn::Store(v.z, floats, to[2]);
  }

  // The mean of each sample's paths; of one without any that of the one before. Paths of several samples are
  // marched together.
  template <class DirectionOf>
  HWY_INLINE VF along(const Paths& paths, float reach, float& last, const DirectionOf& directionOf) const {
    HWY_ALIGN float means[most];
    float sum = 0.0f;
    int sample = 0;
    for (int done = 0; done < paths.total; done += lanes()) {
      HWY_ALIGN float place[3][most], towards[3][most], comes[most];
      int of[most];
      const int count = std::min(lanes(), paths.total - done);
      int owner = sample;
      for (int lane = 0; lane < lanes(); ++lane) {
        const int n = done + std::min(lane, count - 1);
        while (n >= paths.begin[owner + 1])
          ++owner;
        of[lane] = owner;
        const glm::vec3 direction = directionOf(owner, paths.first + n);
        for (int axis = 0; axis < 3; ++axis) {
          place[axis][lane] = paths.index[axis][owner];
          towards[axis][lane] = direction[axis];
        }
      }
      hn::Store(
          transmittance(
              {hn::Load(floats, place[0]), hn::Load(floats, place[1]), hn::Load(floats, place[2])},
              {hn::Load(floats, towards[0]), hn::Load(floats, towards[1]), hn::Load(floats, towards[2])},
              reach, hn::FirstN(floats, static_cast<std::size_t>(count))),
          floats, comes);
      for (int lane = 0; lane < count; ++lane) {
        for (; sample < of[lane]; ++sample)
          closeSample(paths, sample, sum, last, means);
        sum += comes[lane];
      }
    }
    for (; sample < lanes(); ++sample)
      closeSample(paths, sample, sum, last, means);
    return hn::Load(floats, means);
  }

  HWY_INLINE static void closeSample(const Paths& paths, int sample, float& sum, float& last, float* means) {
    const int count = paths.begin[sample + 1] - paths.begin[sample];
    if (count > 0)
      last = sum / static_cast<float>(count);
    means[sample] = last;
    sum = 0.0f;
  }

  HWY_INLINE VF transmittance(const V3& index, const V3& direction, float reach, Mask wanted) const {
    const TravelTerms& travel = m_terms.travel;
    const float end = std::min(middle, reach);
    const VF near = m_march.transmittance(index, direction, travel.from, end, travel.step, wanted);
    if (!(reach > end))
      return near;
    const Mask isLeft = hn::And(wanted, hn::Gt(near, all(1.0f / 1024.0f)));
    if (hn::AllFalse(floats, isLeft))
      return hn::Zero(floats);
    const VF far = m_march.transmittance(index, direction, end, reach, travel.farStep, isLeft);
    return hn::IfThenElseZero(isLeft, hn::Mul(near, far));
  }

  const PictureTerms& m_terms;
  const LightMarch<kind>& m_march;
  int m_count;
  float m_cosine, m_sine;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
