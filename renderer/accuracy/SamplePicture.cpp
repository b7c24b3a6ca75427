// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/SamplePicture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

double encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

} // namespace

glm::dvec3 srgbOfOklab(double lightness, double a, double b) {
  // The cone responses that it stands for, cubed.
  const auto cubed = [](double x) { return x * x * x; };
  const double l = cubed(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cubed(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cubed(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

SampleFigures figuresOf(const std::vector<int>& samples) {
  SampleFigures figures;
  double sum = 0.0;
  int rays = 0;
  for (const int count : samples) {
    if (count == 0)
      continue;
    figures.least = rays == 0 ? count : std::min(figures.least, count);
    figures.most = std::max(figures.most, count);
    sum += count;
    ++rays;
  }
  figures.mean = rays > 0 ? sum / rays : 0.0;
  return figures;
}

glm::dvec3 colorOfShare(double share) {
  const double x = std::clamp(share, 0.0, 1.0);
  // From blue (280 degrees) over red to yellow (100 degrees), with most colour in the middle.
  const double hue = (280.0 + 180.0 * x) * std::numbers::pi / 180.0;
  const double chroma = 0.04 + 0.16 * std::sin(std::numbers::pi * std::min(x, 0.85));
  return srgbOfOklab(0.15 + 0.8 * x, chroma * std::cos(hue), chroma * std::sin(hue));
}

Image pictureOfSamples(const std::vector<int>& samples, const glm::ivec2& size) {
  assert(samples.size() == static_cast<std::size_t>(size.x) * size.y);
  const SampleFigures figures = figuresOf(samples);
  Image image(size);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    glm::dvec3 color(0.0);
    if (samples[i] > 0)
      color = colorOfShare(static_cast<double>(samples[i]) / figures.most);
    image.pixels[i] = glm::vec4(glm::vec3(color), 1.0f);
  }
  return image;
}

} // namespace limn
