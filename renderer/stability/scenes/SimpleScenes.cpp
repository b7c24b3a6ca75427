// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/scenes/SimpleScenes.h"

#include "scene/volume/Phantom.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

void setFog(Scene& s, Fog::Mode mode) {
  s.fog = {mode, glm::dvec3(0.4, 0.5, 0.6), 0.002, 400.0, 1200.0};
}

void setProjection(Scene& s, Projection projection) {
  s.projection = projection;
  s.isovalue = 250.0;
}

// The lower half is kept.
Region halfBody(const glm::ivec3& dims) {
  std::vector<std::uint8_t> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 1);
  std::fill(places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2), places.end(), std::uint8_t{0});
  return bodyRegion(dims, places);
}

} // namespace

Region cubesRegion(const glm::ivec3& dims, int edge, const std::vector<double>& weights) {
  const int count = static_cast<int>(weights.size());
  std::vector<Label> labels;
  labels.reserve(weights.size());
  for (int value = 0; value < count; ++value)
    labels.push_back({value, "Cubes " + std::to_string(value), glm::dvec3(1.0)});
  std::vector<std::uint8_t> places;
  places.reserve(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        places.push_back(static_cast<std::uint8_t>((x / edge + y / edge + z / edge) % count));
  return {Region::Kind::labels, "cubes", std::make_shared<const LabelMap>(dims, places, labels), weights};
}

Region withVariedLooks(const Region& region, const TransferFunction& function) {
  std::map<std::size_t, TransferFunction> looks;
  for (std::size_t place = 1; place < region.weights.size(); ++place) {
    const auto n = static_cast<double>(place);
    TransferFunction look = shifted(function, 17.0 * n * (place % 2 == 0 ? 1.0 : -1.0));
    look.unitDistanceMm = function.unitDistanceMm * (place % 2 == 0 ? 0.4 + 0.1 * n : 1.0 + 0.5 * n);
    for (ControlPoint& point : look.points)
      point.color = place % 2 == 0 ? glm::dvec3(point.color.g, point.color.b, point.color.r)
                                   : glm::dvec3(point.color.b, point.color.r, 1.0 - 0.1 * n);
    looks[place] = look;
  }
  return withLooks(region, looks);
}

std::shared_ptr<const Volume> volumeOf(const Grid& grid,
                                       const std::function<double(int i, int j, int k)>& value) {
  std::vector<double> voxels;
  voxels.reserve(static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z);
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        voxels.push_back(value(i, j, k));
  return std::make_shared<const Volume>(grid, std::move(voxels), Rescale{}, std::nullopt, VolumeInfo{});
}

Grid centredGrid(const glm::ivec3& dims, const glm::dvec3& spacingMm) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = spacingMm;
  grid.originMm = -0.5 * spacingMm * (glm::dvec3(dims) - 1.0);
  return grid;
}

std::shared_ptr<const Volume> columnOf(const std::vector<double>& values, double spacingMm) {
  Grid grid;
  grid.dims = {1, static_cast<int>(values.size()), 1};
  grid.spacingMm = glm::dvec3(spacingMm);
  grid.originMm.y = -0.5 * spacingMm * (static_cast<double>(values.size()) - 1.0);
  return std::make_shared<const Volume>(grid, values, Rescale{}, std::nullopt, VolumeInfo{});
}

std::shared_ptr<const Volume> boxOf(const glm::dvec3& sizeMm, double value) {
  Grid grid;
  grid.dims = glm::ivec3(1);
  grid.spacingMm = sizeMm;
  return std::make_shared<const Volume>(grid, std::vector<double>{value}, Rescale{}, std::nullopt,
                                        VolumeInfo{});
}

Scene rayThrough(std::shared_ptr<const Volume> volume, const glm::dvec3& direction) {
  Scene scene;
  scene.camera.projection = Camera::Projection::orthographic;
  scene.camera.target = boxCentreMm(volume->grid());
  scene.camera.position = scene.camera.target - boxDiagonalMm(volume->grid()) * direction;
  scene.camera.heightMm = smallestSpacingMm(volume->grid());
  scene.shading.model = ShadingModel::none;
  scene.quality.earlyTermination = 1.0;
  scene.quality.preintegrated = Preintegration::never;
  scene.volume = std::move(volume);
  return scene;
}

Scene pixelPerVoxel(std::shared_ptr<const Volume> volume) {
  Scene scene = rayThrough(std::move(volume));
  const Grid& grid = scene.volume->grid();
  scene.camera.heightMm = grid.dims.z * grid.spacingMm.z;
  scene.quality.stepVoxels = grid.spacingMm.y / smallestSpacingMm(grid);
  return scene;
}

Scene ballSurface(double b, double voxelMm, const glm::dvec3& shift) {
  Grid grid;
  grid.dims = {4, static_cast<int>(std::ceil(0.7 / voxelMm)) + 1, 4};
  grid.spacingMm = glm::dvec3(voxelMm);
  grid.originMm = glm::dvec3(b, -0.6, 0.0) - voxelMm * (glm::dvec3(1.0, 0.0, 1.0) + shift);
  Scene scene = rayThrough(volumeOf(grid, [&](int i, int j, int k) {
    return -glm::length(indexToWorld(grid, {i, j, k}));
  }));
  scene.camera.target = {b, 0.0, 0.0};
  scene.camera.position = {b, -1.0, 0.0};
  scene.projection = Projection::isosurface;
  scene.isovalue = -0.5;
  scene.quality.stepVoxels = 0.5;
  return scene;
}

Fog distanceFog(double startMm, double endMm) {
  return {Fog::Mode::linear, glm::dvec3(1.0), 0.0, startMm, endMm};
}

double stepFor(const Scene& scene, double lengthMm, double samples) {
  return lengthMm / samples / smallestSpacingMm(scene.volume->grid());
}

TransferFunction constantFunction(double opacity, const glm::dvec3& color, double unitDistanceMm) {
  return {unitDistanceMm, {{0.0, color, opacity}}};
}

ControlPoint extinctionPoint(double scalar, double extinction, const glm::dvec3& color) {
  return {scalar, color, -std::expm1(-extinction * smallUnitMm)};
}

TransferFunction skinMuscleBone() {
  return {1.0,
          {{-500, {0.90, 0.70, 0.55}, 0.0},
           {-250, {0.90, 0.70, 0.55}, 0.02},
           {-30, {0.85, 0.55, 0.40}, 0.03},
           {40, {0.75, 0.25, 0.20}, 0.12},
           {120, {0.75, 0.25, 0.20}, 0.10},
           {250, {0.95, 0.90, 0.80}, 0.30},
           {1200, {1.00, 1.00, 0.95}, 0.80}}};
}

Scene headScene(std::shared_ptr<const Volume> volume, ShadingModel model) {
  Scene scene;
  scene.camera = defaultCamera(volume->grid());
  scene.volume = std::move(volume);
  scene.transferFunction = skinMuscleBone();
  scene.shading.model = model;
  scene.quality.stepVoxels = 0.25;
  scene.quality.earlyTermination = 1.0;
  return scene;
}

const std::vector<Variation>& everyParameter() {
  static const std::vector<Variation> all{
      {"volume", [](Scene& s) { s.volume = phantomVolume({.spacingMm = 7.0}); }},
      {"camera", [](Scene& s) { s.camera = orbited(s.camera, 0.5, 0.1); }},
      {"orthographic", [](Scene& s) { s.camera.projection = Camera::Projection::orthographic; }},
      {"unit distance", [](Scene& s) { s.transferFunction.unitDistanceMm = 2.0; }},
      {"opacity of a point", [](Scene& s) { s.transferFunction.points[3].opacity = 0.3; }},
      {"value of a point", [](Scene& s) { s.transferFunction.points[3].value += 15.0; }},
      {"colour of a point", [](Scene& s) { s.transferFunction.points[3].color = glm::dvec3(0.1, 0.9, 0.1); }},
      {"no model", [](Scene& s) { s.shading.model = ShadingModel::none; }},
      {"classic", [](Scene& s) { s.shading.model = ShadingModel::classic; }},
      {"enhanced", [](Scene& s) { s.shading.model = ShadingModel::enhanced; }},
      {"classic exponent",
       [](Scene& s) {
         s.shading.model = ShadingModel::classic;
         s.shading.exponent = 8.0;
       }},
      {"ambient", [](Scene& s) { s.shading.ambient = 0.5; }},
      {"diffuse", [](Scene& s) { s.shading.diffuse = 0.5; }},
      {"specular", [](Scene& s) { s.shading.specular = 0.3; }},
      {"ambient intensity", [](Scene& s) { s.shading.ambientIntensity = 0.4; }},
      {"light intensity", [](Scene& s) { s.shading.lightIntensity = 0.5; }},
      {"SPmin", [](Scene& s) { s.shading.exponentRange.atFlat = 4.0; }},
      {"SPmax", [](Scene& s) { s.shading.exponentRange.atBoundary = 100.0; }},
      {"Omin", [](Scene& s) { s.shading.opacityRange.atFlat = 0.5; }},
      {"Omax", [](Scene& s) { s.shading.opacityRange.atBoundary = 2.0; }},
      {"reference: largest", [](Scene& s) { s.shading.gradientReference = LargestReference{}; }},
      {"reference: percentile", [](Scene& s) { s.shading.gradientReference = PercentileReference{90.0}; }},
      {"reference: fixed", [](Scene& s) { s.shading.gradientReference = FixedReference{150.0}; }},
      {"gamma curve",
       [](Scene& s) {
         s.shading.gradientCurve = {GradientCurve::Type::gamma, 0.5};
       }},
      {"log curve",
       [](Scene& s) {
         s.shading.gradientCurve = {GradientCurve::Type::log, 20.0};
       }},
      {"no energy factor", [](Scene& s) { s.shading.energyFactor = false; }},
      {"significance",
       [](Scene& s) {
         s.shading.significance = Significance{0.2, 0.6};
       }},
      {"no significance", [](Scene& s) { s.shading.significance.reset(); }},
      {"knee", [](Scene& s) { s.shading.knee = 0.3; }},
      {"no knee", [](Scene& s) { s.shading.knee.reset(); }},
      {"highlights of the light", [](Scene& s) { s.shading.specularColor = SpecularColor::light; }},
      {"Phong", [](Scene& s) { s.shading.reflection = Reflection::phong; }},
      {"fixed light", [](Scene& s) { s.shading.lightDirection = glm::dvec3(1.0, 1.0, -1.0); }},
      {"two-sided fixed light",
       [](Scene& s) {
         s.shading.lightDirection = glm::dvec3(1.0, 1.0, -1.0);
         s.shading.twoSided = true;
       }},
      {"smooth normals", [](Scene& s) { s.shading.gradientSmoothing = 9.0; }},
      {"smoother normals", [](Scene& s) { s.shading.gradientSmoothing = 16.0; }},
      {"gradient opacity",
       [](Scene& s) {
         s.gradientOpacity = GradientOpacity{{{0.0, 0.1}, {200.0, 1.0}}};
       }},
      {"linear fog", [](Scene& s) { setFog(s, Fog::Mode::linear); }},
      {"exponential fog", [](Scene& s) { setFog(s, Fog::Mode::exp); }},
      {"squared exponential fog", [](Scene& s) { setFog(s, Fog::Mode::exp2); }},
      {"crop, left", [](Scene& s) { s.crop.lower.x = 0.4; }},
      {"crop, above", [](Scene& s) { s.crop.upper.z = 0.6; }},
      {"kept region",
       [](Scene& s) {
         s.keep = cubesRegion(s.volume->grid().dims, 7, {1.0, 0.0, 0.4});
       }},
      {"looks of labels",
       [](Scene& s) {
         s.keep = withVariedLooks(cubesRegion(s.volume->grid().dims, 7, {1.0, 1.0, 0.6}), s.transferFunction);
       }},
      {"body", [](Scene& s) { s.keep = halfBody(s.volume->grid().dims); }},
      {"step", [](Scene& s) { s.quality.stepVoxels = 0.7; }},
      {"early termination", [](Scene& s) { s.quality.earlyTermination = 0.7; }},
      {"pre-integration", [](Scene& s) { s.quality.preintegrated = Preintegration::always; }},
      {"jitter", [](Scene& s) { s.quality.jitter = true; }},
      {"maximum", [](Scene& s) { setProjection(s, Projection::mip); }},
      {"average", [](Scene& s) { setProjection(s, Projection::average); }},
      {"minimum", [](Scene& s) { setProjection(s, Projection::minip); }},
      {"X-ray", [](Scene& s) { setProjection(s, Projection::xray); }},
      {"isosurface", [](Scene& s) { setProjection(s, Projection::isosurface); }},
      {"another isosurface",
       [](Scene& s) {
         s.projection = Projection::isosurface;
         s.isovalue = -200.0;
       }},
      {"composite up to a surface", [](Scene& s) { setProjection(s, Projection::compositeIsosurface); }}};
  return all;
}

} // namespace limn
