// SPDX-License-Identifier: GPL-3.0-or-later
// Random scenes: the reference and GLSL against each other where nobody would think of looking
// (HARD_CASES section 5). A kind chooses the effects, so that a few programs serve many seeds; a seed chooses
// all numbers.
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/steps/RayFrame.h"
#include "support/GlTest.h"

#include <iostream>
#include <random>

namespace limn {
namespace {

constexpr glm::ivec2 randomSize{12, 10};

class Dice {
public:
  explicit Dice(unsigned seed) : m_generator(seed) {}
  double between(double low, double high) { return low + (high - low) * (m_generator() / 4294967296.0); }
  double ratio(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }
  int upTo(int count) { return static_cast<int>(m_generator() % static_cast<unsigned>(count)); }
  bool oneIn(int count) { return upTo(count) == 0; }
  glm::dvec3 vector(double low, double high) {
    const double x = between(low, high), y = between(low, high);
    return {x, y, between(low, high)};
  }

private:
  std::mt19937 m_generator;
};

std::shared_ptr<const Volume> randomVolume(Dice& dice) {
  Grid grid;
  for (int axis = 0; axis < 3; ++axis)
    grid.dims[axis] = 1 + dice.upTo(9);
  const double size = dice.ratio(1e-3, 1e3);
  grid.spacingMm = size * glm::dvec3(dice.ratio(0.5, 2.0), dice.ratio(0.5, 2.0), dice.ratio(0.5, 2.0));
  grid.originMm = size * dice.vector(-20.0, 20.0);
  const glm::dvec3 x = glm::normalize(dice.vector(-1.0, 1.0) + glm::dvec3(1e-3));
  const glm::dvec3 y = glm::normalize(glm::cross(x, dice.vector(-1.0, 1.0)));
  grid.direction = {x, y, (dice.oneIn(2) ? -1.0 : 1.0) * glm::cross(x, y)};
  std::vector<double> voxels(static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z);
  for (double& voxel : voxels)
    voxel = dice.between(-1000.0, 2000.0);
  return std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{});
}

TransferFunction randomFunction(Dice& dice, double sizeMm) {
  TransferFunction function;
  function.unitDistanceMm = sizeMm * dice.ratio(0.1, 10.0);
  const auto opacity = [&dice] { return dice.oneIn(3) ? 0.0 : dice.oneIn(8) ? 1.0 : dice.ratio(1e-4, 1.0); };
  const int points = dice.upTo(7);
  for (int i = 0; i < points; ++i) {
    const double value = dice.between(-1200.0, 2200.0);
    function.points.push_back({value, dice.vector(0.0, 1.0), opacity()});
    if (dice.oneIn(3))
      function.points.push_back({value + dice.ratio(1e-3, 10.0), dice.vector(0.0, 1.0), opacity()});
    if (dice.oneIn(4))
      function.points.push_back({value, dice.vector(0.0, 1.0), opacity()});
  }
  return normalised(function);
}

Camera randomCamera(Dice& dice, const Grid& grid) {
  Camera camera = orbited(defaultCamera(grid), dice.between(-3.0, 3.0), dice.between(-3.0, 3.0));
  if (dice.oneIn(2)) {
    camera.projection = Camera::Projection::orthographic;
    camera.heightMm = 0.8 * boxDiagonalMm(grid);
  } else if (dice.oneIn(2)) {
    camera = zoomed(camera, dice.ratio(0.1, 10.0)); // into the box, too
  }
  return camera;
}

// The numbers of a scene without effects beyond those of its model.
Scene randomScene(Dice& dice, ShadingModel model) {
  Scene scene;
  scene.volume = randomVolume(dice);
  const Grid& grid = scene.volume->grid();
  scene.transferFunction = randomFunction(dice, smallestSpacingMm(grid));
  scene.camera = randomCamera(dice, grid);
  scene.shading.model = model;
  scene.shading.specular = dice.between(0.1, 2.0);
  scene.shading.exponent = dice.ratio(0.5, 200.0);
  scene.shading.exponentRange = {dice.ratio(0.5, 10.0), dice.ratio(20.0, 500.0)};
  scene.shading.opacityRange = {dice.between(0.0, 0.8), dice.between(1.0, 4.0)};
  scene.isovalue = dice.between(-800.0, 1800.0);
  scene.quality.stepVoxels = dice.ratio(0.05, 3.0);
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.earlyTermination = 1.0;
  return scene;
}

struct Kind {
  const char* what;
  ShadingModel model;
  void (*apply)(Scene&, Dice&, double sizeMm);
};

const Kind kinds[] = {
    {"unlit", ShadingModel::none, [](Scene&, Dice&, double) {}},
    {"classic, cut, fog", ShadingModel::classic,
     [](Scene& scene, Dice& dice, double sizeMm) {
       scene.crop = {dice.vector(0.05, 0.4), dice.vector(0.5, 0.95)};
       scene.fog = {Fog::Mode::exp, dice.vector(0.0, 1.0), dice.ratio(0.1, 10.0) / sizeMm, 0.0, 0.0};
     }},
    {"enhanced, Phong, fixed light, pre-integrated", ShadingModel::enhanced,
     [](Scene& scene, Dice& dice, double) {
       scene.shading.reflection = Reflection::phong;
       scene.shading.lightDirection = dice.vector(-1.0, 1.0);
       scene.quality.preintegrated = Preintegration::always;
     }},
    {"robust, two-sided, gradient opacity, jitter", ShadingModel::robust,
     [](Scene& scene, Dice& dice, double sizeMm) {
       scene.shading.twoSided = true;
       scene.gradientOpacity = GradientOpacity{{{0.0, dice.between(0.0, 0.9)}, {1e4 / sizeMm, 1.0}}};
       scene.quality.jitter = true;
     }},
    {"unlit, pre-integrated", ShadingModel::none,
     [](Scene& scene, Dice&, double) { scene.quality.preintegrated = Preintegration::always; }},
    {"surface in a composite", ShadingModel::classic,
     [](Scene& scene, Dice&, double) { scene.projection = Projection::compositeIsosurface; }},
    {"largest", ShadingModel::none, [](Scene& scene, Dice&, double) { scene.projection = Projection::mip; }},
    {"X-ray", ShadingModel::none, [](Scene& scene, Dice&, double) { scene.projection = Projection::xray; }},
};

constexpr double tolerance = 2e-4; // HARD_CASES section 5
// The share of pixels where the last bit may decide: on a step of the transfer function, a tangent of a
// surface, the edge between two cut faces.
constexpr double decidedByRounding = 0.001;

using RandomScenes = test::GlTest;

TEST_F(RandomScenes, theReferenceAndGlslAgree) {
  constexpr unsigned seeds = 10;
  RayCaster caster;
  std::size_t compared = 0, apart = 0;
  for (const Kind& kind : kinds) {
    double largest = 0.0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      Dice dice(seed);
      Scene scene = randomScene(dice, kind.model);
      kind.apply(scene, dice, boxDiagonalMm(scene.volume->grid()));
      const ReferencePicture reference = renderReference(scene, randomSize);
      const Image image = caster.render(scene, randomSize);
      EXPECT_EQ(caster.render(scene, randomSize), image) << kind.what << ", seed " << seed;
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::dvec4 pixel(image.pixels[i]);
        const glm::dvec4 error = glm::abs(pixel - reference.pixels[i]);
        const double off = std::max({error.r, error.g, error.b, error.a});
        EXPECT_TRUE(std::isfinite(off) && pixel.a >= 0.0 && pixel.a <= 1.0) << kind.what << ", seed " << seed;
        compared += pixel.a > 0.0;
        apart += !(off <= tolerance);
        largest = std::max(largest, off);
      }
    }
    std::cout << kind.what << ": largest difference " << largest << "\n";
  }
  std::cout << apart << " of " << compared << " pixels are apart by more than " << tolerance << "\n";
  EXPECT_LE(static_cast<double>(apart), decidedByRounding * static_cast<double>(compared));
  EXPECT_GT(compared, 1000u);
}

} // namespace
} // namespace limn
