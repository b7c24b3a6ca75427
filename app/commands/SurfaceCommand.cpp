// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/SceneArguments.h"
#include "app/core/drawing/ProcessCost.h"
#include "io/AtomicFile.h"
#include "io/surfaces/SurfaceExport.h"
#include "io/surfaces/SurfaceFile.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>

namespace limn {
namespace {

struct SurfaceArguments {
  SourceArguments source;
  std::vector<double> values;
  std::string out;
  std::string keep;
  std::vector<double> crop;
  bool isOpen = false;
  double smallestPartMm3 = 0.0;
  double toleranceMm = 0.0;
  int cells = 1;
  bool json = false;
};

volatile std::sig_atomic_t isInterrupted = 0;

// Ctrl-C lets the work end by itself, so that no half-written file stays.
Progress stoppableProgress(bool isQuiet) {
  std::signal(SIGINT, [](int) { isInterrupted = 1; });
  Progress progress = terminalProgress(isQuiet);
  progress.isCancelled = [] { return isInterrupted != 0; };
  return progress;
}

Scene sceneOf(const SurfaceArguments& arguments, const Progress& progress) {
  const LoadedScene loaded = loadScene(arguments.source, progress);
  SceneArguments look;
  look.source = arguments.source;
  look.keep = arguments.keep;
  Scene scene = adjusted(loaded, look);
  if (arguments.crop.empty())
    return scene;
  const std::vector<double>& crop = arguments.crop;
  if (crop.size() == 6)
    scene.crop = {{crop[0], crop[1], crop[2]}, {crop[3], crop[4], crop[5]}};
  if (crop.size() != 6 || !glm::all(glm::lessThan(scene.crop.lower, scene.crop.upper)))
    throw Error(Error::Kind::usage,
                "--crop takes six fractions of the volume, X0,Y0,Z0,X1,Y1,Z1, each first one "
                "smaller than its second, such as 0,0,0.5,1,1,1.");
  return scene;
}

// What is told of a surface on a terminal: how large, how whole, how exact.
void tell(const WrittenSurface& surface) {
  const MadeSurface& made = surface.made;
  std::printf("%s: value %g\n", surface.file.filename().c_str(), made.order.isovalue);
  std::printf("  triangles  %zu", made.mesh.triangles.size());
  if (made.mesh.triangles.size() != made.trianglesBefore)
    std::printf(" of %zu", made.trianglesBefore);
  std::printf(made.parts == 1 ? ", %zu part" : ", %zu parts", made.parts);
  if (made.dropped.parts + made.dropped.hollows > 0)
    std::printf(" (left out: %zu small ones of %.3g mm3 together; filled: %zu hollows)", made.dropped.parts,
                made.dropped.enclosedMm3, made.dropped.hollows);
  if (made.edges.isWatertight())
    std::printf("\n  watertight every edge is used twice; encloses %.6g mm3\n", made.enclosedMm3);
  else
    std::printf("\n  open       %llu edges at the rims of holes, %llu used otherwise than twice\n",
                static_cast<unsigned long long>(made.edges.usedOnce),
                static_cast<unsigned long long>(made.edges.usedOtherwise));
  std::printf(
      "  distance   at most %.3g mm (mean %.2g) from mesh to isosurface, %.3g mm (mean %.2g) back, at %zu "
      "points each\n",
      made.error.ofMesh.largest, made.error.ofMesh.mean, made.error.ofSurface.largest,
      made.error.ofSurface.mean, made.error.ofMesh.points);
}

void noteMissedTolerance(const MadeSurface& made) {
  if (made.order.toleranceMm > 0.0 && made.error.largest() > made.order.toleranceMm) {
    char sentence[200];
    std::snprintf(
        sentence, sizeof sentence,
        "The surface at %g lies up to %.3g mm from the isosurface, more than the %g mm asked for, because "
        "its cells are too coarse there; try --finer.",
        made.order.isovalue, made.error.largest(), made.order.toleranceMm);
    note(sentence);
  }
}

void makeSurfaces(const SurfaceArguments& arguments) {
  for (const std::filesystem::path& file : surfacePaths(arguments.out, arguments.values)) {
    surfaceFormatOf(file);
    requireWritable(file);
  }
  const bool isQuiet = arguments.source.quiet;
  const auto start = std::chrono::steady_clock::now();
  const Progress progress = stoppableProgress(isQuiet);
  const Scene scene = sceneOf(arguments, part(progress, 0.0, 0.1));
  const double budget = 1e6 * arguments.source.memoryMb;
  const std::optional<double> memory =
      budget > 0.0 ? std::optional<double>(budget) : std::optional<double>(freeMemory());
  std::vector<SurfaceOrder> orders;
  for (const double value : arguments.values)
    orders.push_back({value, !arguments.isOpen, arguments.smallestPartMm3, arguments.toleranceMm,
                      arguments.cells, memory});
  const std::vector<WrittenSurface> written =
      exportSurfaces(scene, orders, arguments.out, part(progress, 0.1, 1.0));
  if (progress.report)
    progress.report(1.0, ""); // takes its line away
  if (arguments.json)
    std::cout << surfacesJson(written);
  for (const WrittenSurface& surface : written) {
    if (!arguments.json)
      tell(surface);
    if (!isQuiet)
      noteMissedTolerance(surface.made);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  char line[120];
  std::snprintf(line, sizeof line, "millimetres in patient axes (LPS); %.1f s, reading included",
                seconds.count());
  if (!isQuiet)
    note(line);
}

void runSurface(const SurfaceArguments& arguments) {
  try {
    makeSurfaces(arguments);
  } catch (const Cancelled&) {
    // Now that nothing half-written is left, whoever started the program hears what ended it.
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
  }
}

} // namespace

void addSurfaceCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<SurfaceArguments>();
  CommandSyntax command = root.command(
      "surface", "the isosurface as a mesh to print, in mm and patient axes, with its measured distance");
  addSourceArguments(
      command, arguments->source,
      "volume, DICOM folder, scene or session file, Limn picture, `sample` or `phantom:SPACING`");
  command
      .option("--value", arguments->values, "isovalue, in the volume's unit; several make several surfaces")
      .required();
  command
      .option("-o,--output", arguments->out,
              "OUT.stl, .ply or .obj; several values are objects of one .obj, or files OUT_VALUE.stl")
      .required()
      .file({".stl", ".ply", ".obj"});
  command.flag("--open", arguments->isOpen, "leave the holes where crop, volume or kept region cut");
  command
      .option("--smallest", arguments->smallestPartMm3,
              "leave out parts, and fill hollows, of fewer than so many mm3")
      .within(0.0, 1e12);
  command
      .option("--tolerance", arguments->toleranceMm,
              "take away triangles as far as this distance from the isosurface, in mm, allows")
      .within(1e-6, 1e3);
  command
      .option("--finer", arguments->cells,
              "cells along each axis from a voxel to the next: more follow the field closer")
      .within(1, mostCells);
  command.option("--keep", arguments->keep, "all, or body: without table and holder").words(keepWords);
  command
      .option("--crop", arguments->crop,
              "X0,Y0,Z0,X1,Y1,Z1: the part of the volume, as fractions along its axes")
      .within(0.0, 1.0)
      .separatedByCommas();
  command.flag("--json", arguments->json, "one JSON object on stdout");
  command.footer("Example: limn surface head.nii.gz --value 300 --tolerance 0.2 --smallest 100 -o skull.stl");
  command.runs([arguments] { runSurface(*arguments); });
}

} // namespace limn
