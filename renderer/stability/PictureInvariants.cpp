// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/PictureInvariants.h"

#include "scene/steps/RayFrame.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <sstream>

namespace limn {
namespace {

std::string place(const Image& image, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(image.size.x);
  std::ostringstream text;
  text.precision(9);
  const glm::vec4& p = image.pixels[pixel];
  text << "at (" << pixel % width << ", " << pixel / width << "): (" << p.r << ", " << p.g << ", " << p.b
       << ", " << p.a << ")";
  return text.str();
}

bool isFinite(const glm::vec4& p) {
  return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b) && std::isfinite(p.a);
}

bool isWithin(const glm::vec4& p, double rounding) {
  for (int channel = 0; channel < 3; ++channel)
    if (!(p[channel] >= 0.0f && p[channel] <= p.a + rounding))
      return false;
  return true;
}

// Rays are floats in GLSL: a miss counts where one grown by their rounding misses too.
bool surelyMisses(const FramedRay& ray, const IndexBox& box) {
  constexpr double floatRounding = 1e-6;
  IndexBox grown = box;
  const glm::dvec3 margin =
      floatRounding * (glm::abs(ray.anchor) + glm::max(glm::abs(box.lower), glm::abs(box.upper)) +
                       std::abs(ray.eye) * glm::abs(ray.direction));
  grown.lower -= margin;
  grown.upper += margin;
  return spanInBox(ray, grown).isEmpty();
}

std::array<std::uint32_t, 4> bitsOf(const glm::vec4& p) {
  return std::bit_cast<std::array<std::uint32_t, 4>>(p);
}

bool isZero(const glm::vec4& p) {
  return bitsOf(p) == bitsOf(glm::vec4(0.0f));
}

} // namespace

std::vector<std::string> brokenInvariants(const Scene& scene, const Image& image, double rounding) {
  const Grid& grid = scene.volume->grid();
  const RayFrame frame = rayFrame(scene.camera, grid, image.size);
  const IndexBox box = croppedBox(grid, scene.crop);
  std::vector<std::string> broken;
  const auto require = [&](const char* what, const std::function<bool(std::size_t)>& holds) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      if (!holds(i)) {
        broken.push_back(std::string(what).append(" ").append(place(image, i)));
        return;
      }
  };
  const auto at = [&](std::size_t i) { return image.pixels[i]; };
  require("a channel is not finite", [&](std::size_t i) { return isFinite(at(i)); });
  require("alpha is not within 0..1", [&](std::size_t i) { return at(i).a >= 0.0f && at(i).a <= 1.0f; });
  require("a colour is not within 0..alpha", [&](std::size_t i) { return isWithin(at(i), rounding); });
  require("a ray beside the volume is not empty", [&](std::size_t i) {
    const int x = static_cast<int>(i) % image.size.x;
    const int y = static_cast<int>(i) / image.size.x;
    return isZero(at(i)) || !surelyMisses(framedRay(frame, x, y, image.size), box);
  });
  return broken;
}

std::string firstDifference(const Image& image, const Image& again) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (bitsOf(image.pixels[i]) != bitsOf(again.pixels[i]))
      return place(image, i) + ", the other " + place(again, i);
  return {};
}

} // namespace limn
