// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/ComparedSides.h"

#include "app/core/drawing/PictureMaker.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

Image parted(const Image& left, const Image& right, double wipe) {
  Image result = left;
  const int column = std::clamp(static_cast<int>(std::lround(wipe * left.size.x)), 0, left.size.x);
  for (int y = 0; y < left.size.y; ++y)
    for (int x = column; x < left.size.x; ++x)
      result.at(x, y) = right.at(x, y);
  return result;
}

// The part of a colour that differs most (scene/view/CompareLayout.h).
float mostApart(const glm::vec3& left, const glm::vec3& right) {
  float most = 0.0f;
  for (int channel = 0; channel < 3; ++channel)
    if (std::abs(right[channel] - left[channel]) > std::abs(most))
      most = right[channel] - left[channel];
  return most;
}

Image differenceOf(const Image& left, const Image& right, const glm::vec3& background) {
  const auto over = [&](const glm::vec4& pixel) {
    return glm::clamp(glm::vec3(pixel) + (1.0f - pixel.a) * background, 0.0f, 1.0f);
  };
  Image result(left.size);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    const float apart = mostApart(over(left.pixels[i]), over(right.pixels[i]));
    const double strength = std::min(1.0, differenceGain * std::abs(static_cast<double>(apart)));
    result.pixels[i] =
        glm::vec4(glm::vec3(strength * (apart < 0.0f ? leftBrighterColor : rightBrighterColor)), 1.0f);
  }
  return result;
}

Scene withModel(Scene scene, ShadingModel model) {
  scene.shading.model = model;
  return scene;
}

} // namespace

std::vector<Scene> scenesShown(const Scene& scene, const ShownSides& sides) {
  if (pictureCount(sides.layout) == 1)
    return {scene};
  return {sides.look ? withPreset(scene, *sides.look) : withModel(scene, sides.left),
          withModel(scene, sides.right)};
}

Image comparedPicture(const Image& left, const Image& right, CompareLayout layout, double wipe,
                      const glm::dvec3& background) {
  if (layout == CompareLayout::wipe)
    return parted(left, right, wipe);
  return layout == CompareLayout::difference ? differenceOf(left, right, glm::vec3(background))
                                             : sideBySide(left, right);
}

} // namespace limn
