// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every picture of every renderer, without knowing what it shows (HARD_CASES section 4).
// One row per renderer: the tolerance is its rounding, for positions that are computed from another side or
// in other units.
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"
#include "support/Heads.h"

#include <algorithm>
#include <functional>
#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 invariantSize{40, 32};

using Pixels = std::vector<glm::dvec4>;

struct Renderer {
  const char* name;
  std::function<Pixels(const Scene&)> render;
  double tolerance; ///< of equalities
  double rounding;  ///< of inequalities, whose two sides sample the same places
};

std::vector<Renderer> renderers() {
  const auto caster = std::make_shared<RayCaster>();
  const auto drawn = [caster](const Scene& scene) {
    const Image image = caster->render(scene, invariantSize);
    return Pixels(image.pixels.begin(), image.pixels.end());
  };
  const auto exact = [](const Scene& scene) { return renderReference(scene, invariantSize).pixels; };
  // GLSL: HARD_CASES section 5 for the whole picture, 4 for the order of colour and alpha.
  return {{"reference", exact, 1e-10, 1e-14}, {"GLSL", drawn, 2e-4, 1e-6}};
}

// The voxels of a volume on another grid of the same size.
std::shared_ptr<const Volume> onGrid(const Volume& volume, const Grid& grid) {
  return std::make_shared<const Volume>(grid, volume.stored(), volume.rescale(), std::nullopt, VolumeInfo{});
}

// A noisy phantom on a grid of unequal spacings that is turned against the axes of the world.
std::shared_ptr<const Volume> turnedPhantom() {
  const std::shared_ptr<const Volume> phantom = phantomVolume({.spacingMm = 5.0, .noiseHu = 15.0});
  Grid grid = phantom->grid();
  grid.spacingMm = {4.0, 5.0, 5.5};
  const glm::dvec3 x = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
  const glm::dvec3 z = glm::normalize(glm::cross(x, glm::dvec3(-0.1, 1.0, 0.2)));
  grid.direction = {x, glm::cross(z, x), z};
  grid.originMm += glm::dvec3(20.0, -30.0, 10.0);
  return onGrid(*phantom, grid);
}

Scene turnedScene(ShadingModel model) {
  static const std::shared_ptr<const Volume> volume = turnedPhantom();
  Scene scene = test::headScene(volume, model);
  scene.camera.projection = Camera::Projection::orthographic;
  scene.camera.heightMm = 260.0;
  scene.quality.stepVoxels = 0.5;
  scene.camera = orbited(scene.camera, 0.4, 0.3);
  return scene;
}

const ShadingModel allModels[] = {ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced,
                                  ShadingModel::robust};

// The pixel beside the picture's vertical middle line.
std::size_t mirroredPixel(std::size_t pixel) {
  const std::size_t width = invariantSize.x;
  return pixel - pixel % width + (width - 1 - pixel % width);
}

void expectSame(const Pixels& pixels, const Pixels& expected, double tolerance, const std::string& what,
                bool isMirrored = false, int firstChannel = 0) {
  double largest = 0.0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const glm::dvec4 other = expected[isMirrored ? mirroredPixel(i) : i];
    covered += other.a > 0.1;
    for (int channel = firstChannel; channel < 4; ++channel)
      largest = std::max(largest, std::abs(pixels[i][channel] - other[channel]));
  }
  std::cout << what << ": largest difference " << largest << "\n";
  EXPECT_LE(largest, tolerance) << what;
  EXPECT_GT(covered, pixels.size() / 10) << what << " shows almost nothing";
}

using Invariants = test::GlTest;

TEST_F(Invariants, alphaIsTheSameFromOppositeSides) {
  for (const Renderer& renderer : renderers())
    for (const ShadingModel model : allModels) {
      Scene scene = turnedScene(model);
      const Pixels front = renderer.render(scene);
      scene.camera.position = 2.0 * scene.camera.target - scene.camera.position;
      expectSame(renderer.render(scene), front, renderer.tolerance,
                 renderer.name + std::string(", alpha from behind"), true, 3);
    }
}

TEST_F(Invariants, projectionsOfTheWholeRayAreTheSameFromOppositeSides) {
  for (const Renderer& renderer : renderers())
    for (const Projection projection :
         {Projection::mip, Projection::minip, Projection::average, Projection::xray}) {
      Scene scene = turnedScene(ShadingModel::none);
      scene.projection = projection;
      // Air, which is the smallest of most rays, shows too.
      scene.transferFunction = {50.0, {{-1100.0, glm::dvec3(1.0), 0.9}, {1500.0, glm::dvec3(0.3), 0.2}}};
      const Pixels front = renderer.render(scene);
      scene.camera.position = 2.0 * scene.camera.target - scene.camera.position;
      expectSame(renderer.render(scene), front, renderer.tolerance,
                 renderer.name + std::string(", projection ") + std::to_string(int(projection)), true);
    }
}

// Everything that has a length, a thousand times as long.
Scene scaled(const Scene& scene, double factor) {
  Scene result = scene;
  Grid grid = scene.volume->grid();
  grid.spacingMm *= factor;
  grid.originMm *= factor;
  result.volume = onGrid(*scene.volume, grid);
  result.camera.position *= factor;
  result.camera.target *= factor;
  result.camera.heightMm *= factor;
  result.transferFunction.unitDistanceMm *= factor;
  result.fog.densityPerMm /= factor;
  result.fog.startMm *= factor;
  if (result.gradientOpacity)
    for (GradientOpacityPoint& point : result.gradientOpacity->points)
      point.gradient /= factor;
  return result;
}

TEST_F(Invariants, aSceneAThousandTimesAsLargeIsTheSamePicture) {
  // The gradient reference of robust is an element rounded to float, by up to 6e-8 of itself.
  constexpr double referenceRounding = 1e-7;
  for (const Renderer& renderer : renderers())
    for (const Camera::Projection projection :
         {Camera::Projection::orthographic, Camera::Projection::perspective})
      for (const ShadingModel model : allModels) {
        Scene scene = turnedScene(model);
        scene.camera.projection = projection;
        scene.fog = {Fog::Mode::exp, glm::dvec3(0.2, 0.4, 0.6), 0.001, 300.0, 0.0};
        scene.gradientOpacity = GradientOpacity{{{0.0, 0.2}, {100.0, 1.0}}};
        const Pixels expected = renderer.render(scene);
        for (const double factor : {1000.0, 0.001})
          expectSame(renderer.render(scaled(scene, factor)), expected,
                     std::max(renderer.tolerance, referenceRounding),
                     renderer.name + std::string(", scaled by ") + std::to_string(factor));
      }
}

glm::dvec3 mirrored(const glm::dvec3& v) {
  return {-v.x, v.y, v.z};
}

// The world seen in a mirror at x = 0: the grid becomes left-handed.
Scene mirrored(const Scene& scene) {
  Scene result = scene;
  Grid grid = scene.volume->grid();
  grid.originMm = mirrored(grid.originMm);
  for (int axis = 0; axis < 3; ++axis)
    grid.direction[axis] = mirrored(grid.direction[axis]);
  result.volume = onGrid(*scene.volume, grid);
  result.camera.position = mirrored(scene.camera.position);
  result.camera.target = mirrored(scene.camera.target);
  result.camera.up = mirrored(scene.camera.up);
  if (scene.shading.lightDirection)
    result.shading.lightDirection = mirrored(*scene.shading.lightDirection);
  return result;
}

// The same field with its voxels stored the other way round along the first axis.
std::shared_ptr<const Volume> reversedAlongX(const Volume& volume) {
  Grid grid = volume.grid();
  const int last = grid.dims.x - 1;
  grid.originMm = indexToWorld(grid, {last, 0, 0});
  grid.direction[0] = -grid.direction[0];
  const auto& stored = std::get<StoredVoxels<std::int16_t>>(volume.stored());
  std::vector<std::int16_t> voxels(stored.begin(), stored.end());
  for (auto row = voxels.begin(); row != voxels.end(); row += grid.dims.x)
    std::reverse(row, row + grid.dims.x);
  return std::make_shared<const Volume>(grid, voxels, volume.rescale(), std::nullopt, VolumeInfo{});
}

TEST_F(Invariants, aMirroredSceneIsTheMirroredPicture) {
  for (const Renderer& renderer : renderers())
    for (const ShadingModel model : allModels) {
      Scene scene = turnedScene(model);
      scene.camera.projection = Camera::Projection::perspective;
      scene.shading.lightDirection = glm::dvec3(1.0, 0.5, -0.4);
      const Pixels expected = renderer.render(scene);
      Scene inMirror = mirrored(scene);
      expectSame(renderer.render(inMirror), expected, renderer.tolerance,
                 renderer.name + std::string(", in a left-handed grid"), true);
      inMirror.volume = reversedAlongX(*inMirror.volume);
      expectSame(renderer.render(inMirror), expected, renderer.tolerance,
                 renderer.name + std::string(", in a reversed grid"), true);
    }
}

TEST_F(Invariants, noUnlitColourExceedsAlpha) {
  for (const Renderer& renderer : renderers()) {
    Scene scene = turnedScene(ShadingModel::none);
    for (ControlPoint& point : scene.transferFunction.points)
      point.color.r = 1.0;
    for (const glm::dvec4& pixel : renderer.render(scene)) {
      EXPECT_LE(std::max({pixel.r, pixel.g, pixel.b}), pixel.a + renderer.rounding) << renderer.name;
      EXPECT_NEAR(pixel.r, pixel.a, renderer.rounding) << renderer.name << ": a colour of 1 is alpha itself";
    }
  }
}

void expectDenser(const Pixels& after, const Pixels& before, const Renderer& renderer,
                  const std::string& what) {
  double added = 0.0;
  for (std::size_t pixel = 0; pixel < before.size(); ++pixel) {
    EXPECT_GE(after[pixel].a, before[pixel].a - renderer.rounding) << renderer.name << ", " << what;
    added += after[pixel].a - before[pixel].a;
  }
  EXPECT_GT(added, 0.0) << renderer.name << ", " << what << " changes nothing";
}

// Under one and the same discretisation; a choice between two may turn out differently for the denser
// function.
TEST_F(Invariants, addingAbsorbingMaterialNeverRaisesTheTransmittance) {
  for (const Renderer& renderer : renderers())
    for (const Preintegration preintegrated : {Preintegration::never, Preintegration::always})
      for (const ShadingModel model : {ShadingModel::none, ShadingModel::enhanced}) {
        Scene scene = turnedScene(model);
        scene.quality.preintegrated = preintegrated;
        const Pixels before = renderer.render(scene);
        for (std::size_t i = 0; i < scene.transferFunction.points.size(); ++i) {
          Scene denser = scene;
          denser.transferFunction.points[i].opacity += 0.1;
          expectDenser(renderer.render(denser), before, renderer, "point " + std::to_string(i));
        }
      }
}

// A slab thinner than a step takes one sample, in its middle, as near to the one cut face as to the other:
// the picture shows the face towards the viewer, from either side, and not what rounding chose.
TEST_F(Invariants, aSlabThinnerThanAStepShowsTheFaceTowardsTheViewer) {
  for (const Renderer& renderer : renderers())
    for (const double side : {-1.0, 1.0}) {
      Scene scene;
      scene.volume = turnedPhantom();
      const Grid& grid = scene.volume->grid();
      scene.crop.lower.y = 0.5;
      scene.crop.upper.y = 0.5 + 0.1 / grid.dims.y;
      scene.camera = defaultCamera(grid);
      scene.camera.position = boxCentreMm(grid) + side * 2.0 * boxDiagonalMm(grid) * grid.direction[1];
      scene.camera.up = grid.direction[2];
      scene.transferFunction = {0.1, {{0.0, glm::dvec3(1.0), 1.0}}};
      scene.shading.ambient = scene.shading.specular = 0.0;
      scene.shading.diffuse = scene.shading.lightIntensity = 1.0;
      int covered = 0;
      for (const glm::dvec4& pixel : renderer.render(scene)) {
        // The cosine at the picture's corners, 15° and more off the axis, is above 0.9.
        EXPECT_GE(pixel.r, 0.9 * pixel.a) << renderer.name << " from side " << side;
        covered += pixel.a > 0.1;
      }
      EXPECT_GT(covered, 100) << renderer.name;
    }
}

} // namespace
} // namespace limn
