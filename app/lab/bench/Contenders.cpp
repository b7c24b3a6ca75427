// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/bench/Bench.h"

#include "app/core/drawing/OnDisk.h"
#include "cpu/CpuRenderer.h"
#include "gl/DriverHealth.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "slices/SliceRenderer.h"

#include <algorithm>
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
    return [context, slices](const Scene& scene) {
      requireOpenGlMayCopy(scene);
      return slices->render(scene, sizeOf(scene));
    };
  });
}

std::unique_ptr<Contender> referenceContender(int threads) {
  return pictureContender("limn-reference", "double precision", [threads]() -> DrawPicture {
    return [threads](const Scene& scene) { return toImage(renderReference(scene, sizeOf(scene), threads)); };
  });
}

std::unique_ptr<Contender> cpuContender(int threads) {
  return pictureContender("limn-cpu", CpuRenderer(threads).name(), [threads]() -> DrawPicture {
    const auto renderer = std::make_shared<CpuRenderer>(threads, CpuRenderer::Tolerance::stepsFirst);
    return [renderer](const Scene& scene) { return renderer->render(scene, sizeOf(scene)); };
  });
}

// Where renderers get their context: made once, when the first asks for it, or refused to all with one
// sentence.
class SharedContext {
public:
  bool isThere() {
    if (!m_context && m_problem.empty())
      make();
    return m_context != nullptr;
  }

  const std::shared_ptr<HeadlessContext>& context() const { return m_context; }
  const std::string& problem() const { return m_problem; }

private:
  void make() {
    try {
      auto context = std::make_shared<HeadlessContext>();
      requireOpenGl3();
      m_context = std::move(context);
    } catch (const Error& error) {
      m_problem = error.what();
    }
  }

  std::shared_ptr<HeadlessContext> m_context;
  std::string m_problem;
};

// The program that draws with VTK lies beside this one.
std::filesystem::path rivalProgram() {
  std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "limn_bench_vtk";
  if (!std::filesystem::exists(program))
    throw Error(Error::Kind::usage, "The program that draws with VTK is not built; build it beside limn "
                                    "(cmake --build build/release --target limn_bench_vtk).");
  return program;
}

std::unique_ptr<Contender> vtkContender(const std::string& engine, const BenchEntries& entries,
                                        const std::string& volumePath) {
  RivalCommand command{rivalProgram(), {engine == "vtk-gpu" ? "gpu" : "fixedpoint"}};
  command.arguments.insert(command.arguments.end(), entries.readOptions.begin(), entries.readOptions.end());
  return rivalContender(engine, command, volumePath);
}

void addWithOpenGl(Contenders& contenders, const std::string& engine, bool allEffects,
                   SharedContext& shared) {
  if (!shared.isThere()) {
    contenders.push_back(absentContender("limn-" + engine, shared.problem()));
    return;
  }
  if (engine == "slices") {
    contenders.push_back(slicesContender(shared.context()));
    return;
  }
  assert(engine == "gl");
  contenders.push_back(glContender(shared.context(), RayCaster::Programs::specialised));
  if (allEffects)
    contenders.push_back(glContender(shared.context(), RayCaster::Programs::allEffects));
}

// Draws in memory, whatever the driver, or not at all.
bool needsNoDriver(const Contender& contender) {
  return contender.program() == "limn-reference" || contender.program() == "limn-cpu" ||
         contender.renderer().empty();
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
  SharedContext shared;
  for (const std::string& engine : entries.engines)
    if (engine == "reference")
      contenders.push_back(referenceContender(entries.threads));
    else if (engine == "cpu")
      contenders.push_back(cpuContender(entries.threads));
    else if (engine.starts_with("vtk-"))
      contenders.push_back(vtkContender(engine, entries, volumePath));
    else
      addWithOpenGl(contenders, engine, entries.allEffects, shared);
  const bool hasOwn = std::ranges::any_of(contenders, [](const auto& one) {
    return one->program().starts_with("limn-") && !one->renderer().empty();
  });
  if (!hasOwn && !shared.problem().empty())
    contenders.push_back(cpuContender(entries.threads));
  requireOneDriver(contenders);
  return contenders;
}

} // namespace limn
