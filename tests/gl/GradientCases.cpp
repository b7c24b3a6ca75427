// SPDX-License-Identifier: GPL-3.0-or-later
// Differences through the real code on both sides: renderer/scene/light/Gradient on a volume, and the blocks
// volume.glsl and gradient.glsl on the texture that the ray caster makes of it.
#include "gl/HelperCases.h"

#include "glsl/programs/GlslEvaluator.h"
#include "scene/light/Gradient.h"
#include "support/AnalyticScenes.h"
#include "support/MarschnerLobb.h"
#include "support/Orders.h"

#include <functional>
#include <random>

namespace limn::test {
namespace {

using nlohmann::json;
using Field = std::function<double(const glm::dvec3&)>;

// A volume that samples a field.
std::shared_ptr<const Volume> sampled(const Grid& grid, const Field& field) {
  std::vector<double> voxels;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        voxels.push_back(field(indexToWorld(grid, {i, j, k})));
  return std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{});
}

// Voxels `spacing` apart along x, the first at `first`.
std::shared_ptr<const Volume> lineOf(int count, double first, double spacing,
                                     const std::function<double(double)>& f) {
  Grid grid;
  grid.dims = {count, 1, 1};
  grid.spacingMm = glm::dvec3(spacing);
  grid.originMm.x = first;
  return sampled(grid, [&f](const glm::dvec3& p) { return f(p.x); });
}

std::vector<glm::vec4> centredArguments(const Volume& volume, const std::vector<glm::dvec3>& indices) {
  std::vector<glm::vec4> arguments;
  for (const glm::dvec3& index : indices)
    arguments.emplace_back(glm::vec3(index - (glm::dvec3(volume.grid().dims) - 1.0) / 2.0), 0.0f);
  return arguments;
}

// What the shaders see of a volume at continuous indices, in the volume's own units.
struct GpuField {
  std::vector<double> values;
  std::vector<glm::dvec3> gradients;
};

GpuField onGpu(const std::shared_ptr<const Volume>& volume, const std::vector<glm::dvec3>& indices) {
  static const GlslEvaluator evaluate(
      {"driver_weights.glsl", "volume.glsl", "gradient.glsl"},
      "vec3 inside(vec3 index) { return clamp(toTexture(index), u_textureLower, u_textureUpper); }");
  const std::vector<glm::vec4> found = evaluate("vec4(gradientAt(inside(v.xyz)), scalarAt(inside(v.xyz)))",
                                                centredArguments(*volume, indices), rayThrough(volume));
  const double width = volume->range().highest - volume->range().lowest;
  GpuField field;
  for (const glm::vec4& texel : found) {
    field.values.push_back(volume->range().lowest + width * texel.w);
    field.gradients.emplace_back(glm::dvec3(texel) * (width / smallestSpacingMm(volume->grid())));
  }
  return field;
}

// The derivative along x at a voxel, in C++ and in GLSL.
glm::dvec2 derivatives(const std::shared_ptr<const Volume>& volume, int index) {
  return {gradientAtVoxel(*volume, {index, 0, 0}).x,
          onGpu(volume, {glm::dvec3(index, 0.0, 0.0)}).gradients[0].x};
}

std::function<double(double)> functionOf(const std::string& id) {
  if (id == "G1_cd_x^2")
    return [](double x) { return x * x; };
  if (id == "G1_cd_x^3")
    return [](double x) { return x * x * x; };
  if (id == "G1_cd_x^5")
    return [](double x) { return x * x * x * x * x; };
  if (id == "G1_cd_sin(3x)")
    return [](double x) { return std::sin(3.0 * x); };
  throw std::runtime_error("G1: no function for " + id);
}

// Compares the orders that the errors of three halvings show with the stated one, where they stand above
// rounding.
void expectOrder(const json& one, CaseLedger& ledger, const std::string& what,
                 const std::vector<double>& errors, double order) {
  for (const double observed : observedOrders(errors, 1e-9))
    ledger.expectWithin(one["id"], "order of " + what, observed, order - 0.15, order + 0.15);
}

} // namespace

// G1: a voxel at the border gives the one-sided difference, one between neighbours the central one. There is
// no wider stencil; the fourth-order one is Richardson's combination of two central ones.
void checkDifferences(const json& one, CaseLedger& ledger) {
  const double x = one["parameters"]["x"];
  const double exact = expectedFigure(one["expected"]["exact"]);
  const auto f = functionOf(one["id"]);
  std::map<std::string, std::vector<double>> errors;
  for (const char* key : {"0.1", "0.05", "0.025"}) {
    const double h = std::stod(key);
    const glm::dvec2 forward = derivatives(lineOf(2, x, h, f), 0);
    const glm::dvec2 central = derivatives(lineOf(3, x - h, h, f), 1);
    const glm::dvec2 wide = derivatives(lineOf(3, x - 2.0 * h, 2.0 * h, f), 1);
    const glm::dvec2 fourth = (4.0 * central - wide) / 3.0;
    const json& row = one["expected"]["table"][key];
    for (const auto& [name, value] : {std::pair{"fd", forward}, {"cd2", central}, {"cd4", fourth}}) {
      expectBoth(one, ledger, name + std::string(" at ") + key, std::stod(row[name].get<std::string>()),
                 value.x, value.y);
      errors[name].push_back(std::abs(value.x - exact));
    }
  }
  expectOrder(one, ledger, "fd", errors["fd"], 1.0);
  expectOrder(one, ledger, "cd2", errors["cd2"], 2.0);
  expectOrder(one, ledger, "cd4", errors["cd4"], 4.0);
}

// G2: a linear field keeps its modulus of 1 and its direction on a grid of unequal spacings.
void checkAnisotropicNormal(const json& one, CaseLedger& ledger) {
  Grid grid;
  grid.dims = glm::ivec3(4);
  for (int axis = 0; axis < 3; ++axis)
    grid.spacingMm[axis] = one["parameters"]["spacing"][static_cast<std::size_t>(axis)];
  const auto volume = sampled(grid, [](const glm::dvec3& p) { return (p.x + p.y + p.z) / std::sqrt(3.0); });
  const std::vector<glm::dvec3> indices{{1.0, 2.0, 1.0}, {0.0, 3.0, 0.0}, {1.3, 2.7, 0.4}};
  const GpuField gpu = onGpu(volume, indices);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const glm::dvec3 cpu = gradientAt(*volume, indices[i]);
    expectBoth(one, ledger, "modulus", expectedFigure(one["expected"]["modulus"]), glm::length(cpu),
               glm::length(gpu.gradients[i]));
    for (int axis = 0; axis < 3; ++axis)
      expectBoth(one, ledger, "normal", 1.0 / std::sqrt(3.0), cpu[axis], gpu.gradients[i][axis]);
  }
}

// G3: no half gradient at the border, at the outermost centres and in the half voxel beyond them.
void checkBoundaryGradient(const json& one, CaseLedger& ledger) {
  const double slope = one["parameters"]["slope"];
  const auto volume = lineOf(5, 0.0, 1.0, [slope](double x) { return slope * x; });
  const std::vector<glm::dvec3> indices{{0, 0, 0}, {4, 0, 0}, {-0.4, 0, 0}, {4.4, 0, 0}, {0.5, 0, 0}};
  const GpuField gpu = onGpu(volume, indices);
  for (std::size_t i = 0; i < indices.size(); ++i)
    expectBoth(one, ledger, "at " + std::to_string(indices[i].x),
               expectedFigure(one["expected"]["one_sided"]), gradientAt(*volume, indices[i]).x,
               gpu.gradients[i].x);
}

namespace {

// [-1,1]³ in 41 voxels along each axis.
Grid marschnerLobbGrid() {
  Grid grid;
  grid.dims = glm::ivec3(41);
  grid.spacingMm = glm::dvec3(0.05);
  grid.originMm = glm::dvec3(-1.0);
  return grid;
}

// Mean errors of value and gradient at fixed places on a grid of 2^-level of 1/80 spacing, C++ and GLSL.
struct MeanErrors {
  glm::dvec2 value{0.0}, gradient{0.0};
};

MeanErrors marschnerLobbErrors(int voxels) {
  constexpr double edge = 0.2;
  Grid grid;
  grid.dims = glm::ivec3(voxels + 1);
  grid.spacingMm = glm::dvec3(edge / voxels);
  grid.originMm = {0.3, 0.2, -0.4};
  const auto volume = sampled(grid, marschnerLobb);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> place(0.1, 0.9);
  std::vector<glm::dvec3> indices;
  for (int i = 0; i < 500; ++i)
    indices.emplace_back(glm::dvec3(place(generator), place(generator), place(generator)) * double(voxels));
  const GpuField gpu = onGpu(volume, indices);
  MeanErrors mean;
  const double share = 1.0 / static_cast<double>(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const glm::dvec3 p = indexToWorld(grid, indices[i]);
    const double value = marschnerLobb(p);
    const glm::dvec3 gradient = marschnerLobbGradient(p);
    mean.value += share * glm::abs(glm::dvec2(valueAt(*volume, indices[i]), gpu.values[i]) - value);
    mean.gradient += share * glm::dvec2(glm::distance(gradientAt(*volume, indices[i]), gradient),
                                        glm::distance(gpu.gradients[i], gradient));
  }
  return mean;
}

} // namespace

// L1: the stated points are voxels of the 41³ grid. There the signal has 1.6 samples per ripple; its order is
// seen from 1/80 on, where a ripple (2/(fM·π) long at its shortest) has eight.
void checkMarschnerLobb(const json& one, CaseLedger& ledger) {
  const Grid grid = marschnerLobbGrid();
  const auto volume = sampled(grid, marschnerLobb);
  const std::pair<const char*, glm::dvec3> points[] = {{"('0', '0', '0')", {0.0, 0.0, 0.0}},
                                                       {"('0.1', '0.2', '-0.3')", {0.1, 0.2, -0.3}},
                                                       {"('0.5', '0.5', '0.5')", {0.5, 0.5, 0.5}},
                                                       {"('-0.9', '0.3', '0.7')", {-0.9, 0.3, 0.7}},
                                                       {"('1', '0', '-1')", {1.0, 0.0, -1.0}}};
  EXPECT_EQ(std::size(points), one["expected"].size());
  std::vector<glm::dvec3> indices;
  for (const auto& [key, p] : points)
    indices.push_back(glm::round(worldToIndex(grid, p)));
  const GpuField gpu = onGpu(volume, indices);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const double expected = expectedFigure(one["expected"][points[i].first]);
    ledger.expectNear(one["id"], "formula", marschnerLobb(points[i].second), expected, 1e-12);
    expectBoth(one, ledger, points[i].first, expected, valueAt(*volume, indices[i]), gpu.values[i]);
  }
  std::map<std::string, std::vector<double>> errors;
  for (const int voxels : {16, 32, 64}) {
    const MeanErrors mean = marschnerLobbErrors(voxels);
    errors["value in C++"].push_back(mean.value.x);
    errors["value in GLSL"].push_back(mean.value.y);
    errors["gradient in C++"].push_back(mean.gradient.x);
    errors["gradient in GLSL"].push_back(mean.gradient.y);
  }
  for (const auto& [what, sequence] : errors)
    for (const double order : observedOrders(sequence, 1e-5)) {
      std::cout << "Marschner-Lobb, order of " << what << " " << order << "\n";
      ledger.expectWithin(one["id"], what, order, 1.8, 2.2);
    }
}

} // namespace limn::test
