// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/GlslEvaluator.h"
#include "scene/basics/Error.h"
#include "scene/basics/StableMath.h"
#include "scene/function/MeanMaterial.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace limn {
namespace {

// A slice of 1 mm with a voxel for each value, row by row from the bottom, its functions over 1 mm: the alpha
// of a pixel is the opacity of its value.
template <class T>
Scene swatches(const std::vector<T>& values, int columns) {
  const int rows = static_cast<int>(values.size()) / columns;
  const Grid grid = centredGrid({columns, 1, rows}, glm::dvec3(1.0));
  return pixelPerVoxel(std::make_shared<const Volume>(grid, values, Rescale{}, std::nullopt, VolumeInfo{}));
}

glm::ivec2 sizeOf(const Scene& scene) {
  return {scene.volume->grid().dims.x, scene.volume->grid().dims.z};
}

// The largest of what `error` says of each value and its pixel.
double largestOver(const Draw& draw, const Scene& scene,
                   const std::function<double(double value, const glm::dvec4& pixel)>& error) {
  const glm::ivec2 size = sizeOf(scene);
  const DrawnPicture picture = draw(scene, size);
  double largest = 0.0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      largest = std::max(
          largest, finiteOrInfinite(error(scene.volume->value({x, 0, size.y - 1 - y}), picture.at(x, y))));
  return largest;
}

// 1024 values from 0 to 1.
std::vector<double> unitRamp() {
  std::vector<double> values(1024);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<double>(i) / 1023.0;
  return values;
}

// Opacity 1 is limited to 1 - 2⁻²⁴.
constexpr double fullOpacity = 0x1p-24 + 1e-12;

double rampError(const Draw& draw, Scene scene, double lowest, double highest) {
  scene.transferFunction = {1.0, {{lowest, white, 0.0}, {highest, white, 1.0}}};
  return largestOver(draw, scene, [=](double value, const glm::dvec4& pixel) {
    return std::abs(pixel.a - std::clamp((value - lowest) / (highest - lowest), 0.0, 1.0));
  });
}

std::vector<Finding> narrowRanges(Workbench& bench) {
  std::vector<Finding> findings = inEachEngine(bench, "the 4096 values of 12 bits in words of 16",
                                               {fullOpacity, 1.0 / 8192.0, 1.0 / 8192.0},
                                               "alpha against the value's share of the ramp: half a step of "
                                               "12 bits; full opacity is short of 1 by 2^-24",
                                               [](const Draw& draw) {
                                                 std::vector<std::uint16_t> values(4096);
                                                 std::iota(values.begin(), values.end(), std::uint16_t{0});
                                                 return rampError(draw, swatches(values, 64), 0.0, 4095.0);
                                               });
  findings += inEachEngine(
      bench, "a function over a hundredth of a range of floats", {fullOpacity, 1.0 / 2048.0, 1.0 / 2048.0},
      "alpha against the value's share of the ramp: half of one of its 1024 values", [](const Draw& draw) {
        std::vector<float> values(1024);
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i] = static_cast<float>(i) * (200.0f / 1023.0f);
        values.front() = -1e4f;
        values.back() = 1e4f;
        return rampError(draw, swatches(values, 32), 0.0, 200.0);
      });
  return findings;
}

// How far an alpha lies outside what the function gives within `reach` of a value: a step or a steep flank
// may lie a rounding of float beside it.
double outsideFunction(const TransferFunction& function, double value, double reach, double alpha) {
  const double low = classify(function, value - reach).opacity;
  const double high = classify(function, value + reach).opacity;
  double least = std::min(low, high), most = std::max(low, high);
  for (const ControlPoint& point : function.points)
    if (std::abs(point.value - value) <= reach) {
      least = std::min(least, point.opacity);
      most = std::max(most, point.opacity);
    }
  return std::max({0.0, least - alpha, alpha - most});
}

// 1024 values from 0 to 1. Texture coordinates are off by 2⁻²⁴ of 34 texels, rows differ by 1/32.
double functionError(const Draw& draw, const TransferFunction& function) {
  constexpr double reach = 0x1p-24 * (34.0 / 32.0 + 2.0);
  static const Scene values = swatches(unitRamp(), 32);
  Scene scene = values;
  scene.transferFunction = function;
  return largestOver(draw, scene, [&](double value, const glm::dvec4& pixel) {
    return outsideFunction(function, value, reach, pixel.a);
  });
}

// Points on eighths of the range and beyond it, so that several often share a value.
TransferFunction randomFunction(std::mt19937& generator) {
  TransferFunction function;
  const std::size_t count = 1 + generator() % 8;
  while (function.points.size() < count)
    function.points.push_back(
        {(static_cast<double>(generator() % 11) - 1.0) / 8.0, white, (generator() % 1000) / 1000.0});
  return normalised(function);
}

std::vector<Finding> fewPoints(Workbench& bench) {
  struct Row {
    const char* what;
    std::vector<ControlPoint> points;
    double alpha;
  };
  // The voxel's value is 1.
  const Row rows[] = {
      {"no points", {}, 0.0},
      {"no opacity", {{0.0, white, 0.0}, {2.0, white, 0.0}}, 0.0},
      {"one point below the value", {{0.3, white, 0.6}}, 0.6},
      {"one point above the value", {{7.0, white, 0.6}}, 0.6},
      {"three points at the value, of which the last holds",
       {{1.0, white, 0.1}, {1.0, white, 0.2}, {1.0, white, 0.6}},
       0.6},
      {"two points above the value, of which the first holds", {{2.0, white, 0.6}, {2.0, white, 0.2}}, 0.6}};
  std::vector<Finding> findings;
  for (const Row& row : rows)
    findings +=
        inEachEngine(bench, row.what, row.alpha == 0.0 ? Bounds{} : Bounds{1e-12, 1e-6, 1e-6},
                     "alpha of a voxel: exactly nothing, or one point's opacity", [&](const Draw& draw) {
                       Scene scene = rayThrough(boxOf(white));
                       scene.transferFunction = {1.0, row.points};
                       return largestAlphaError(draw(scene, {1, 1}), row.alpha);
                     });
  return findings;
}

std::vector<Finding> coincidentPoints(Workbench& bench) {
  // Layers of 0, 1/2 and 1 behind each other, and a step from 0 to 1/2 at 1/2: 1 - 1/2 · 1/2.
  std::vector<Finding> findings = inEachEngine(
      bench, "a value on a step", {1e-12, 1e-6, 1e-6},
      "alpha of layers below, on and above a step: on it the upper side holds", [](const Draw& draw) {
        Scene scene = rayThrough(columnOf({0.0, 0.5, 1.0}, 1.0));
        scene.transferFunction = {1.0, {{0.5, white, 0.0}, {0.5, white, 0.5}}};
        scene.quality.stepVoxels = 1.0;
        return largestAlphaError(draw(scene, {1, 1}), 0.75);
      });
  findings +=
      inEachEngine(bench, "40 random functions of 1 to 8 points, some at the same value", {1e-12, 1e-6, 1e-6},
                   "how far alpha lies outside what the function gives within three roundings of the value",
                   [](const Draw& draw) {
                     std::mt19937 generator(24);
                     double largest = 0.0;
                     for (int i = 0; i < 40; ++i)
                       largest = std::max(largest, functionError(draw, randomFunction(generator)));
                     return largest;
                   });
  for (const auto& [what, first, second] :
       {std::tuple{"two points nearer than floats tell apart", 0.5, 0.5 + 0x1p-40},
        {"two points 1e-42 apart at the end of the range", 0.0, 1e-42}})
    findings +=
        inEachEngine(bench, what, {1e-12, 1e-6, 1e-6},
                     "how far alpha lies outside what the function gives within three roundings of the value",
                     [first = first, second = second](const Draw& draw) {
                       return functionError(draw, {1.0, {{first, white, 0.2}, {second, white, 0.7}}});
                     });
  return findings;
}

std::vector<Finding> unsortedPoints() {
  const TransferFunction sorted = normalised({1.0,
                                              {{3.0, white, 0.375},
                                               {1.0, white, 0.125},
                                               {3.0, white, 0.5},
                                               {2.0, white, 0.25},
                                               {3.0, white, 0.625}}});
  int misplaced = sorted.points.size() == 5 ? 0 : 1;
  for (std::size_t i = 0; i < sorted.points.size(); ++i)
    misplaced += sorted.points[i].opacity != 0.125 * static_cast<double>(i + 1);
  int accepted = 0;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const ControlPoint& point : {ControlPoint{nan, white, 0.5}, ControlPoint{1.0, white, nan},
                                    ControlPoint{infinity, white, 0.5}, ControlPoint{1.0, {nan, 0, 0}, 0.5}})
    try {
      normalised({1.0, {point}});
      ++accepted;
    } catch (const Error&) {
    }
  return {atMost("cpp", "points out of order", misplaced, 0.0,
                 "points that are not in the order of their values, equal ones in the order given"),
          atMost("cpp", "points that are no numbers", accepted, 0.0,
                 "points with NaN or infinity that are not refused")};
}

std::vector<Finding> degenerateFunctions(Workbench& bench) {
  std::vector<Finding> findings = fewPoints(bench);
  findings += coincidentPoints(bench);
  findings += unsortedPoints();
  return findings;
}

std::vector<Finding> lookUps(Workbench& bench) {
  const auto figure = [](const Draw& draw) { return rampError(draw, swatches(unitRamp(), 32), 0.0, 1.0); };
  const std::string reason =
      "alpha against the value itself; a table read half an entry aside is off by 1e-3";
  std::vector<Finding> findings =
      inEachEngine(bench, "the identity", {fullOpacity, 1e-6, 1e-6}, reason, figure);
  Decisions table;
  table.table = TableFormat::floats256;
  findings.push_back(takenOtherwise(bench, table, "the identity in a table of 256 entries, measured only",
                                    1e-6, reason, figure));
  return findings;
}

// 1 - (1 - a)^n: a per unit distance over n of them, in as many steps as are useful.
double faintError(const Draw& draw, double opacity, double units, double steps) {
  Scene scene = rayThrough(boxOf(glm::dvec3(units)));
  scene.transferFunction = constantFunction(opacity, white);
  scene.quality.stepVoxels = 1.0 / steps;
  return largestAlphaError(draw(scene, {1, 1}), -std::expm1(units * std::log1p(-opacity)));
}

std::vector<Finding> preciseFunctions(Workbench& bench) {
  // Blending rounds each layer by up to 2⁻²².
  const Bounds manySteps{1e-12, 1e-6, 1e-6 + 1000.0 * 0x1p-22};
  std::vector<Finding> findings =
      inEachEngine(bench, "opacity 0.001 over 1000 unit distances", manySteps,
                   "alpha against 1 - 0.999^1000 = 0.632; in 8 bits this opacity is 0",
                   [](const Draw& draw) { return faintError(draw, 1e-3, 1e3, 1000.0); });
  findings += inEachEngine(bench, "opacity 1e-8 over 100 million unit distances", manySteps,
                           "alpha against 1 - (1 - 1e-8)^(1e8) = 0.632; in half floats this opacity is 0",
                           [](const Draw& draw) { return faintError(draw, 1e-8, 1e8, 1000.0); });
  findings += inEachEngine(bench, "opacity 0.9999 over one unit distance", {1e-12, 1e-6, 1e-6},
                           "alpha against 0.9999; in half floats this opacity is 1",
                           [](const Draw& draw) { return faintError(draw, 0.9999, 1.0, 1.0); });
  findings += inEachEngine(bench, "colours 1/65535 apart", {1e-12, 1e-6, 1e-6},
                           "premultiplied colour of half a unit of opacity against half the colour",
                           [](const Draw& draw) {
                             double largest = 0.0;
                             for (int i = 32760; i < 32776; ++i) {
                               Scene scene = rayThrough(boxOf(white));
                               scene.transferFunction = constantFunction(0.5, glm::dvec3(i / 65535.0));
                               const double drawn = draw(scene, {1, 1}).at(0, 0).r;
                               largest = std::max(largest, std::abs(drawn - 0.5 * i / 65535.0));
                             }
                             return finiteOrInfinite(largest);
                           });
  return findings;
}

// The value runs from 0 to 1 over 1 mm, in `samples` exact steps.
Scene ramp(double samples) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.quality.stepVoxels = 1.0 / samples;
  scene.quality.preintegrated = Preintegration::always;
  return scene;
}

// A plateau of width w around 1/2 whose depth along the ramp is 0.7.
constexpr double spikeDepth = 0.7;

double spikeError(const Draw& draw, Scene scene, double width) {
  const double low = 0.5 - 0.5 * width, high = 0.5 + 0.5 * width, extinction = spikeDepth / width;
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(low, 0.0, white), extinctionPoint(low, extinction, white),
                             extinctionPoint(high, extinction, white), extinctionPoint(high, 0.0, white)}};
  return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-spikeDepth));
}

double unaskedSpikeError(const Draw& draw, double unitMm) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 100.0));
  scene.crop = ramp(1.0).crop;
  scene.quality.preintegrated = Preintegration::automatic;
  const double opacity = -std::expm1(-7.0 * unitMm);
  scene.transferFunction = {
      unitMm,
      {{0.4995, white, 0.0}, {0.4995, white, opacity}, {0.5005, white, opacity}, {0.5005, white, 0.0}}};
  return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-spikeDepth));
}

std::vector<Finding> spikes(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [what, width] : {std::pair{"a spike of 1/20 of the range", 0.05},
                                    {"a spike of 1/256", 1.0 / 256.0},
                                    {"a spike of 1/1000", 1e-3},
                                    {"a spike of 1/100000", 1e-5}}) {
    // At either edge of the spike the value is off by three roundings of coordinates over four texels and one
    // of its own, 3.5 · 2⁻²⁴, and so is the edge by half of 2⁻²⁴: so much of the width.
    const double edges = spikeDepth * std::exp(-spikeDepth) * 8.0 * 0x1p-24 / width;
    findings += inEachEngine(bench, what, {1e-9, 2e-6 + edges, 2e-6 + edges},
                             "alpha against 1 - exp(-0.7) in 1 to 1000 exact steps; floats round the spike's "
                             "edges and the values at the ends of steps",
                             [width = width](const Draw& draw) {
                               double largest = 0.0;
                               for (const double samples : {1.0, 2.0, 3.0, 7.0, 64.0, 1000.0})
                                 largest = std::max(largest, spikeError(draw, ramp(samples), width));
                               return largest;
                             });
  }
  // 100 mm long, over 1 mm the spike has opacity 0.9991; or over 1e-9 mm one of 7e-9.
  for (const auto& [what, unit] : {std::pair{"a spike of 1/1000, steps chosen by the program", 1.0},
                                   {"the same of a tiny unit distance", smallUnitMm}})
    findings += inEachEngine(bench, what, {1e-9, 2e-4, 2e-4},
                             "alpha against 1 - exp(-0.7): samples half a voxel apart would miss it, so "
                             "steps must become exact of themselves",
                             [unit = unit](const Draw& draw) { return unaskedSpikeError(draw, unit); });
  return findings;
}

// Opacity rises from 0 to 0.8 and falls to 0.2.
TransferFunction twoFlanks() {
  return {1.0, {{0.0, {0.1, 0.2, 0.3}, 0.0}, {0.5, {0.9, 0.5, 0.1}, 0.8}, {1.0, {0.2, 0.9, 0.4}, 0.2}}};
}

// The mean of -log(1-a) over opacities from a to b: ((1-a) log(1-a) + a) is the integral from 0 on. Where the
// two nearly agree, the value in the middle and the curvature there.
double meanExtinction(double a, double b) {
  const auto integral = [](double x) { return (1.0 - x) * std::log1p(-x) + x; };
  if (std::abs(b - a) > 1e-4)
    return (integral(b) - integral(a)) / (b - a);
  const double middle = 0.5 * (a + b);
  return -std::log1p(-middle) + (b - a) * (b - a) / (24.0 * (1.0 - middle) * (1.0 - middle));
}

// Pairs of values that both lie on one flank, nearer and nearer to each other.
std::vector<glm::vec4> nearPairs() {
  std::vector<glm::vec4> pairs;
  for (const float from : {0.001f, 0.11f, 0.3f, 0.49f, 0.55f, 0.77f, 0.9f})
    for (const float apart : {0.0f, 1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f}) {
      pairs.push_back({from, from + apart, 0.0f, 0.0f});
      pairs.push_back({from + apart, from, 0.0f, 0.0f});
    }
  return pairs;
}

std::vector<Finding> equalEnds(Workbench& bench) {
  const TransferFunction function = twoFlanks();
  Scene scene = ramp(2.0);
  scene.transferFunction = function;
  const std::vector<glm::vec4> pairs = nearPairs();
  const auto worst = [&](const auto& extinctionOf) {
    double largest = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double expected =
          meanExtinction(classify(function, pairs[i].x).opacity, classify(function, pairs[i].y).opacity);
      largest = std::max(largest, finiteOrInfinite(std::abs(oneMinusExpNeg(0.5 * extinctionOf(i)) -
                                                            oneMinusExpNeg(0.5 * expected))));
    }
    return largest;
  };
  const auto inCpp = [&](std::size_t i) { return meanMaterial(function, pairs[i].x, pairs[i].y).extinction; };
  const std::string what = "steps between nearly equal values";
  const std::string reason = "alpha of half a unit distance between two values 0 to 0.01 apart, against the "
                             "integral's closed form: nothing is divided by their difference";
  std::vector<Finding> findings = {
      atMost("cpp", what, worst(inCpp), 1e-12, reason), withOpenGl(bench, "glsl", what, [&] {
        const std::vector<glm::vec4> means =
            GlslEvaluator({"stable_math.glsl", "piecewise.glsl", "classification.glsl",
                           "preintegration.glsl"})("meanMaterial(v.x, v.y).extinction", pairs, scene);
        return atMost("glsl", what, worst([&](std::size_t i) { return double(means[i].r); }), 2e-6, reason);
      })};
  findings +=
      inEachEngine(bench, "a constant volume in exact steps", {1e-12, 1e-6, 1e-6},
                   "alpha of extinction 0.7 over half a mm against 1 - exp(-0.35)", [](const Draw& draw) {
                     Scene flat = rayThrough(boxOf(glm::dvec3(0.5)));
                     flat.transferFunction = constantFunction(-std::expm1(-0.7), white);
                     flat.quality.preintegrated = Preintegration::always;
                     flat.quality.stepVoxels = 0.3;
                     return largestAlphaError(draw(flat, {1, 1}), -std::expm1(-0.35));
                   });
  return findings;
}

// Extinction 10 s and colour s over one step: alpha is 1 - exp(-5), the mean colour, weighted by extinction,
// ∫s·s/∫s = 2/3 of it. Without attenuation within the step the colour would be 3.33.
double steepStepError(const Draw& draw) {
  Scene scene = ramp(1.0);
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(0.0, 0.0, glm::dvec3(0.0)), extinctionPoint(1.0, 10.0, white)}};
  const glm::dvec4 pixel = draw(scene, {1, 1}).at(0, 0);
  const double alpha = -std::expm1(-5.0);
  return finiteOrInfinite(std::max(std::abs(pixel.a - alpha), std::abs(pixel.r - alpha * 2.0 / 3.0)));
}

int unsoundLongSteps(const Draw& draw) {
  std::mt19937 generator(37);
  const auto share = [&] { return (generator() % 1001) / 1000.0; };
  int unsound = 0;
  for (int i = 0; i < 12; ++i) {
    Scene scene = wholeVolume(smoothVolume(10), ShadingModel::none, 0.0, 100.0, {0.6, 0.64, 0.48});
    scene.transferFunction.points.clear();
    for (int k = 0; k < 5; ++k)
      scene.transferFunction.points.push_back(
          {25.0 * k, {share(), share(), share()}, k % 2 == 0 ? share() : 1.0});
    scene.transferFunction.unitDistanceMm = 0.1;
    scene.quality.preintegrated = Preintegration::always;
    scene.quality.stepVoxels = 4.0;
    unsound += unsoundPixels(draw(scene, {16, 16}));
  }
  return unsound;
}

std::vector<Finding> attenuation(Workbench& bench) {
  std::vector<Finding> findings = inEachEngine(bench, "one step from extinction 0 to 10", {1e-7, 2e-6, 2e-6},
                                               "alpha against 1 - exp(-5) and colour against 2/3 of it; "
                                               "extinction over 1e-9 mm is linear in the value to 1e-8",
                                               steepStepError);
  findings += inEachEngine(bench, "random steep functions in steps of 4 voxels", {},
                           "pixels with a colour above alpha, or that are not finite or outside 0..1",
                           [](const Draw& draw) { return unsoundLongSteps(draw); });
  return findings;
}

} // namespace

std::vector<HardCase> functionCases() {
  return {
      {"H20", "Data in a small part of their range keep all their values", narrowRanges},
      {"H24", "Functions of no, one, coincident and unsorted points mean what they say", degenerateFunctions},
      {"H26", "A looked-up value is not shifted by half an entry", lookUps},
      {"H27", "Faint and nearly full opacities keep their digits", preciseFunctions},
      {"H25", "Spikes narrower than any table's entry keep their light", spikes},
      {"H36", "Exact steps between equal values divide nothing by nothing", equalEnds},
      {"H37", "Exact steps attenuate their own light: no colour exceeds its alpha", attenuation}};
}

} // namespace limn
