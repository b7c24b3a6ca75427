// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/PictureTarget.h"
#include "scene/LabelLooks.h"
#include "scene/volume/Phantom.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"
#include "stability/scenes/SimpleScenes.h"

#include <algorithm>
#include <optional>

namespace limn {
namespace {

constexpr glm::ivec2 pictureSize{32, 32};

Scene phantomScene() {
  static const std::shared_ptr<const Volume> volume = phantomVolume({.spacingMm = 8.0});
  Scene scene = headScene(volume, ShadingModel::robust);
  scene.quality.stepVoxels = 0.5;
  scene.quality.earlyTermination = 0.95;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

// Slices know two projections and one look, and end no ray early.
bool shows(const Scene& scene, Engine engine) {
  return engine != Engine::slices ||
         ((scene.projection == Projection::composite || scene.projection == Projection::xray) &&
          !hasLabelLooks(scene) && scene.quality.earlyTermination == phantomScene().quality.earlyTermination);
}

std::vector<Scene> variedScenes(Engine engine) {
  std::vector<Scene> scenes;
  for (const Variation& variation : everyParameter()) {
    Scene scene = phantomScene();
    variation.apply(scene);
    if (shows(scene, engine))
      scenes.push_back(scene);
  }
  return scenes;
}

// Draws each changed scene after the scene itself, which must look as before, then all changed ones from the
// last to the first. What is kept although it should be made anew shows as no change, as a trace in the scene
// itself, or as a difference between the two orders.
Finding staleParameters(Workbench& bench, Engine engine) {
  const Scene base = phantomScene();
  const DrawnPicture before = bench.draw(engine, base, pictureSize);
  const std::vector<Scene> scenes = variedScenes(engine);
  std::vector<DrawnPicture> forwards;
  std::vector<bool> isStale;
  for (const Scene& scene : scenes) {
    forwards.push_back(bench.draw(engine, scene, pictureSize));
    isStale.push_back(forwards.back() == before || bench.draw(engine, base, pictureSize) != before);
  }
  for (std::size_t i = scenes.size(); i-- > 0;)
    isStale[i] = isStale[i] || bench.draw(engine, scenes[i], pictureSize) != forwards[i];
  return atMost(nameOf(engine), std::to_string(scenes.size()) + " parameters changed in turn",
                static_cast<double>(std::count(isStale.begin(), isStale.end(), true)), 0.0,
                "parameters that do not show, leave a trace in the next picture, or look otherwise after "
                "another picture, by any bit");
}

// A program may stand in that has more effects than a scene needs, at their neutral values.
Finding standIn(Workbench& bench) {
  RayCaster allEffects(RayCaster::EmptySpace::skipped, RayCaster::Programs::allEffects);
  const Scene scene = phantomScene();
  const Image image = allEffects.render(scene, pictureSize);
  return atMost("gl", "a program with every effect compiled in",
                largestDifference(bench.draw(Engine::rayCaster, scene, pictureSize),
                                  {pictureSize, {image.pixels.begin(), image.pixels.end()}}),
                4e-7,
                "largest difference from the scene's own program: none here, but drivers may fuse a product "
                "and a sum in one of the two");
}

std::vector<Finding> staleCaches(Workbench& bench) {
  const auto stale = [&bench](Engine engine) {
    return withOpenGl(bench, nameOf(engine), "parameters changed in turn",
                      [&] { return staleParameters(bench, engine); });
  };
  return {notApplicable("reference", "parameters changed in turn",
                        "The reference keeps nothing from one picture to the next."),
          stale(Engine::rayCaster), stale(Engine::slices), staleParameters(bench, Engine::cpu),
          withOpenGl(bench, "gl", "a program with every effect compiled in", [&] { return standIn(bench); })};
}

// Cubes of two voxels, wide apart, on both sides of the borders of the blocks that are skipped and across
// them.
std::shared_ptr<const Volume> sparseVolume() {
  const Grid grid = centredGrid({33, 26, 23}, {1.0, 0.7, 1.6});
  return volumeOf(grid, [](int i, int j, int k) {
    const int n = (i + 1) / 2 + 17 * ((j + 1) / 2 + 14 * (k / 2));
    return i + j + k == 0 ? 0.0 : n % 457 == 5 || n % 641 == 128 ? 200.0 : 10.0;
  });
}

struct Emptiness {
  const char* what;
  Scene scene;
};

std::vector<Emptiness> emptyScenes() {
  std::vector<Emptiness> scenes;
  for (const auto& [what, lowest, direction] :
       {std::tuple{"small cubes along an axis", 50.0, glm::dvec3(0, 1, 0)},
        {"small cubes, oblique", 50.0, glm::dvec3(0.6, 0.64, 0.48)},
        {"the tips of small cubes", 185.0, glm::dvec3(0.6, 0.64, 0.48)}}) {
    scenes.push_back({what, wholeVolume(sparseVolume(), ShadingModel::enhanced, lowest, 200.0, direction)});
    scenes.back().scene.quality.stepVoxels = 0.3;
  }
  Scene head = phantomScene();
  head.shading.model = ShadingModel::classic;
  head.crop = {{0.1, 0.3, 0.0}, {0.8, 1.0, 0.9}};
  head.quality.jitter = true;
  scenes.push_back({"a head, cropped and jittered", head});
  head.quality.jitter = false;
  head.quality.preintegrated = Preintegration::always;
  scenes.push_back({"a head in exact steps", head});
  head.quality.preintegrated = Preintegration::never;
  head.quality.toleranceLevels = 1.0;
  head.quality.fineness = 4;
  scenes.push_back({"a head in error-controlled steps", head});
  head.quality.toleranceLevels.reset();
  head.projection = Projection::compositeIsosurface;
  head.isovalue = 250.0;
  scenes.push_back({"a head up to a surface", head});
  head.projection = Projection::xray;
  scenes.push_back({"an X-ray", head});
  return scenes;
}

std::vector<Finding> emptySpace(Workbench& bench) {
  const std::string reason = "largest difference between stepping over empty blocks and sampling them: none";
  std::optional<RayCaster> sampling;
  if (bench.hasOpenGl())
    sampling.emplace(RayCaster::EmptySpace::sampled);
  CpuRenderer samplingProcessor(0, CpuRenderer::EmptySpace::sampled);
  std::vector<Finding> findings;
  for (const Emptiness& one : emptyScenes()) {
    const auto compared = [&](Engine engine, const Image& sampled) {
      const DrawnPicture skipped = bench.draw(engine, one.scene, pictureSize);
      const DrawnPicture whole{pictureSize, {sampled.pixels.begin(), sampled.pixels.end()}};
      return atMost(nameOf(engine), one.what, largestDifference(skipped, whole), 0.0, reason);
    };
    findings.push_back(withOpenGl(bench, "gl", one.what, [&] {
      return compared(Engine::rayCaster, sampling->render(one.scene, pictureSize));
    }));
    findings.push_back(compared(Engine::cpu, samplingProcessor.render(one.scene, pictureSize)));
  }
  findings.push_back(withOpenGl(bench, "gl", "something is skipped at all", [&bench] {
    return atMost("gl", "something is skipped at all",
                  bench.rays().plan(phantomScene()).effects.has(Effect::emptySpaceSkipping) ? 0.0 : 1.0, 0.0,
                  "1 where the head is drawn without stepping over anything");
  }));
  for (const char* engine : {"reference", "slices"})
    findings.push_back(notApplicable(engine, "", "It steps over nothing: every sample is taken."));
  return findings;
}

// The picture put together from tiles, by so many threads.
Image inTiles(int threads, const Scene& scene, const glm::ivec2& size, const glm::ivec2& tile) {
  CpuRenderer renderer(threads);
  Image whole(size);
  for (int y = 0; y < size.y; y += tile.y)
    for (int x = 0; x < size.x; x += tile.x) {
      const PixelRect part{{x, y}, glm::min(tile, size - glm::ivec2(x, y))};
      const Image drawn = renderer.draw(scene, size, part);
      for (int row = 0; row < part.size.y; ++row)
        std::copy_n(&drawn.at(0, row), part.size.x, &whole.at(x, y + row));
    }
  return whole;
}

// The picture drawn tile by tile into one framebuffer.
Image inTiles(RayCaster& caster, const Scene& scene, const glm::ivec2& size, const glm::ivec2& tile) {
  const FloatTarget target(size);
  for (int y = 0; y < size.y; y += tile.y)
    for (int x = 0; x < size.x; x += tile.x)
      caster.draw(scene, size, {{x, y}, glm::min(tile, size - glm::ivec2(x, y))});
  return readBack(size);
}

std::vector<Finding> tiles(Workbench& bench) {
  constexpr glm::ivec2 size{70, 50};
  Scene jittered = phantomScene();
  jittered.quality.jitter = true;
  std::vector<Finding> findings;
  for (const auto& [what, scene] :
       {std::pair{"a head in tiles", phantomScene()}, {"a jittered head in tiles", jittered}}) {
    const glm::ivec2 tilings[] = {{7, 50}, {64, 64}, {13, 11}, {70, 1}};
    findings.push_back(withOpenGl(bench, "gl", what, [&, &scene = scene, what = what] {
      const Image whole = bench.rays().render(scene, size);
      int different = 0;
      for (const glm::ivec2& tile : tilings)
        different += inTiles(bench.rays(), scene, size, tile) != whole;
      return atMost("gl", what, different, 0.0,
                    "tilings of four that differ from the whole picture by any bit");
    }));
    const Image whole = bench.processor().render(scene, size);
    int different = 0, threads = 1;
    for (const glm::ivec2& tile : tilings)
      different += inTiles(threads++, scene, size, tile) != whole;
    findings.push_back(atMost("cpu", what, different, 0.0,
                              "tilings of four, with one to four threads, that differ by any bit"));
  }
  findings.push_back(
      notApplicable("reference", "", "It runs on the processor, where no driver waits for it."));
  findings.push_back(notApplicable(
      "slices", "",
      "They are handed to the driver one slice at a time, of which each is one sample a pixel."));
  return findings;
}

} // namespace

std::vector<HardCase> reuseCases() {
  return {
      {"H34", "A change of any parameter shows at once and whole, whatever was drawn before", staleCaches},
      {"H35", "Stepping over empty space changes no bit", emptySpace},
      {"H46", "Pictures drawn in tiles, which no watchdog ends, equal whole ones to the bit", tiles}};
}

} // namespace limn
