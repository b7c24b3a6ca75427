// SPDX-License-Identifier: GPL-3.0-or-later
// limn-mpi: what `limn render` draws, by many processes on one machine or many (README.md).
#include "app/commands/CommandLine.h"
#include "app/commands/RenderWork.h"
#include "app/commands/Syntax.h"
#include "app/commands/mpi/SharedDrawing.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/core/sources/KeptRegion.h"
#include "io/scenefile/SceneFile.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <thread>

namespace limn {
namespace {

struct MpiArguments {
  RenderArguments render;
  bool printsCost = false;
};

// What the first rank asks of all, as a text: a scene to draw in so many pixels, or the end with its exit
// status.
struct Request {
  bool isEnd = false;
  int status = 0;
  glm::ivec2 size{0};
  std::string scene;
};

Request requested(const Ranks& ranks, const Request& request) {
  std::ostringstream written;
  written << request.isEnd << ' ' << request.status << ' ' << request.size.x << ' ' << request.size.y << '\n'
          << request.scene;
  std::istringstream told(ranks.fromFirst(written.str()));
  Request result;
  told >> result.isEnd >> result.status >> result.size.x >> result.size.y;
  told.get();
  result.scene.assign(std::istreambuf_iterator<char>(told), {});
  return result;
}

void requireRanksCanDraw(const RenderArguments& arguments) {
  if (arguments.engine != "auto" && arguments.engine != "cpu")
    throw Error(Error::Kind::usage, "Ranks draw with the CPU engine; leave --engine away or say cpu.");
  if (arguments.printsFigures || !arguments.samplesSpent.empty() || arguments.textureMb != anyMb)
    throw Error(
        Error::Kind::usage,
        "Ranks draw pictures alone; --figures, --samples-spent and --texture-mb are for limn render.");
}

// Scenes come from the first rank, their volume from this rank's own look at the file.
class OwnScenes {
public:
  explicit OwnScenes(const SourceArguments& source) {
    m_failure =
        failureOf([&] { m_volume = loadScene(source.source, sourceOptions(source), {}).scene.volume; });
  }

  Scene of(const std::string& json) {
    if (m_failure)
      throw *m_failure;
    const SceneDocument document = parseScene(json, "the scene of the first rank");
    Scene scene = document.scene;
    scene.volume = m_volume;
    if (m_keep != document.keep) {
      m_kept = regionOf(document.keep, *m_volume).region;
      m_keep = document.keep;
    }
    scene.keep = m_kept;
    return scene;
  }

private:
  std::optional<Error> m_failure;
  std::shared_ptr<const Volume> m_volume;
  KeptPart m_keep;
  Region m_kept;
};

int threadsOf(const RenderArguments& arguments, const Ranks& ranks) {
  const int neighbours = ranks.onThisMachine();
  if (arguments.threads > 0)
    return arguments.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / neighbours);
}

// Runs the command as `limn render` does, but for who draws.
int lead(const MpiArguments& arguments, const Ranks& ranks, SharedDrawing& drawing) {
  const auto draw = [&](const Scene& scene, const glm::ivec2& size) {
    requested(ranks, {false, 0, size, sceneToJson(scene, "volume")});
    return drawing.draw([&] { return scene; }, size);
  };
  const std::string name = "the CPU engine of " + std::to_string(ranks.count()) + " ranks";
  const int status = statusOf([&] {
    requireRanksCanDraw(arguments.render);
    runRender(arguments.render, [&](const std::vector<Scene>& scenes, const glm::ivec2& size) {
      std::vector<MadePicture> pictures;
      for (const Scene& scene : scenes) {
        pictures.push_back(pictureDrawnBy(draw, scene, size, name));
        if (!drawing.limitation().empty())
          pictures.back().notes.push_back(drawing.limitation());
      }
      return pictures;
    });
    return 0;
  });
  requested(ranks, {true, status, {}, {}});
  return status;
}

// Draws what the first rank asks for until it ends; what fails is the first rank's to tell.
int follow(const MpiArguments& arguments, const Ranks& ranks, SharedDrawing& drawing) {
  OwnScenes scenes(arguments.render.scene.source);
  for (;;) {
    const Request request = requested(ranks, {});
    if (request.isEnd)
      return request.status;
    try {
      drawing.draw([&] { return scenes.of(request.scene); }, request.size);
    } catch (const Error&) {
    }
  }
}

void printCost(const Ranks& ranks, const RankCost& cost) {
  const std::vector<double> all = ranks.gathered({cost.samples, cost.ownMb, cost.foldedBytes});
  for (std::size_t i = 0; i + 2 < all.size(); i += 3)
    std::printf("rank %zu: %.0f samples in its brick, %.1f MB of its own, %.0f bytes folded\n", i / 3, all[i],
                all[i + 1], all[i + 2]);
}

int run(int argc, char** argv, const Ranks& ranks) {
  nameProgram();
  ProgramSyntax program(
      "limn-mpi",
      "limn-mpi draws what `limn render` draws on many machines: mpirun starts its ranks, each "
      "draws a part of the volume, the first writes the picture. Not for diagnosis.",
      versionOfProgram());
  MpiArguments arguments;
  CommandSyntax words = program.words();
  addRenderOptions(words, arguments.render);
  words.flag("--cost", arguments.printsCost,
             "also print for each rank its samples, its own memory, and the bytes that it gave to be folded");
  words.footer("Example: mpirun -n 4 limn-mpi head.nii.gz --size 1200x1200 -o head.png");
  if (const std::optional<int> status = program.run(argc, argv))
    return *status;
  // Ranks of one machine share the pages of a file, but no memory of their own.
  if (double& memoryMb = arguments.render.scene.source.memoryMb; memoryMb <= 0.0)
    memoryMb = MemoryBudget::least / 1e6;
  SharedDrawing drawing(ranks, threadsOf(arguments.render, ranks));
  const int status = ranks.isFirst() ? lead(arguments, ranks, drawing) : follow(arguments, ranks, drawing);
  if (arguments.printsCost && status == 0)
    printCost(ranks, drawing.cost());
  return status;
}

} // namespace
} // namespace limn

int main(int argc, char** argv) {
  const limn::Ranks ranks(argc, argv);
  // One voice: the first rank's.
  if (!ranks.isFirst() &&
      (!std::freopen("/dev/null", "w", stdout) || !std::freopen("/dev/null", "w", stderr)))
    return 1;
  int status = 1;
  // What fails on one rank alone, which no rank waits for, must not leave the others waiting.
  if (const auto failure = limn::failureOf([&] { status = limn::run(argc, argv, ranks); })) {
    std::fprintf(stderr, "%s\n", failure->what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  return status;
}
