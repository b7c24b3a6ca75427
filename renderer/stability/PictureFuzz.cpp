// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/PictureFuzz.h"

#include "cpu/CpuRenderer.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "slices/SliceRenderer.h"
#include "stability/PictureInvariants.h"
#include "stability/scenes/RandomScene.h"

#include <algorithm>
#include <chrono>
#include <sstream>

namespace limn {
namespace {

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
    report.programs = m_caster.compiledPrograms();
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
    const Image image = m_caster.render(random->scene, random->size);
    for (const std::string& broken : brokenInvariants(random->scene, image))
      fail(seed, broken);
    requireSame(seed, "the second picture differs", image, m_caster.render(random->scene, random->size));
    if (seed % seedsPerFreshCaster == 0)
      drawFreshly(seed, *random);
    const Image processed = m_processor.render(random->scene, random->size);
    for (const std::string& broken : brokenInvariants(random->scene, processed))
      fail(seed, "the CPU engine: " + broken);
    requireSame(seed, "the CPU engine differs where it steps over nothing", processed,
                m_samplingProcessor.render(random->scene, random->size));
    if (random->isComparable)
      compare(seed, *random, image, processed);
    if (random->isSliceable && seed % seedsPerSlices == 0)
      slice(seed, *random);
  }

  void requireSame(std::uint64_t seed, const char* what, const Image& image, const Image& again) {
    const std::string difference = firstDifference(image, again);
    if (!difference.empty())
      fail(seed, what + (" " + difference));
  }

  // The very same program must draw the same bits, whatever was drawn before. (Another one that can stand in
  // may round otherwise: compilers reorder sums.)
  void drawFreshly(std::uint64_t seed, const RandomScene& random) {
    ++report.freshlyDrawn;
    m_caster.leaveOut(EffectSet{});
    const Image image = m_caster.render(random.scene, random.size);
    m_caster.leaveOut(std::nullopt);
    RayCaster fresh;
    requireSame(seed, "a fresh ray caster draws otherwise", image, fresh.render(random.scene, random.size));
  }

  void compare(std::uint64_t seed, const RandomScene& random, const Image& image, const Image& processed) {
    ++report.referenceCompared;
    const std::vector<int> counts = m_caster.sampleCounts(random.scene, random.size);
    const ReferencePicture reference = renderReference(random.scene, random.size);
    // Where a ray ends early, each leaves out what the last transmittance may still show.
    const double leftOut = 1.0 - random.scene.quality.earlyTermination;
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
    if (leftOut == 0.0 && !(worst <= report.worstDifference)) {
      report.worstDifference = worst;
      report.worstSeed = seed;
    }
    if (!(worst <= referenceTolerance + leftOut))
      fail(seed, differenceFrom(reference, image, worst, worstPixel));
    // Error-controlled steps may fall on other sides of a limit in float: a picture as good, not the same
    // one.
    if (!random.scene.quality.toleranceLevels)
      compareProcessor(seed, reference, processed, processorTolerance + leftOut);
  }

  void compareProcessor(std::uint64_t seed, const ReferencePicture& reference, const Image& image,
                        double most) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const glm::dvec4 error = glm::abs(glm::dvec4(image.pixels[i]) - reference.pixels[i]);
      const double off = std::max({error.r, error.g, error.b, error.a});
      if (!(off <= most))
        return fail(seed, "the CPU engine: " + differenceFrom(reference, image, off, i));
    }
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
    const Image image = m_slices.render(random.scene, random.size);
    const double rounding = 1e-6 + layerRounding * mostLayers;
    for (const std::string& broken : brokenInvariants(random.scene, image, rounding))
      fail(seed, "slices: " + broken);
    requireSame(seed, "the second picture of slices differs", image,
                m_slices.render(random.scene, random.size));
  }

  static constexpr double mostLayers = 256.0; // RandomScene::isSliceable

  CpuRenderer m_processor;
  CpuRenderer m_samplingProcessor{0, CpuRenderer::EmptySpace::sampled};
  RayCaster m_caster;
  SliceRenderer m_slices;
  std::string m_description;
};

} // namespace

FuzzReport runFuzz(int seeds, std::uint64_t firstSeed, const std::function<bool(int)>& progress) {
  Fuzzer fuzzer;
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
