// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measure/bench/Bench.h"

#include "cpu/CpuRenderer.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "slices/SliceRenderer.h"

#include <cassert>

namespace limn {
namespace {

using Contenders = std::vector<std::unique_ptr<Contender>>;

glm::ivec2 sizeOf(const Scene& scene) {
  return {scene.image.width, scene.image.height};
}

std::unique_ptr<Contender> slicesContender(const std::shared_ptr<HeadlessContext>& context) {
  return pictureContender("limn-slices", rendererName(), [context]() -> DrawPicture {
    const auto slices = std::make_shared<SliceRenderer>();
    return [context, slices](const Scene& scene) { return slices->render(scene, sizeOf(scene)); };
  });
}

std::unique_ptr<Contender> referenceContender(int threads) {
  return pictureContender("limn-reference", "double precision", [threads]() -> DrawPicture {
    return [threads](const Scene& scene) { return toImage(renderReference(scene, sizeOf(scene), threads)); };
  });
}

std::unique_ptr<Contender> cpuContender(int threads) {
  return pictureContender("limn-cpu", CpuRenderer(threads).name(), [threads]() -> DrawPicture {
    const auto renderer = std::make_shared<CpuRenderer>(threads);
    return [renderer](const Scene& scene) { return renderer->render(scene, sizeOf(scene)); };
  });
}

// Draws in memory, whatever the driver.
bool needsNoDriver(const Contender& contender) {
  return contender.program() == "limn-reference" || contender.program() == "limn-cpu";
}

void addOwn(Contenders& contenders, const BenchEntries& entries) {
  std::shared_ptr<HeadlessContext> context;
  for (const std::string& engine : entries.engines) {
    if (engine == "reference") {
      contenders.push_back(referenceContender(entries.threads));
      continue;
    }
    if (engine == "cpu") {
      contenders.push_back(cpuContender(entries.threads));
      continue;
    }
    if (!context)
      context = std::make_shared<HeadlessContext>();
    if (engine == "slices") {
      contenders.push_back(slicesContender(context));
      continue;
    }
    assert(engine == "gl");
    contenders.push_back(glContender(context, RayCaster::Programs::specialised));
    if (entries.allEffects)
      contenders.push_back(glContender(context, RayCaster::Programs::allEffects));
  }
}

// The program that draws with VTK lies beside this one.
std::filesystem::path rivalProgram() {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "limn_bench_vtk";
  if (!std::filesystem::exists(program))
    throw Error(Error::Kind::usage, "The program that draws with VTK is not built; build it beside limn "
                                    "(cmake --build build/release --target limn_bench_vtk).");
  return program;
}

void addRivals(Contenders& contenders, const BenchEntries& entries, const std::string& volumePath) {
  for (const std::string mapper : {"gpu", "fixedpoint"}) {
    RivalCommand command{rivalProgram(), {mapper}};
    command.arguments.insert(command.arguments.end(), entries.readOptions.begin(), entries.readOptions.end());
    contenders.push_back(rivalContender("vtk-" + mapper, command, volumePath));
  }
}

void requireOneDriver(const Contenders& contenders) {
  std::string driver;
  for (const auto& contender : contenders) {
    if (needsNoDriver(*contender))
      continue;
    if (!driver.empty() && contender->renderer() != driver)
      throw Error(Error::Kind::openGl, contender->program() + " would draw on " + contender->renderer() +
                                           " and the others on " + driver +
                                           "; times of two drivers must not be compared.");
    driver = contender->renderer();
  }
}

} // namespace

Contenders contendersFor(const BenchEntries& entries, const std::string& volumePath) {
  Contenders contenders;
  addOwn(contenders, entries);
  if (entries.rivals)
    addRivals(contenders, entries, volumePath);
  requireOneDriver(contenders);
  return contenders;
}

} // namespace limn
