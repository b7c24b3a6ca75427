// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {

double finiteOrInfinite(double figure) {
  return std::isnan(figure) ? std::numeric_limits<double>::infinity() : figure;
}

double largestDifference(const glm::dvec4& a, const glm::dvec4& b) {
  double largest = 0.0;
  for (int channel = 0; channel < 4; ++channel)
    largest = std::max(largest, finiteOrInfinite(std::abs(a[channel] - b[channel])));
  return largest;
}

double largestDifference(const DrawnPicture& a, const DrawnPicture& b) {
  if (a.size != b.size)
    return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(largest, largestDifference(a.pixels[i], b.pixels[i]));
  return largest;
}

double differenceBeside(const glm::ivec3& voxel, const DrawnPicture& a, const DrawnPicture& b) {
  double largest = 0.0;
  for (int y = 0; y < a.size.y; ++y)
    for (int x = 0; x < a.size.x; ++x)
      if (std::abs(x - voxel.x) > 2 || std::abs(a.size.y - 1 - y - voxel.z) > 2)
        largest = std::max(largest, largestDifference(a.at(x, y), b.at(x, y)));
  return largest;
}

double largestAlphaError(const DrawnPicture& picture, double expected) {
  double largest = 0.0;
  for (const glm::dvec4& pixel : picture.pixels)
    largest = std::max(largest, finiteOrInfinite(std::abs(pixel.a - expected)));
  return largest;
}

int unsoundPixels(const DrawnPicture& picture) {
  const auto isSound = [](const glm::dvec4& pixel) {
    for (int channel = 0; channel < 4; ++channel)
      if (!std::isfinite(pixel[channel]) || pixel[channel] < 0.0)
        return false;
    return pixel.a <= 1.0 && std::max({pixel.r, pixel.g, pixel.b}) <= pixel.a + 1e-6;
  };
  return static_cast<int>(std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                        [&](const glm::dvec4& pixel) { return !isSound(pixel); }));
}

int visiblePixels(const DrawnPicture& picture) {
  return static_cast<int>(std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                        [](const glm::dvec4& pixel) { return pixel.a > 0.0; }));
}

Scene wholeVolume(std::shared_ptr<const Volume> volume, ShadingModel model, double lowest, double highest,
                  const glm::dvec3& direction) {
  Scene scene = rayThrough(std::move(volume), direction);
  scene.camera.heightMm = boxDiagonalMm(scene.volume->grid());
  scene.transferFunction = {smallestSpacingMm(scene.volume->grid()) * 4.0,
                            {{lowest, {0.9, 0.5, 0.3}, 0.0}, {highest, {1.0, 1.0, 0.9}, 0.6}}};
  scene.shading.model = model;
  scene.quality.stepVoxels = 0.5;
  return scene;
}

std::shared_ptr<const Volume> smoothVolume(int edge, double scale) {
  const double turn = 6.28318530717958647692 / edge;
  return volumeOf(centredGrid(glm::ivec3(edge), glm::dvec3(1.0)), [=](int i, int j, int k) {
    return scale * (50.0 + 50.0 * std::sin(turn * i) * std::cos(turn * j) * std::sin(turn * (k + 0.3 * i)));
  });
}

Finding takenOtherwise(const Workbench& bench, const Decisions& decisions, const std::string& what,
                       double bound, const std::string& reason,
                       const std::function<double(const Draw& draw)>& figure) {
  return withOpenGl(bench, "gl", what, [&] {
    RayCaster caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, decisions);
    const Draw draw = [&](const Scene& scene, const glm::ivec2& size) {
      const Image image = caster.render(scene, size);
      return DrawnPicture{size, {image.pixels.begin(), image.pixels.end()}};
    };
    return atMost("gl", what, figure(draw), bound, reason);
  });
}

} // namespace limn
