// SPDX-License-Identifier: GPL-3.0-or-later
// limn-mpi: what `limn render` draws, by many processes on one machine or many (README.md).
#include "app/commands/CommandLine.h"
#include "app/commands/RenderWork.h"
#include "app/commands/Syntax.h"
#include "app/commands/mpi/SharedDrawing.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/core/sources/KeptRegion.h"
#include "io/reading/PartWanted.h"
#include "io/scenefile/SceneFile.h"

#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>
#include <thread>

namespace limn {
namespace {

struct MpiArguments {
  RenderArguments render;
  bool printsCost = false;
};

// What the first rank asks of all, as a text: to tell what they found of their voxels when they read the
// volume, to count them in so many bins, to tell which show in a scene, to draw a scene in so many pixels, or
// to end with an exit status.
struct Request {
  enum class Kind { voxels, bins, visible, picture, end };
  Kind kind = Kind::end;
  int number = 0; // of bins, or the exit status
  glm::ivec2 size{0};
  std::string scene;
};

Request requested(const Ranks& ranks, const Request& request) {
  std::ostringstream written;
  written << static_cast<int>(request.kind) << ' ' << request.number << ' ' << request.size.x << ' '
          << request.size.y << '\n'
          << request.scene;
  std::istringstream told(ranks.fromFirst(written.str()));
  Request result;
  int kind = 0;
  told >> kind >> result.number >> result.size.x >> result.size.y;
  result.kind = static_cast<Request::Kind>(kind);
  told.get();
  result.scene.assign(std::istreambuf_iterator<char>(told), {});
  return result;
}

VoxelFacts factsOfAll(const Ranks& ranks, const VoxelFacts& own) {
  return ofAll<VoxelFacts>(ranks, [&] { return own; });
}

void requireRanksCanDraw(const RenderArguments& arguments) {
  if (arguments.engine != "auto" && arguments.engine != "cpu")
    throw Error(Error::Kind::usage, "Ranks draw with the CPU engine; leave --engine away or say cpu.");
  if (arguments.printsFigures || !arguments.samplesSpent.empty() || arguments.textureMb != anyMb)
    throw Error(
        Error::Kind::usage,
        "Ranks draw pictures alone; --figures, --samples-spent and --texture-mb are for limn render.");
}

// Scenes come from the first rank, their volume from this rank's own look at the file: at its part of it
// where that can be read in parts.
class OwnScenes {
public:
  OwnScenes(SourceArguments source, PartWanted part, const Ranks& ranks) {
    part.joined = [&](const VoxelFacts& own) {
      Request request = requested(ranks, {});
      if (request.kind != Request::Kind::voxels) {
        m_pending = std::move(request); // the first rank found no parts, or nothing
        throw otherVolume();
      }
      return factsOfAll(ranks, own);
    };
    if (source.part)
      source.part = std::make_shared<const PartWanted>(std::move(part));
    SourceOptions options = sourceOptions(source);
    options.wantsVolumeAlone = true;
    m_failure = failureOf([&] { m_volume = loadScene(source.source, options, {}).scene.volume; });
  }

  /// What the first rank asks for next.
  Request next(const Ranks& ranks) {
    if (!m_pending)
      return requested(ranks, {});
    const Request request = std::move(*m_pending);
    m_pending.reset();
    return request;
  }

  /// The volume, of which the first rank holds a part.
  const Volume& inParts() const {
    requireVolume();
    if (!m_volume->part())
      throw otherVolume();
    return *m_volume;
  }

  Scene of(const std::string& json) {
    requireVolume();
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

  static Error otherVolume() {
    return Error(Error::Kind::input, "A rank found another volume than the first one at the same path; give "
                                     "all of them the same files.");
  }

private:
  void requireVolume() const {
    if (m_failure)
      throw *m_failure;
  }

  std::optional<Error> m_failure;
  std::optional<Request> m_pending;
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

// What this rank reads of a volume, in its part of the machine's memory unless so much was given.
PartWanted partOf(const SourceArguments& source, const Ranks& ranks) {
  PartWanted part;
  part.share = [&ranks](const Grid& grid, bool inSlices) { return shareOf(ranks, grid, inSlices); };
  const auto neighbours = static_cast<std::uint64_t>(ranks.onThisMachine());
  part.memory = source.memoryMb > 0.0 ? MemoryBudget(static_cast<std::uint64_t>(1e6 * source.memoryMb))
                                      : MemoryBudget(MemoryBudget().bytes() / neighbours);
  return part;
}

// Runs the command as `limn render` does, but for who looks at voxels and who draws.
int lead(MpiArguments arguments, PartWanted part, const Ranks& ranks, SharedDrawing& drawing) {
  part.joined = [&](const VoxelFacts& own) {
    requested(ranks, {Request::Kind::voxels, 0, {}, {}});
    return factsOfAll(ranks, own);
  };
  part.binCounts = [&](const Volume& volume, int mostBins) {
    requested(ranks, {Request::Kind::bins, mostBins, {}, {}});
    return ofAll<BinCounts>(ranks, [&] { return countsOfOwn(volume, mostBins); });
  };
  part.visible = [&](const Scene& scene, int unitVoxels) {
    requested(ranks, {Request::Kind::visible, unitVoxels, {}, sceneToJson(scene, "volume")});
    return ofAll<VisibleVoxels>(ranks, [&] { return visibleOfOwn(scene, unitVoxels); });
  };
  if (arguments.render.scene.source.part)
    arguments.render.scene.source.part = std::make_shared<const PartWanted>(std::move(part));
  const auto draw = [&](const Scene& scene, const glm::ivec2& size) {
    requested(ranks, {Request::Kind::picture, 0, size, sceneToJson(scene, "volume")});
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
  requested(ranks, {Request::Kind::end, status, {}, {}});
  return status;
}

// Gives this rank's share of the answer.
void answer(const Request& request, OwnScenes& scenes, const Ranks& ranks, SharedDrawing& drawing) {
  switch (request.kind) {
  case Request::Kind::voxels: // of a volume that this rank could not read, or not in parts
    ranks.agree(failureOf([&] {
      scenes.inParts();
      throw OwnScenes::otherVolume();
    }));
    break;
  case Request::Kind::bins:
    ofAll<BinCounts>(ranks, [&] { return countsOfOwn(scenes.inParts(), request.number); });
    break;
  case Request::Kind::visible:
    ofAll<VisibleVoxels>(ranks, [&] {
      scenes.inParts();
      return visibleOfOwn(scenes.of(request.scene), request.number);
    });
    break;
  case Request::Kind::picture:
    drawing.draw([&] { return scenes.of(request.scene); }, request.size);
    break;
  case Request::Kind::end:
    break;
  }
}

// Does what the first rank asks for until it ends; what fails is the first rank's to tell.
int follow(const MpiArguments& arguments, const PartWanted& part, const Ranks& ranks,
           SharedDrawing& drawing) {
  OwnScenes scenes(arguments.render.scene.source, part, ranks);
  for (;;) {
    const Request request = scenes.next(ranks);
    if (request.kind == Request::Kind::end)
      return request.number;
    try {
      answer(request, scenes, ranks, drawing);
    } catch (const Error&) {
    }
  }
}

void printCost(const Ranks& ranks, const RankCost& cost) {
  const std::vector<double> all =
      ranks.gathered({cost.samples, cost.ownMb, cost.foldedBytes, bytesRead(), cost.addedMb});
  for (std::size_t i = 0; i + 4 < all.size(); i += 5)
    std::printf("rank %zu: %.0f samples in its brick, %.1f MB of its own, %.0f bytes folded, %.0f read, "
                "took %.1f MB at most\n",
                i / 5, all[i], all[i + 1], all[i + 2], all[i + 3], all[i + 4]);
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
             "also print for each rank its samples, its own memory, the bytes that it gave to be folded and "
             "asked the system to read, and the most memory that it took at a time");
  words.footer("Example: mpirun -n 4 limn-mpi head.nii.gz --size 1200x1200 -o head.png");
  if (const std::optional<int> status = program.run(argc, argv))
    return *status;
  const PartWanted part = partOf(arguments.render.scene.source, ranks);
  if (ranks.count() > 1)
    arguments.render.scene.source.part = std::make_shared<const PartWanted>(part);
  // What must be read whole (README.md) lies on the disk, not in the memory of each.
  if (double& memoryMb = arguments.render.scene.source.memoryMb; memoryMb <= 0.0)
    memoryMb = MemoryBudget::least / 1e6;
  SharedDrawing drawing(ranks, threadsOf(arguments.render, ranks));
  const int status =
      ranks.isFirst() ? lead(arguments, part, ranks, drawing) : follow(arguments, part, ranks, drawing);
  if (arguments.printsCost && status == 0)
    printCost(ranks, drawing.cost());
  return status;
}

} // namespace
} // namespace limn

int main(int argc, char** argv) {
  // Ranks share a machine's memory: what one of them frees goes back to the system at once.
  mallopt(M_TRIM_THRESHOLD, 1 << 16);
  mallopt(M_TOP_PAD, 0);
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
