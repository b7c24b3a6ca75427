// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/StableMath.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <cmath>
#include <numbers>

namespace limn {
namespace {

// Opacity 1 over the unit distance is limited to 1 - 2⁻²⁴; over f unit distances that is 1 - 2^(-24 f).
std::vector<Finding> opaque(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [name, length] : {std::pair{"1e-6", 1e-6}, {"0.01", 0.01}, {"1", 1.0}, {"100", 100.0}})
    findings += inEachEngine(
        bench, "a path of " + std::string(name) + " unit distances", {1e-12, 2e-6, 2e-6},
        "alpha against 1 - 2^(-24 f); one rounding of float per step", [length = length](const Draw& draw) {
          Scene scene = rayThrough(boxOf(glm::dvec3(length)));
          scene.transferFunction = constantFunction(1.0, glm::dvec3(1.0));
          return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-24.0 * length * std::numbers::ln2));
        });
  findings.push_back(atMost("cpp", "opacity 1 over no distance",
                            std::abs(oneMinusExpNeg(0.0 * minusLog1mOpacity(1.0))), 0.0,
                            "exactly nothing, not 0 times infinity"));
  return findings;
}

// 1e-4 per unit distance over 5000 of them in steps of a tenth: 1 - (1 - 1e-4)^5000.
std::vector<Finding> faint(Workbench& bench) {
  const auto figure = [](const Draw& draw) {
    Scene scene = rayThrough(boxOf(glm::dvec3(5000.0)));
    scene.transferFunction = constantFunction(1e-4, glm::dvec3(1.0));
    scene.quality.stepVoxels = 0.1 / 5000.0;
    return largestAlphaError(draw(scene, {1, 1}), -std::expm1(5000.0 * std::log1p(-1e-4)));
  };
  std::vector<Finding> findings =
      inEngines(bench, {Engine::reference, Engine::rayCaster, Engine::cpu}, "50000 steps of 1e-5 each",
                {1e-12, 1e-4, 0.0},
                "alpha against 1 - (1 - 1e-4)^5000; 50000 roundings of half an ulp of what is left, all one "
                "way at worst: 50000 · 2^-25 · 0.07",
                figure);
  findings +=
      inEngines(bench, {Engine::slices}, "50000 slices of 1e-5 each", {0.0, 0.0, 50000.0 / 4194304.0},
                "alpha against 1 - (1 - 1e-4)^5000; blending rounds each layer by up to 2^-22", figure);
  return findings;
}

// Layers of 1 mm, one step each, with a point of the function for each value.
Scene layers(const std::vector<double>& values, const std::vector<ControlPoint>& points) {
  Scene scene = rayThrough(columnOf(values, 1.0));
  scene.transferFunction = {1.0, points};
  scene.quality.stepVoxels = 1.0;
  return scene;
}

// How far 8-bit levels are from what they should be; alpha counts nothing on a screen.
double levelError(const glm::u8vec4& shown, const glm::dvec3& expected) {
  double largest = 0.0;
  for (int channel = 0; channel < 3; ++channel)
    largest = std::max(largest, std::abs(shown[channel] - 255.0 * expected[channel]));
  return largest;
}

// A box of one unit distance over a background, in levels of the screen.
double shownError(const Workbench& bench, const Draw& draw, const glm::dvec3& color, double opacity,
                  const glm::dvec3& background, const glm::dvec3& expected) {
  bench.requireOpenGl();
  Scene scene = rayThrough(boxOf(white));
  scene.transferFunction = constantFunction(opacity, color);
  return levelError(presented(draw(scene, {1, 1}), background).at(0), expected);
}

std::vector<Finding> premultiplied(Workbench& bench) {
  // Opacities 0.2, 0.5 and 0.8 weigh red, green and blue by 0.2, 0.8 · 0.5 and 0.8 · 0.5 · 0.8.
  std::vector<Finding> findings = inEachEngine(
      bench, "red before green before blue", {1e-12, 1e-6, 1e-6},
      "each channel against its layer's opacity times what those before let through; multiplied twice, red "
      "would be 0.04 in place of 0.2",
      [](const Draw& draw) {
        const Scene scene =
            layers({0.0, 1.0, 2.0}, {{0.0, {1, 0, 0}, 0.2}, {1.0, {0, 1, 0}, 0.5}, {2.0, {0, 0, 1}, 0.8}});
        return largestDifference(draw(scene, {1, 1}).at(0, 0), {0.2, 0.4, 0.32, 0.92});
      });
  const std::string reason =
      "levels of 255 off on the screen; the nearest is half a level away, and drivers may round either way";
  struct Row {
    const char* what;
    glm::dvec3 color, background;
    double expected;
  };
  for (const Row& row : {Row{"half of white over black", white, black, 0.5},
                         Row{"half of black over white", black, white, 0.5},
                         Row{"half of white over white", white, white, 1.0}})
    findings += inEachEngine(bench, row.what, {1.0, 1.0, 1.0}, reason, [&bench, &row](const Draw& draw) {
      return shownError(bench, draw, row.color, 0.5, row.background, glm::dvec3(row.expected));
    });
  return findings;
}

// The grey of pixel `i` of `greys`, 0..255: the picture begins above, the slice below.
double greyAt(std::size_t i) {
  const std::size_t row = i / 16;
  return static_cast<double>(i % 16 + 16 * (15 - row));
}

// A slice with a grey for each of 256 values, opaque.
Scene greys() {
  const auto volume = volumeOf(centredGrid({16, 1, 16}, white),
                               [](int i, int, int k) { return static_cast<double>(i + 16 * k); });
  Scene scene = pixelPerVoxel(volume);
  scene.transferFunction = {0.1, {{0.0, black, 1.0}, {255.0, white, 1.0}}};
  return scene;
}

std::vector<Finding> encoding(Workbench& bench) {
  std::vector<Finding> findings =
      inEachEngine(bench, "256 opaque greys", {1.0, 1.0, 1.0},
                   "levels of 255 off on the screen: an encoding of sRGB would lift the middle by 61",
                   [&bench](const Draw& draw) {
                     bench.requireOpenGl();
                     const std::vector<glm::u8vec4> shown = presented(draw(greys(), {16, 16}), black);
                     double largest = 0.0;
                     for (std::size_t i = 0; i < shown.size(); ++i)
                       largest = std::max(largest, levelError(shown[i], glm::dvec3(greyAt(i) / 255.0)));
                     return largest;
                   });
  findings +=
      inEachEngine(bench, "half of white over black in floats", {1e-12, 1e-6, 1e-6},
                   "colour against 1/2: composited as display values; in linear light it would be 0.735",
                   [](const Draw& draw) {
                     Scene scene = rayThrough(boxOf(white));
                     scene.transferFunction = constantFunction(0.5, white);
                     return largestDifference(draw(scene, {1, 1}).at(0, 0), glm::dvec4(0.5));
                   });
  return findings;
}

constexpr double fogDensity = 0.35, fogGrey = 0.5, objectGrey = 0.9;

Fog fogOf(Fog::Mode mode, double start = 0.0, double end = 0.0) {
  return {mode, glm::dvec3(fogGrey), fogDensity, start, end};
}

// An opaque sheet of so little thickness that it has one distance, `z` mm from the eye.
double sheetError(const Draw& draw, const Fog& fog, double z, double factor) {
  constexpr double thickness = 1e-9;
  Scene scene = rayThrough(boxOf(glm::dvec3(thickness)));
  scene.camera.position.y = -z;
  scene.transferFunction = constantFunction(1.0, glm::dvec3(objectGrey), 0.01 * thickness);
  scene.fog = fog;
  const double expected = factor * objectGrey + (1.0 - factor) * fogGrey;
  return largestDifference(draw(scene, {1, 1}).at(0, 0), {glm::dvec3(expected), 1.0});
}

std::vector<Finding> fogFactors(Workbench& bench) {
  struct Row {
    const char* what;
    Fog fog;
    double (*factor)(double z);
  };
  // Linear fog from 2 back to 1, from 2 to 2: all of it from where it starts.
  const Row rows[] = {
      {"linear from 1 to 5 mm", fogOf(Fog::Mode::linear, 1.0, 5.0),
       [](double z) { return std::clamp((5.0 - z) / 4.0, 0.0, 1.0); }},
      {"linear that ends where it starts", fogOf(Fog::Mode::linear, 2.25, 2.25),
       [](double z) { return z < 2.25 ? 1.0 : 0.0; }},
      {"linear that ends before it starts", fogOf(Fog::Mode::linear, 2.25, 1.0),
       [](double z) { return z < 2.25 ? 1.0 : 0.0; }},
      {"exponential", fogOf(Fog::Mode::exp), [](double z) { return std::exp(-fogDensity * z); }},
      {"squared exponential", fogOf(Fog::Mode::exp2),
       [](double z) { return std::exp(-fogDensity * fogDensity * z * z); }}};
  std::vector<Finding> findings;
  for (const Row& row : rows)
    findings += inEachEngine(
        bench, row.what, {1e-8, 2e-6, 2e-6},
        "colour of an opaque sheet at 0 to 1000 mm against F · object + (1 - F) · fog; it is 1e-9 mm thick",
        [&row](const Draw& draw) {
          double largest = 0.0;
          for (const double z : {0.0, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 1000.0})
            largest = std::max(largest, sheetError(draw, row.fog, z, row.factor(z)));
          return largest;
        });
  return findings;
}

// Layers of 0.3 and 0.6 whose middles are 1 and 4 mm from the eye, with nothing between them.
double foggedLayersError(const Draw& draw) {
  const glm::dvec3 near(0.9), far(0.2);
  Scene scene =
      layers({1.0, 0.0, 0.0, 2.0}, {{0.5, near, 0.0}, {0.5, near, 0.3}, {1.5, near, 0.3}, {1.5, far, 0.6}});
  scene.camera.position.y = -2.5;
  scene.fog = fogOf(Fog::Mode::exp);
  const double f1 = std::exp(-fogDensity), f4 = std::exp(-4.0 * fogDensity);
  const double color =
      0.3 * (f1 * 0.9 + (1.0 - f1) * fogGrey) + 0.7 * 0.6 * (f4 * 0.2 + (1.0 - f4) * fogGrey);
  return largestDifference(draw(scene, {1, 1}).at(0, 0), {glm::dvec3(color), 0.72});
}

// A medium of the fog's colour and density over 3 mm before an opaque object: what exponential fog stands
// for.
double mediumError(const Draw& draw) {
  const double unit = 0.1;
  Scene scene = rayThrough(columnOf({0.0, 0.0, 0.0, 1.0}, 1.0));
  scene.transferFunction = {
      unit,
      {{0.5, glm::dvec3(fogGrey), -std::expm1(-fogDensity * unit)}, {0.5, glm::dvec3(objectGrey), 1.0}}};
  scene.quality.stepVoxels = 0.1;
  const double f = std::exp(-3.0 * fogDensity);
  return largestDifference(draw(scene, {1, 1}).at(0, 0),
                           {glm::dvec3(f * objectGrey + (1.0 - f) * fogGrey), 1.0});
}

double largestAlphaChange(const Draw& draw, const Fog& fog) {
  Scene scene = wholeVolume(smoothVolume(12), ShadingModel::classic, 0.0, 100.0);
  const DrawnPicture clear = draw(scene, {24, 24});
  scene.fog = fog;
  const DrawnPicture fogged = draw(scene, {24, 24});
  double largest = 0.0;
  for (std::size_t i = 0; i < clear.pixels.size(); ++i)
    largest = std::max(largest, finiteOrInfinite(std::abs(clear.pixels[i].a - fogged.pixels[i].a)));
  return largest;
}

std::vector<Finding> fog(Workbench& bench) {
  std::vector<Finding> findings = fogFactors(bench);
  findings +=
      inEachEngine(bench, "on two translucent layers", {1e-12, 2e-6, 2e-6},
                   "colour and alpha of the layers, each fogged by its own distance", foggedLayersError);
  findings +=
      inEachEngine(bench, "a medium in its place", {1e-9, 2e-6, 2e-6},
                   "colour of an object behind 3 mm of a medium against exponential fog", mediumError);
  findings += inEachEngine(bench, "opacity", {}, "largest change of alpha by fog: none",
                           [](const Draw& draw) { return largestAlphaChange(draw, fogOf(Fog::Mode::exp2)); });
  findings +=
      inEachEngine(bench, "of no density", {}, "largest difference from no fog: none", [](const Draw& draw) {
        Scene scene = wholeVolume(smoothVolume(12), ShadingModel::classic, 0.0, 100.0);
        const DrawnPicture clear = draw(scene, {24, 24});
        scene.fog = {Fog::Mode::exp, white, 0.0, 0.0, 0.0};
        return largestDifference(draw(scene, {24, 24}), clear);
      });
  return findings;
}

} // namespace

std::vector<HardCase> blendingCases() {
  return {{"H4", "Full opacity is corrected for any step without infinities", opaque},
          {"H5", "Tiny opacities are neither skipped nor lost", faint},
          {"H38", "Colours are multiplied by opacity once, up to the screen", premultiplied},
          {"H39", "Display values are neither encoded nor decoded on their way to the screen", encoding},
          {"H42", "Fog weighs the object by its own distance and touches no opacity", fog}};
}

} // namespace limn
