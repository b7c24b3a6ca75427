// SPDX-License-Identifier: GPL-3.0-or-later
// The slice renderer claims order 2 in its step: the error falls to a quarter as the step halves. Measured
// against closed forms on single rays and, for whole pictures of a smooth field, against the reference at a
// step eight times finer than the finest, whose own error is a 64th of the smallest measured.
#include "accuracy/ImageError.h"
#include "reference/ReferenceIntegrator.h"
#include "slices/SliceRenderer.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/GlTest.h"

#include <cstdio>

namespace limn {
namespace {

using SliceOrder = test::GlTest;

// HARD_CASES section 6: an order counts as 2 from 1.8 to 2.2.
void expectSecondOrder(double coarse, double fine, const std::string& what) {
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << what << ": " << coarse << " to " << fine;
}

// Steps at which the error exceeds 20 times the floor of float, about 1e-6 (HARD_CASES section 6).
void expectSecondOrderOn(const test::AnalyticRay& ray, double lengthMm,
                         std::initializer_list<double> samples) {
  SliceRenderer renderer;
  double before = 0.0;
  for (const double n : samples) {
    Scene scene = ray.scene;
    scene.quality.stepVoxels = test::stepFor(scene, lengthMm, n);
    const glm::vec4 pixel = renderer.render(scene, {1, 1}).pixels[0];
    const double error = std::abs(pixel.r - ray.color->r);
    std::printf("%s %s, %g slices: error %.3g\n", ray.id.c_str(), ray.what.c_str(), n, error);
    EXPECT_GT(error, 2e-5);
    if (before > 0.0)
      expectSecondOrder(before, error, ray.id + " " + ray.what);
    before = error;
  }
}

TEST_F(SliceOrder, aRampOfExtinctionConvergesWithTheSquareOfTheStep) {
  int rays = 0;
  for (const nlohmann::json& one : test::analyticCases())
    if (one["id"] == "B1_ramp_linear_tau_k8.0" || one["id"] == "B1_ramp_linear_tau_k2.0")
      for (const test::AnalyticRay& ray : test::rampRays(one)) {
        expectSecondOrderOn(ray, 1.0, {4.0, 8.0, 16.0});
        ++rays;
      }
  EXPECT_EQ(rays, 4);
}

TEST_F(SliceOrder, aCubicRampConvergesWithTheSquareOfTheStep) {
  int rays = 0;
  for (const nlohmann::json& one : test::analyticCases())
    if (one["id"] == "B6_trilinear_xyz_diagonal")
      for (const test::AnalyticRay& ray : test::rampRays(one)) {
        expectSecondOrderOn(ray, std::sqrt(3.0), {8.0, 16.0, 32.0});
        ++rays;
      }
  EXPECT_EQ(rays, 1);
}

// Waves of eight voxels and more, on a grid of unequal spacings.
std::shared_ptr<const Volume> waves() {
  Grid grid;
  grid.dims = {22, 20, 24};
  grid.spacingMm = {1.0, 1.2, 0.9};
  grid.originMm = -0.5 * grid.spacingMm * (glm::dvec3(grid.dims) - 1.0);
  std::vector<float> values;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        values.push_back(static_cast<float>(0.5 + 0.2 * std::sin(0.75 * i) +
                                            0.2 * std::cos(0.6 * j + 0.2 * i) +
                                            0.1 * std::sin(0.7 * k + 1.0)));
  return std::make_shared<const Volume>(grid, std::move(values), Rescale{}, std::nullopt, VolumeInfo{});
}

Scene waveScene() {
  static const std::shared_ptr<const Volume> volume = waves();
  Scene scene;
  scene.volume = volume;
  scene.camera = orbited(defaultCamera(volume->grid()), 0.5, 0.35);
  scene.camera.heightMm = 30.0;
  // No kink of the function inside the range of the values.
  scene.transferFunction = {1.0, {{0.0, {1.0, 0.3, 0.2}, 0.0}, {1.0, {0.2, 0.7, 1.0}, 0.6}}};
  scene.quality = Quality{};
  scene.quality.earlyTermination = 1.0;
  return scene;
}

struct OrderRow {
  const char* what;
  void (*apply)(Scene&);
};

const OrderRow orderRows[] = {
    {"unlit, perspective", [](Scene& s) { s.shading.model = ShadingModel::none; }},
    {"unlit, orthographic",
     [](Scene& s) {
       s.shading.model = ShadingModel::none;
       s.camera.projection = Camera::Projection::orthographic;
     }},
    {"unlit, seen from inside",
     [](Scene& s) {
       s.shading.model = ShadingModel::none;
       s.camera.position = {1.0, -2.0, 0.5};
       s.camera.target = {6.0, 3.0, 3.5};
       s.camera.fovYDeg = 70.0;
     }},
    {"unlit, cropped",
     [](Scene& s) {
       s.shading.model = ShadingModel::none;
       s.crop = {{0.1, 0.25, 0.0}, {0.8, 1.0, 0.7}};
     }},
    {"unlit, fog",
     [](Scene& s) {
       s.shading.model = ShadingModel::none;
       s.fog = {Fog::Mode::exp2, glm::dvec3(0.4, 0.5, 0.6), 0.012, 0.0, 0.0};
     }},
    {"unlit, gradient opacity",
     [](Scene& s) {
       s.shading.model = ShadingModel::none;
       s.gradientOpacity = GradientOpacity{{{0.0, 0.1}, {0.3, 1.0}}};
     }},
    {"classic", [](Scene& s) { s.shading.model = ShadingModel::classic; }},
    {"enhanced",
     [](Scene& s) {
       s.shading.model = ShadingModel::enhanced;
       s.shading.opacityRange = {0.3, 1.5}; // times 0.6: below 1, where extinction is singular
     }},
};

TEST_F(SliceOrder, picturesOfASmoothFieldConvergeWithTheSquareOfTheStep) {
  constexpr glm::ivec2 size{48, 40};
  SliceRenderer renderer;
  std::printf("%-26s %8s %9s %9s %6s\n", "scene", "step", "mean", "p99.9", "order");
  for (const OrderRow& row : orderRows) {
    Scene scene = waveScene();
    row.apply(scene);
    scene.quality.stepVoxels = 1.0 / 64.0;
    const ReferencePicture reference = renderReference(scene, size);
    ImageError before;
    for (const double step : {0.5, 0.25, 0.125}) {
      scene.quality.stepVoxels = step;
      const ImageError error = imageError(renderer.render(scene, size), reference.pixels);
      std::printf("%-26s %8.4f %9.5f %9.5f", row.what, step, error.mean, error.p99_9);
      if (before.mean > 0.0) {
        std::printf(" %6.2f\n", std::log2(before.mean / error.mean));
        expectSecondOrder(before.mean, error.mean, row.what);
      } else
        std::printf("\n");
      before = error;
    }
  }
}

} // namespace
} // namespace limn
