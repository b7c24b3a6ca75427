// SPDX-License-Identifier: GPL-3.0-or-later
// A volume longer than the driver's textures is drawn down-sampled, and the picture says so.
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "support/GlTest.h"

#include <epoxy/gl.h>

#include <cmath>

namespace limn {
namespace {

// A bar that rises slowly along its length from 0 to 200, seen from the side.
Scene longBar(int length) {
  Grid grid;
  grid.dims = {length, 3, 3};
  grid.spacingMm = {100.0 / length, 10.0, 10.0};
  std::vector<float> voxels(static_cast<std::size_t>(length) * 9);
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] =
        200.0f * static_cast<float>(i % static_cast<std::size_t>(length)) / static_cast<float>(length - 1);
  Scene scene;
  scene.volume =
      std::make_shared<const Volume>(grid, std::move(voxels), Rescale{}, std::nullopt, VolumeInfo{});
  scene.camera = defaultCamera(grid);
  scene.camera.projection = Camera::Projection::orthographic;
  scene.camera.heightMm = 110.0;
  scene.transferFunction = {30.0, {{0.0, {0.2, 0.4, 1.0}, 0.1}, {200.0, {1.0, 0.6, 0.2}, 0.9}}};
  scene.shading.model = ShadingModel::none;
  scene.quality.stepVoxels = 5.0;
  scene.quality.earlyTermination = 1.0;
  return scene;
}

using LargeVolume = test::GlTest;

TEST_F(LargeVolume, longerThanATextureIsDownSampledAndSaysSo) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  const Scene scene = longBar(largest + 100);
  constexpr glm::ivec2 size{64, 64};
  RayCaster caster;
  const Image picture = caster.render(scene, size);
  EXPECT_FALSE(caster.limitation().empty());
  // Averaging pairs of a linear ramp keeps it; only within two voxels of the ends, 0.1 % of a pixel here,
  // does it bend, and every sample moves by at most half a voxel: 200/largest/2 of the range 200, far below a
  // level.
  const Image reference = toImage(renderReference(scene, size));
  int covered = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    covered += reference.pixels[i].a > 0.5f;
    for (int channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(picture.pixels[i][channel], reference.pixels[i][channel], 1.0 / 255.0) << i;
  }
  EXPECT_GT(covered, 500);
}

TEST_F(LargeVolume, thatFitsIsDrawnWholeAndSaysNothing) {
  RayCaster caster;
  caster.render(longBar(500), {32, 32});
  EXPECT_TRUE(caster.limitation().empty()) << caster.limitation().english();
}

} // namespace
} // namespace limn
