// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <cmath>

namespace limn {
namespace {

// The value runs from 0 to 1 over 1 mm between two voxel centres.
Scene ramp(Projection projection, double samples) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.projection = projection;
  scene.quality.stepVoxels = 1.0 / samples;
  scene.transferFunction = {1.0, {{0.0, white, 0.0}, {1.0, white, 1.0}}};
  return scene;
}

// Where the ramp reaches an isovalue, as the share of the way along it: that is the isovalue itself.
double hitError(const Draw& draw, double isovalue, double samples) {
  Scene scene = ramp(Projection::isosurface, samples);
  scene.isovalue = isovalue;
  scene.transferFunction = constantFunction(0.0, black);
  const double entry = -0.5 - scene.camera.position.y;
  scene.fog = distanceFog(entry, entry + 1.0);
  const glm::dvec4 pixel = draw(scene, {1, 1}).at(0, 0);
  return finiteOrInfinite(std::max(std::abs(pixel.r - isovalue), std::abs(pixel.a - 1.0)));
}

// All but one voxel lie above the isovalue, so every ray is hit where it enters the box of 24 mm; black
// surfaces show by fog how far behind that.
double hitAtEntryError(const Draw& draw) {
  const auto volume = volumeOf(centredGrid(glm::ivec3(24), glm::dvec3(1.0)), [](int i, int j, int k) {
    return glm::ivec3(i, j, k) == glm::ivec3(12) ? 0.0 : 100.0;
  });
  Scene scene = wholeVolume(volume, ShadingModel::none, 0.0, 100.0);
  scene.camera.heightMm = 24.0;
  scene.projection = Projection::isosurface;
  scene.transferFunction = constantFunction(0.0, black);
  const double entry = -12.0 - scene.camera.position.y;
  scene.fog = distanceFog(entry, entry + 24.0);
  double largest = 0.0;
  for (const double isovalue : {50.0, -1.0}) {
    scene.isovalue = isovalue;
    for (const glm::dvec4& pixel : draw(scene, {24, 24}).pixels)
      largest = std::max(largest, finiteOrInfinite(std::max(std::abs(pixel.r), std::abs(pixel.a - 1.0))));
  }
  return largest;
}

std::vector<Finding> hitsOnRamp(Workbench& bench) {
  std::vector<Finding> findings;
  for (const double samples : {1.0, 7.0, 64.0}) {
    // A ten thousandth of a step is what a surface is refined to; what is less than 1e-5 counts as that.
    const double bound = std::max(1e-5, 1e-4 / samples);
    findings += inEachEngine(
        bench, "values 0, 0.37, 0.5 and 1 of a ramp in " + std::to_string(int(samples)) + " steps",
        {bound, bound, bound},
        "where it is hit against where it lies, at the entry and at the exit too; surfaces are refined to "
        "1e-4 of a step",
        [samples](const Draw& draw) {
          double largest = 0.0;
          for (const double isovalue : {0.0, 0.37, 0.5, 1.0})
            largest = std::max(largest, hitError(draw, isovalue, samples));
          return largest;
        });
  }
  findings += inEachEngine(bench, "rays that enter above the value", {1e-12, 1e-6, 1e-6},
                           "where they are hit against where they enter, whatever dip the volume has within",
                           hitAtEntryError);
  findings += inEachEngine(bench, "a value above all", {}, "alpha where nothing can be hit: exactly 0",
                           [](const Draw& draw) {
                             Scene scene = ramp(Projection::isosurface, 7.0);
                             scene.isovalue = 1.0 + 1e-6;
                             return largestAlphaError(draw(scene, {1, 1}), 0.0);
                           });
  return findings;
}

// A ball of radius 1/2 at distance b from its centre: hit √(1/4 - b²) before the middle, where N·V is twice
// that.
std::vector<Finding> hitsOnBall(Workbench& bench) {
  std::vector<Finding> findings;
  constexpr double voxel = 1.0 / 2048.0;
  for (const auto& [what, b] :
       {std::pair{"a ball through its middle", 0.0}, {"a ball aside", 0.3}, {"a ball near its rim", 0.499}}) {
    const double depth = std::sqrt(0.25 - b * b);
    findings +=
        inEachEngine(bench, std::string(what) + ": place", {1e-5, 1e-5, 1e-5},
                     "distance of the hit from the eye against the ball's, mm; voxels of 1/2048 mm",
                     [b = b, depth](const Draw& draw) {
                       Scene scene = ballSurface(b, voxel);
                       scene.transferFunction = constantFunction(0.0, black);
                       scene.fog = distanceFog(0.0, 1.0);
                       return finiteOrInfinite(std::abs(draw(scene, {1, 1}).at(0, 0).r - (1.0 - depth)));
                     });
    findings +=
        inEachEngine(bench, std::string(what) + ": normal", {1e-5, 2e-4, 2e-4},
                     "N·V against twice the depth; differences of floats over two voxels are off by two of "
                     "their roundings, 2^-24 of 0.7 mm in 1/1024 mm each",
                     [b = b, depth](const Draw& draw) {
                       Scene scene = ballSurface(b, voxel);
                       scene.transferFunction = constantFunction(0.0, white);
                       scene.shading.model = ShadingModel::classic;
                       scene.shading.ambient = scene.shading.specular = 0.0;
                       scene.shading.diffuse = scene.shading.lightIntensity = 1.0;
                       return finiteOrInfinite(std::abs(draw(scene, {1, 1}).at(0, 0).r - 2.0 * depth));
                     });
  }
  return findings;
}

std::vector<Finding> surfaces(Workbench& bench) {
  std::vector<Finding> findings = hitsOnRamp(bench);
  findings += hitsOnBall(bench);
  return findings;
}

struct Extreme {
  const char* what;
  Projection projection;
  double expected;
};

// Samples at the voxels of -1000, -300, -10 and -500; -1000 has opacity 0, 0 would have 1.
std::vector<Finding> negativeData(Workbench& bench) {
  std::vector<Finding> findings;
  for (const Extreme& one : {Extreme{"the largest of negative values", Projection::mip, 0.99},
                             Extreme{"the smallest of negative values", Projection::minip, 0.0},
                             Extreme{"the mean of negative values", Projection::average, 0.5475}})
    findings += inEachEngine(bench, one.what, {1e-12, 1e-6, 1e-6},
                             "alpha against the value's opacity: -10, -1000, or their mean -452.5, never 0",
                             [&one](const Draw& draw) {
                               Scene scene = rayThrough(columnOf({-1000.0, -300.0, -10.0, -500.0}, 1.0));
                               scene.projection = one.projection;
                               scene.quality.stepVoxels = 1.0;
                               scene.transferFunction = {1.0, {{-1000.0, white, 0.0}, {0.0, white, 1.0}}};
                               return largestAlphaError(draw(scene, {1, 1}), one.expected);
                             });
  return findings;
}

// The mean of a ramp, its X-ray of extinction 3 s, and its largest sample, half a step short of the end.
std::vector<Finding> sampledRamps(Workbench& bench) {
  std::vector<Finding> findings;
  for (const double samples : {1.0, 7.0, 64.0, 1000.0}) {
    const std::string steps = " of a ramp in " + std::to_string(int(samples)) + " steps";
    findings +=
        inEachEngine(bench, "the mean" + steps, {1e-12, 1e-6, 1e-6},
                     "alpha against 1/2, whatever the number of samples", [=](const Draw& draw) {
                       return largestAlphaError(draw(ramp(Projection::average, samples), {1, 1}), 0.5);
                     });
    findings += inEachEngine(
        bench, "the largest" + steps, {1e-12, 1e-6, 1e-6},
        "alpha against the last sample, half a step before the end", [=](const Draw& draw) {
          return largestAlphaError(draw(ramp(Projection::mip, samples), {1, 1}), 1.0 - 0.5 / samples);
        });
    findings +=
        inEachEngine(bench, "the X-ray" + steps, {1e-8, 2e-6, 2e-6 + samples * 0x1p-22},
                     "alpha against 1 - exp(-3/2); extinction over 1e-9 mm is linear in the value to 1e-9, "
                     "each slice rounds by up to 2^-22",
                     [=](const Draw& draw) {
                       Scene scene = ramp(Projection::xray, samples);
                       scene.transferFunction = {
                           smallUnitMm, {extinctionPoint(0.0, 0.0, white), extinctionPoint(1.0, 3.0, white)}};
                       return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-1.5));
                     });
  }
  return findings;
}

DrawnPicture mirrored(const DrawnPicture& picture) {
  DrawnPicture other = picture;
  for (int y = 0; y < picture.size.y; ++y)
    for (int x = 0; x < picture.size.x; ++x)
      other.pixels[static_cast<std::size_t>(y) * picture.size.x + x] = picture.at(picture.size.x - 1 - x, y);
  return other;
}

std::vector<Finding> oppositeSides(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [what, projection] : {std::pair{"the largest from opposite sides", Projection::mip},
                                         {"the smallest from opposite sides", Projection::minip},
                                         {"the mean from opposite sides", Projection::average},
                                         {"an X-ray from opposite sides", Projection::xray}})
    findings += inEachEngine(bench, what, {1e-12, 3e-6, 3e-6},
                             "largest difference of the mirrored picture: the samples are the same, floats "
                             "place them to 1e-6 voxels",
                             [projection = projection](const Draw& draw) {
                               const auto from = [&](double side) {
                                 Scene scene = wholeVolume(smoothVolume(12), ShadingModel::none, 0.0, 100.0,
                                                           side * glm::dvec3(0.6, 0.8, 0.0));
                                 scene.projection = projection;
                                 return draw(scene, {24, 24});
                               };
                               return largestDifference(from(1.0), mirrored(from(-1.0)));
                             });
  return findings;
}

std::vector<Finding> accumulators(Workbench& bench) {
  std::vector<Finding> findings = negativeData(bench);
  findings += sampledRamps(bench);
  findings += oppositeSides(bench);
  return findings;
}

// A Gaussian ball, wide enough for its voxels and narrow enough for its box.
Scene gaussianBall(const glm::dvec3& direction) {
  static const std::shared_ptr<const Volume> volume =
      volumeOf(centredGrid(glm::ivec3(56), glm::dvec3(1.0)), [](int i, int j, int k) {
        const glm::dvec3 p = glm::dvec3(i, j, k) - 27.5;
        return 1000.0 * std::exp(-0.5 * glm::dot(p, p) / 100.0);
      });
  Scene scene = rayThrough(volume, glm::normalize(direction));
  scene.camera.heightMm = 56.0;
  scene.transferFunction = {10.0, {{100.0, {0.9, 0.5, 0.3}, 0.0}, {1000.0, {1.0, 1.0, 0.9}, 0.6}}};
  scene.quality.stepVoxels = 0.25;
  return scene;
}

// The largest difference of five directions of view of the ball.
double turnedDifference(const Draw& draw, void (*apply)(Scene& scene)) {
  const auto from = [&](const glm::dvec3& direction) {
    Scene scene = gaussianBall(direction);
    apply(scene);
    return draw(scene, {20, 20});
  };
  const DrawnPicture first = from({0, 1, 0});
  double largest = 0.0;
  for (const glm::dvec3& direction :
       {glm::dvec3(1, 0, 0), glm::dvec3(0.6, 0.64, 0.48), glm::dvec3(1.0), glm::dvec3(-1, 1, 0.01)})
    largest = std::max(largest, largestDifference(from(direction), first));
  return largest;
}

std::vector<Finding> rotation(Workbench& bench) {
  struct Row {
    const char* what;
    void (*apply)(Scene& scene);
  };
  const Row rows[] = {{"unlit", [](Scene&) {}},
                      {"classic light", [](Scene& s) { s.shading.model = ShadingModel::classic; }},
                      {"enhanced light", [](Scene& s) { s.shading.model = ShadingModel::enhanced; }},
                      {"fog",
                       [](Scene& s) {
                         s.fog = {Fog::Mode::exp, glm::dvec3(0.2, 0.4, 0.6), 0.02, 0.0, 0.0};
                       }},
                      {"an X-ray", [](Scene& s) { s.projection = Projection::xray; }},
                      {"a maximum", [](Scene& s) { s.projection = Projection::mip; }},
                      {"a surface", [](Scene& s) {
                         s.projection = Projection::isosurface;
                         s.shading.model = ShadingModel::classic;
                         s.isovalue = 500.0;
                       }}};
  const double level = 1.0 / 255.0;
  std::vector<Finding> findings;
  for (const Row& row : rows)
    findings += inEachEngine(bench, std::string("a ball turned, ") + row.what, {level, level, level},
                             "largest difference between five directions of view: less than one level, "
                             "though each enters the box elsewhere",
                             [&row](const Draw& draw) { return turnedDifference(draw, row.apply); });
  return findings;
}

} // namespace

std::vector<HardCase> projectionCases() {
  return {{"H41", "Surfaces are hit where they lie, at the entry and at the exit too", surfaces},
          {"H43", "Largest, smallest and mean values do not start from 0 nor depend on the samples",
           accumulators},
          {"H44", "A ball looks the same from every side, wherever rays enter its box", rotation}};
}

} // namespace limn
