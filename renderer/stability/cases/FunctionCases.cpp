// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Error.h"
#include "stability/Measures.h"
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

} // namespace

std::vector<HardCase> functionCases() {
  return {
      {"H20", "Data in a small part of their range keep all their values", narrowRanges},
      {"H24", "Functions of no, one, coincident and unsorted points mean what they say", degenerateFunctions},
      {"H26", "A looked-up value is not shifted by half an entry", lookUps},
      {"H27", "Faint and nearly full opacities keep their digits", preciseFunctions}};
}

} // namespace limn
