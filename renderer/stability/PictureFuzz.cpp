// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/PictureFuzz.h"

#include "cpu/CpuRenderer.h"
#include "cpu/bricks/BrickRenderer.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/Scene.h"
#include "scene/basics/Error.h"
#include "scene/basics/Image.h"
#include "scene/steps/RayFrame.h"
#include "slices/SliceRenderer.h"
#include "stability/scenes/RandomScene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
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

// What must hold for every picture, whatever it shows (HARD_CASES section 4), as sentences about what does
// not, each with the first pixel at fault; empty where all holds. Every channel is finite, 0 ≤ A ≤ 1, every
// premultiplied colour lies within 0..A + `rounding` (each model limits the light to 0..1 and fog is no
// brighter), and pixels whose rays surely miss what the crop leaves of the volume are zero bit for bit.
std::vector<std::string> brokenInvariants(const Scene& scene, const Image& image, double rounding = 1e-6) {
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

// Says where two pictures that must be the same bit for bit differ first; empty where they do not.
std::string firstDifference(const Image& image, const Image& again) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (bitsOf(image.pixels[i]) != bitsOf(again.pixels[i]))
      return place(image, i) + ", the other " + place(again, i);
  return {};
}

// HARD_CASES section 5.
constexpr double referenceTolerance = 2e-4;
// Half a level: what the CPU engine may be off where it takes the samples of the reference.
constexpr double processorTolerance = 0.5 / 255.0;
// A part of the seeds, because a fresh ray caster compiles its programs.
constexpr std::uint64_t seedsPerFreshCaster = 32;
constexpr std::uint64_t seedsPerSlices = 8;
// What the rounding of each blended layer adds at most (SliceRenderer.h).
constexpr double layerRounding = 0x1p-22;

// Draws seed after seed with the same renderers.
class Fuzzer {
public:
  explicit Fuzzer(FuzzedBy fuzzedBy) {
    if (fuzzedBy == FuzzedBy::everyRenderer)
      m_openGl.emplace();
  }

  FuzzReport report;

  void run(std::uint64_t seed) {
    ++report.seeds;
    const auto start = std::chrono::steady_clock::now();
    try {
      check(seed);
    } catch (const Error& error) {
      fail(seed, std::string("the picture was refused: ") + error.what());
    } catch (const std::exception& error) {
      fail(seed, std::string("an exception that is no sentence for people: ") + error.what());
    }
    report.programs = m_openGl ? m_openGl->caster.compiledPrograms() : 0;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (seconds > report.slowestSeconds) {
      report.slowestSeconds = seconds;
      report.slowestSeed = seed;
    }
  }

private:
  void fail(std::uint64_t seed, const std::string& sentence) {
    report.failures.push_back({seed, m_description + ": " + sentence});
  }

  // The scene; absent where the volume was refused as it should be.
  std::optional<RandomScene> drawn(std::uint64_t seed) {
    m_description = "volume";
    try {
      RandomScene random = randomScene(seed);
      m_description = random.description;
      return random;
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::input)
        throw;
      ++report.refused;
      return std::nullopt;
    }
  }

  void check(std::uint64_t seed) {
    const std::optional<RandomScene> random = drawn(seed);
    if (!random)
      return;
    const Image processed = m_processor.render(random->scene, random->size);
    for (const std::string& broken : brokenInvariants(random->scene, processed))
      fail(seed, "the CPU engine: " + broken);
    requireSame(seed, "the CPU engine differs where it steps over nothing", processed,
                m_samplingProcessor.render(random->scene, random->size));
    if (random->scene.quality.toleranceLevels)
      requireStepsFirst(seed, *random);
    requireBricks(seed, *random);
    std::optional<ReferencePicture> reference;
    if (random->isComparable) {
      ++report.referenceCompared;
      reference = renderReference(random->scene, random->size, 0, {}, Limiting::clampOrKnee, {},
                                  ToTolerance::byLocalSteps);
      // Error-controlled steps may fall on other sides of a limit in float: a picture as good, not the same
      // one.
      if (!random->scene.quality.toleranceLevels)
        compareProcessor(seed, *reference, processed, leftOutOf(random->scene));
    }
    if (m_openGl)
      checkOpenGl(seed, *random, reference);
  }

  void checkOpenGl(std::uint64_t seed, const RandomScene& random,
                   const std::optional<ReferencePicture>& reference) {
    RayCaster& caster = m_openGl->caster;
    const Image image = caster.render(random.scene, random.size);
    for (const std::string& broken : brokenInvariants(random.scene, image))
      fail(seed, broken);
    requireSame(seed, "the second picture differs", image, caster.render(random.scene, random.size));
    if (seed % seedsPerFreshCaster == 0)
      drawFreshly(seed, random);
    if (reference)
      compare(seed, random, image, *reference);
    if (random.isSliceable && seed % seedsPerSlices == 0)
      slice(seed, random);
  }

  void requireSame(std::uint64_t seed, const char* what, const Image& image, const Image& again) {
    const std::string difference = firstDifference(image, again);
    if (!difference.empty())
      fail(seed, what + (" " + difference));
  }

  // What users see of a tolerance.
  void requireStepsFirst(std::uint64_t seed, const RandomScene& random) {
    const Image image = m_stepsFirst.render(random.scene, random.size);
    for (const std::string& broken : brokenInvariants(random.scene, image))
      fail(seed, "the CPU engine, steps first: " + broken);
    requireSame(seed, "the CPU engine, steps first, differs where it steps over nothing", image,
                m_samplingStepsFirst.render(random.scene, random.size));
  }

  // One picture on many nodes: where rays run to their end, the same samples are added in another order.
  // Error-controlled steps begin anew in each brick: another picture, as good.
  void requireBricks(std::uint64_t seed, const RandomScene& random) {
    Scene scene = random.scene;
    scene.quality.earlyTermination = 1.0;
    const int bricks = 2 + static_cast<int>(seed % 7);
    const Image folded = drawInBricks(scene, random.size, bricks);
    for (const std::string& broken : brokenInvariants(scene, folded))
      fail(seed, "bricks: " + broken);
    if (scene.quality.toleranceLevels)
      return;
    ++report.brickCompared;
    const Image whole = m_processor.render(scene, random.size);
    double worst = 0.0;
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
      const glm::vec4 error = glm::abs(folded.pixels[i] - whole.pixels[i]);
      worst = std::max(worst, double(std::max({error.r, error.g, error.b, error.a})));
    }
    report.worstInBricks = std::max(report.worstInBricks, worst);
    if (!(worst <= processorTolerance))
      fail(seed, std::to_string(bricks) + " bricks differ from the whole by " + std::to_string(worst));
  }

  // The very same program must draw the same bits, whatever was drawn before. (Another one that can stand in
  // may round otherwise: compilers reorder sums.)
  void drawFreshly(std::uint64_t seed, const RandomScene& random) {
    ++report.freshlyDrawn;
    m_openGl->caster.leaveOut(EffectSet{});
    const Image image = m_openGl->caster.render(random.scene, random.size);
    m_openGl->caster.leaveOut(std::nullopt);
    RayCaster fresh;
    requireSame(seed, "a fresh ray caster draws otherwise", image, fresh.render(random.scene, random.size));
  }

  // Where a ray ends early, each leaves out what the last transmittance may still show.
  static double leftOutOf(const Scene& scene) { return 1.0 - scene.quality.earlyTermination; }

  void compare(std::uint64_t seed, const RandomScene& random, const Image& image,
               const ReferencePicture& reference) {
    const std::vector<int> counts = m_openGl->caster.sampleCounts(random.scene, random.size);
    const double leftOut = leftOutOf(random.scene);
    double worst = 0.0;
    std::size_t worstPixel = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      if (counts[i] != reference.samples[i]) {
        ++report.pixelsUnequal;
        continue;
      }
      ++report.pixelsCompared;
      const glm::dvec4 error = glm::abs(glm::dvec4(image.pixels[i]) - reference.pixels[i]);
      const double off = std::max({error.r, error.g, error.b, error.a});
      if (!(off <= worst)) {
        worst = off;
        worstPixel = i;
      }
    }
    if (leftOut == 0.0)
      noteWorst(seed, worst);
    if (!(worst <= referenceTolerance + leftOut))
      fail(seed, differenceFrom(reference, image, worst, worstPixel));
  }

  void compareProcessor(std::uint64_t seed, const ReferencePicture& reference, const Image& image,
                        double leftOut) {
    double worst = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const glm::dvec4 error = glm::abs(glm::dvec4(image.pixels[i]) - reference.pixels[i]);
      const double off = std::max({error.r, error.g, error.b, error.a});
      if (!(off <= processorTolerance + leftOut))
        return fail(seed, "the CPU engine: " + differenceFrom(reference, image, off, i));
      worst = std::max(worst, off);
    }
    // The report's figures are the ray caster's where there is one.
    if (m_openGl)
      return;
    report.pixelsCompared += image.pixels.size();
    if (leftOut == 0.0)
      noteWorst(seed, worst);
  }

  void noteWorst(std::uint64_t seed, double worst) {
    if (worst <= report.worstDifference) // what is no number is the worst
      return;
    report.worstDifference = worst;
    report.worstSeed = seed;
  }

  static std::string differenceFrom(const ReferencePicture& reference, const Image& image, double worst,
                                    std::size_t pixel) {
    const auto width = static_cast<std::size_t>(image.size.x);
    const glm::dvec4 exact = reference.pixels[pixel];
    const glm::vec4 shown = image.pixels[pixel];
    std::ostringstream text;
    text << "the reference differs by " << worst << " at (" << pixel % width << ", " << pixel / width << "), "
         << reference.samples[pixel] << " samples: (" << exact.r << ", " << exact.g << ", " << exact.b << ", "
         << exact.a << "), not (" << shown.r << ", " << shown.g << ", " << shown.b << ", " << shown.a << ")";
    return text.str();
  }

  void slice(std::uint64_t seed, const RandomScene& random) {
    ++report.slices;
    const Image image = m_openGl->slices.render(random.scene, random.size);
    const double rounding = 1e-6 + layerRounding * mostLayers;
    for (const std::string& broken : brokenInvariants(random.scene, image, rounding))
      fail(seed, "slices: " + broken);
    requireSame(seed, "the second picture of slices differs", image,
                m_openGl->slices.render(random.scene, random.size));
  }

  static constexpr double mostLayers = 256.0; // RandomScene::isSliceable

  CpuRenderer m_processor;
  CpuRenderer m_samplingProcessor{0, CpuRenderer::EmptySpace::sampled};
  CpuRenderer m_stepsFirst{0, CpuRenderer::Tolerance::stepsFirst};
  CpuRenderer m_samplingStepsFirst{0, CpuRenderer::EmptySpace::sampled, CpuRenderer::Weights::floats,
                                   CpuRenderer::Tolerance::stepsFirst};
  struct OpenGl {
    RayCaster caster;
    SliceRenderer slices;
  };

  std::optional<OpenGl> m_openGl; // absent: the processor alone
  std::string m_description;
};

} // namespace

FuzzReport runFuzz(int seeds, std::uint64_t firstSeed, const std::function<bool(int)>& progress,
                   FuzzedBy fuzzedBy) {
  Fuzzer fuzzer(fuzzedBy);
  for (int i = 0; i < seeds; ++i) {
    fuzzer.run(firstSeed + static_cast<std::uint64_t>(i));
    if (progress && !progress(i + 1))
      break;
  }
  return std::move(fuzzer.report);
}

std::string lineOf(const FuzzFailure& failure) {
  return "limn stability --fuzz 1 --seed " + std::to_string(failure.seed) + "  # " + failure.sentence;
}

} // namespace limn
