// SPDX-License-Identifier: GPL-3.0-or-later
// What pixels drawn at random say of a picture is as often right as it claims.
#include "accuracy/sweep/ErrorByChance.h"

#include "cpu/CpuRenderer.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/ProjectionFacts.h"
#include "scene/basics/Error.h"
#include "scene/steps/RayFrame.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/RandomScene.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace limn {
namespace {

void redraw(const Scene& scene, const glm::ivec2& size, const std::vector<std::uint8_t>& wanted,
            PrecisePixels& pixels) {
  ReferencePicture picture{size, std::move(pixels), std::vector<int>(wanted.size(), 0)};
  redrawReference(picture, scene, wanted);
  pixels = std::move(picture.pixels);
}

Scene phantomScene() {
  Scene scene = headScene(phantomVolume({.spacingMm = 4.0}), ShadingModel::classic);
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = 4.0;
  return scene;
}

// How many pixels count at all, and how many of them lie farther off than `levels`.
struct Beyond {
  int met = 0, beyond = 0;
};

Beyond beyond(const Scene& scene, const Image& picture, const PrecisePixels& exact, double levels) {
  const ErrorMap map = errorMap(picture, exact);
  const RayFrame frame = rayFrame(scene.camera, scene.volume->grid(), picture.size);
  const IndexBox box = croppedBox(scene.volume->grid(), scene.crop);
  Beyond counted;
  for (int y = 0; y < picture.size.y; ++y)
    for (int x = 0; x < picture.size.x; ++x)
      if (!spanInBox(framedRay(frame, x, y, picture.size), box).isEmpty()) {
        ++counted.met;
        counted.beyond += map.levels[static_cast<std::size_t>(y) * picture.size.x + x] > levels ? 1 : 0;
      }
  return counted;
}

// 5 % of the draws, and three standard deviations of so many.
double mostWrong(int draws) {
  return 0.05 * draws + 3.0 * std::sqrt(0.05 * 0.95 * draws);
}

TEST(ErrorByChance, aShareJustAboveOneInAThousandIsMissedAsOftenAsItSays) {
  // The exact picture is empty; of one in 999 pixels that count the picture is off by a level.
  const Scene scene = phantomScene();
  constexpr glm::ivec2 size(200, 160);
  const auto empty = [](const Scene&, const glm::ivec2&, const std::vector<std::uint8_t>&, PrecisePixels&) {};
  const RayFrame frame = rayFrame(scene.camera, scene.volume->grid(), size);
  const IndexBox box = croppedBox(scene.volume->grid(), scene.crop);
  Image picture(size);
  int met = 0, off = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      if (!spanInBox(framedRay(frame, x, y, size), box).isEmpty() && ++met % 999 == 0) {
        picture.at(x, y).a = 1.0f / 255.0f;
        ++off;
      }
  ASSERT_GT(off, 5);
  constexpr int draws = 1000;
  int missed = 0;
  for (int seed = 0; seed < draws; ++seed)
    missed += errorByChance(scene, picture, empty, static_cast<std::uint64_t>(seed))->levels < 0.5 ? 1 : 0;
  std::cout << missed << " of " << draws << " draws missed " << off << " of " << met << " pixels\n";
  EXPECT_LE(missed, mostWrong(draws));
  EXPECT_GE(missed, 0.01 * draws) << "a share as large as that is sometimes missed";
}

TEST(ErrorByChance, aPictureThatIsFalsifiedIsFound) {
  const Scene scene = phantomScene();
  Image picture = CpuRenderer().render(scene, {160, 128});
  const std::optional<ErrorByChance> honest = errorByChance(scene, picture, redraw);
  ASSERT_TRUE(honest);
  EXPECT_LT(honest->levels, 2.0);
  EXPECT_LE(honest->own, std::max(0.02, 0.1 * honest->levels));
  // One in a hundred: missed with a chance of 0.99 to the power of 2995, which is 1e-13.
  for (std::size_t i = 0; i < picture.pixels.size(); i += 100)
    picture.pixels[i].g += 4.0f / 255.0f;
  EXPECT_GE(errorByChance(scene, picture, redraw)->levels, 3.0);
  picture.pixels.assign(picture.pixels.size(), glm::vec4(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_GE(errorByChance(scene, picture, redraw)->levels, 255.0);
}

TEST(ErrorByChance, isTheSameForTheSamePicture) {
  const Scene scene = phantomScene();
  const Image picture = CpuRenderer().render(scene, {64, 48});
  EXPECT_EQ(errorByChance(scene, picture, redraw), errorByChance(scene, picture, redraw));
}

// LIMN_CHANCE_SCENES more than the usual few: the figure in tests/EVIDENCE.md.
TEST(ErrorByChance, holdsOnRandomScenesAgainstTheWholeExactPicture) {
  const char* asked = std::getenv("LIMN_CHANCE_SCENES");
  const int scenes = asked ? std::atoi(asked) : 16;
  CpuRenderer renderer;
  int judged = 0, wrong = 0, told = 0;
  for (std::uint64_t seed = 1; judged < scenes; ++seed) {
    Scene scene;
    try {
      scene = randomScene(seed).scene;
    } catch (const Error&) {
      continue; // a volume that Volume refuses
    }
    if (!integrates(scene.projection))
      continue;
    ++judged;
    constexpr glm::ivec2 size(60, 48);
    const Image picture = renderer.render(scene, size);
    const std::optional<ErrorByChance> said = errorByChance(scene, picture, redraw);
    if (!said)
      continue;
    ++told;
    const ConvergedPicture exact = convergedPicture(scene, size, redraw);
    const Beyond counted = beyond(scene, picture, exact.pixels, said->levels);
    if (counted.beyond > 0.001 * counted.met) {
      ++wrong;
      std::cout << "seed " << seed << ": " << counted.beyond << " of " << counted.met << " beyond "
                << said->levels << "\n";
    }
  }
  std::cout << wrong << " wrong of " << told << " told of " << judged << " random scenes\n";
  EXPECT_LE(wrong, mostWrong(told));
  EXPECT_GE(told, 0.8 * judged);
}

} // namespace
} // namespace limn
