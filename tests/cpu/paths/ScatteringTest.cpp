// SPDX-License-Identifier: GPL-3.0-or-later
// What random paths draw directions from, and what they read of a volume.
#include "cpu/paths/Scattering.h"
#include "cpu/paths/SlabPaths.h"
#include "reference/RaySamples.h"
#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

#include <numbers>

namespace limn {
namespace {

using test::Tally;

// ∫ f over the cosine from -1 to 1, by Simpson's rule.
template <class F>
double overCosines(const F& f) {
  constexpr int steps = 20000;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
    sum += (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * f(-1.0 + 2.0 * i / steps);
  return sum * 2.0 / (3.0 * steps);
}

TEST(Phases, sendOnAllLightWithTheirMeanCosine) {
  for (const float g : {-0.95f, -0.5f, 0.0f, 0.0005f, 0.3f, 0.75f, 0.95f}) {
    const auto p = [g](double cosine) {
      return 2.0 * std::numbers::pi * double(cpu::phase(g, static_cast<float>(cosine)));
    };
    // Floats tell the function near its peak to 10⁻⁴ of itself where g is large.
    EXPECT_NEAR(overCosines(p), 1.0, 2e-4) << g;
    EXPECT_NEAR(overCosines([&](double c) { return c * p(c); }), double(g), 2e-4) << g;
    Tally cosines;
    const glm::vec3 before = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
    for (std::uint32_t n = 0; n < 100'000; ++n) {
      cpu::PathRandom random(3, 1, 1, n);
      cosines.add(double(glm::dot(before, cpu::phaseDirection(g, before, random))));
    }
    EXPECT_LT(std::abs(cosines.z(double(g))), 4.0) << g;
  }
}

TEST(Surfaces, drawDirectionsFromWhatTheyReflect) {
  for (const float share : {0.0f, 0.1f, 1.0f})
    for (const float exponent : {1.0f, 8.0f, 64.0f})
      for (const float cosine : {0.95f, 0.5f, 0.15f}) {
        const cpu::Surface surface{{0.0f, 0.0f, 1.0f}, glm::vec3(0.8f, 0.5f, 0.2f), share, exponent};
        const glm::vec3 view(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
        Tally drawn, looked;
        for (std::uint32_t n = 0; n < 200'000; ++n) {
          cpu::PathRandom random(9, 2, 1, n);
          glm::vec3 light;
          const glm::vec3 worth = surface.drawn(view, random, light);
          // Light from a sky that is brighter on one side.
          drawn.add(double(worth.r) * (1.0 + 0.5 * double(light.x)));
          cpu::PathRandom other(9, 2, 2, n);
          const glm::vec3 from = cpu::withinCone({0.0f, 0.0f, 1.0f}, 0.0f, other);
          looked.add(2.0 * std::numbers::pi * double(surface.reflected(view, from).r) *
                     (1.0 + 0.5 * double(from.x)));
        }
        const double spread = std::hypot(drawn.error(), looked.error());
        EXPECT_LT(std::abs(drawn.mean() - looked.mean()), 4.0 * spread)
            << share << " " << exponent << " " << cosine;
        EXPECT_LE(drawn.mean(), 1.5) << "more than a white surface under the brightest of that sky";
      }
}

TEST(Media, areTheReferencesTissue) {
  Scene scene = headScene(phantomVolume({.spacingMm = 8.0}), ShadingModel::physical);
  scene.gradientOpacity = GradientOpacity{{{0.0, 0.3}, {60.0, 1.0}}};
  scene.keep = cubesRegion(scene.volume->grid().dims, 7, {0.0, 1.0, 0.4});
  scene.shading.physical.density = 2.5;
  for (const bool hasLooks : {false, true}) {
    if (hasLooks)
      scene.keep = withVariedLooks(scene.keep, scene.transferFunction);
    const test::PathsOf of(scene);
    const PictureTerms reference{of.medium, {}, true};
    const Grid& grid = scene.volume->grid();
    visitVoxels(*scene.volume, [&]<class T>(const StoredVoxels<T>& stored) {
      if constexpr (std::is_same_v<T, std::int16_t>) {
        const cpu::Medium<std::int16_t> medium(of.paths);
        const FieldSampler<T> field(*scene.volume, stored);
        for (std::uint32_t n = 0; n < 2000; ++n) {
          cpu::PathRandom random(2, 0, 0, n);
          glm::vec3 place;
          for (int axis = 0; axis < 3; ++axis)
            place[axis] = random.next() * static_cast<float>(grid.dims[axis]) - 0.5f;
          const FramedRay ray{glm::dvec3(place) - centreIndex(grid), {0.0, 0.0, 1.0}, 0.0};
          const RaySamples<T> samples(reference, field, ray, {0.0, 1.0}, 0.0);
          const auto absorbed = samples.absorbedAt(0.0, samples.materialAt(0.0), samples.steepnessAt(0.0));
          const double expected = absorbed.extinction * of.terms.lengthMm / reference.unitMm;
          // Scalars of 12 bits in floats, and a slope of the curve times them.
          EXPECT_NEAR(double(medium.extinctionAt(place)), expected, 1e-4 * (0.1 + expected));
          if (expected > 0.0) {
            const glm::vec3 albedo = medium.albedoAt(place);
            for (int c = 0; c < 3; ++c)
              EXPECT_NEAR(double(albedo[c]), cpu::decoded(absorbed.color[c]), 1e-4);
          }
        }
      }
    });
  }
}

TEST(Media, majorantsBoundThemEverywhere) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Scene scene = headScene(phantomVolume({.spacingMm = 6.0}), ShadingModel::physical);
    scene.transferFunction = shifted(scene.transferFunction, 37.0 * static_cast<double>(seed));
    scene.keep =
        withVariedLooks(cubesRegion(scene.volume->grid().dims, 5, {1.0, 0.0, 0.7}), scene.transferFunction);
    const test::PathsOf of(scene);
    const cpu::Medium<std::int16_t> medium(of.paths);
    ASSERT_EQ(of.paths.voxels.kind, cpu::VoxelSource::Kind::signedHalf);
    for (std::uint32_t n = 0; n < 20'000; ++n) {
      cpu::PathRandom random(7, static_cast<std::uint32_t>(seed), 0, n);
      glm::vec3 place;
      for (int axis = 0; axis < 3; ++axis)
        place[axis] = random.next() * static_cast<float>(scene.volume->grid().dims[axis]) - 0.5f;
      const glm::ivec3 block =
          glm::clamp(glm::ivec3(glm::floor(place / 4.0f)), glm::ivec3(0), of.paths.majorants.blocks - 1);
      EXPECT_LE(
          medium.extinctionAt(place),
          of.paths.majorants.ofBlocks[voxelOffset(of.paths.majorants.blocks, block.x, block.y, block.z)]);
    }
  }
}

} // namespace
} // namespace limn
