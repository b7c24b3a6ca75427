// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/SceneArguments.h"
#include "app/core/drawing/ProcessCost.h"
#include "io/AtomicFile.h"
#include "io/labels/LabelReader.h"
#include "io/surfaces/LabelSurfaces.h"
#include "io/surfaces/SurfaceFile.h"
#include "scene/volume/Orientation.h"

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
  std::string labels;
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
void tell(const WrittenSurface& surface, const std::string& what) {
  const MadeSurface& made = surface.made;
  std::printf("%s: %s\n", surface.file.filename().c_str(), what.c_str());
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

// The surfaces that were written, and what each is.
struct Written {
  std::vector<WrittenSurface> surfaces;
  std::vector<std::string> what;
};

Written writeValues(const Scene& scene, const std::vector<double>& values, SurfaceOrder order,
                    const std::string& out, const Progress& progress) {
  std::vector<SurfaceOrder> orders;
  Written written;
  for (const double value : values) {
    order.isovalue = value;
    orders.push_back(order);
    char what[40];
    std::snprintf(what, sizeof what, "value %g", value);
    written.what.emplace_back(what);
  }
  written.surfaces = exportSurfaces(scene, orders, out, progress);
  return written;
}

Written writeLabels(const Scene& scene, const SurfaceArguments& arguments, const SurfaceOrder& order,
                    const Progress& progress) {
  const Segmentation labels = readSegmentation(arguments.labels, gridOfFile(*scene.volume),
                                               part(progress, 0.0, 0.2), scene.volume->info().patient);
  if (!labels.remark.empty() && !arguments.source.quiet)
    note(labels.remark.english());
  const std::vector<LabelSurface> surfaces = labelSurfaces(labels.region, arguments.out);
  if (surfaces.empty())
    throw Error(Error::Kind::input, arguments.labels + " has no label but the background where the volume "
                                                       "is; choose the segmentation of this volume.");
  Written written{
      exportLabelSurfaces(labels.region, scene.volume->grid(), surfaces, order, part(progress, 0.2, 1.0)),
      {}};
  for (const LabelSurface& surface : surfaces)
    written.what.push_back(surface.name);
  return written;
}

void requireOneKind(const SurfaceArguments& arguments) {
  if (arguments.values.empty() == arguments.labels.empty())
    throw Error(Error::Kind::usage, "Give --value for the surface of a value, or --labels for one of each "
                                    "label of a segmentation.");
  if (!arguments.labels.empty() && (!arguments.keep.empty() || !arguments.crop.empty()))
    throw Error(Error::Kind::usage,
                "--labels makes the surface of whole labels; leave --keep and --crop out.");
}

void makeSurfaces(const SurfaceArguments& arguments) {
  requireOneKind(arguments);
  for (const std::filesystem::path& file :
       surfacePaths(arguments.out, arguments.values.empty() ? std::vector{0.5} : arguments.values)) {
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
  const SurfaceOrder order{
      0.0, !arguments.isOpen, arguments.smallestPartMm3, arguments.toleranceMm, arguments.cells, memory};
  const Progress making = part(progress, 0.1, 1.0);
  const Written written = arguments.labels.empty()
                              ? writeValues(scene, arguments.values, order, arguments.out, making)
                              : writeLabels(scene, arguments, order, making);
  if (progress.report)
    progress.report(1.0, ""); // takes its line away
  if (arguments.json)
    std::cout << surfacesJson(written.surfaces);
  for (std::size_t n = 0; n < written.surfaces.size(); ++n) {
    if (!arguments.json)
      tell(written.surfaces[n], written.what[n]);
    if (!isQuiet)
      noteMissedTolerance(written.surfaces[n].made);
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
  command.option("--value", arguments->values,
                 "isovalue, in the volume's unit; several make several surfaces");
  command
      .option("--labels", arguments->labels,
              "segmentation of the volume, a file or a folder of masks: a surface of each label instead")
      .file();
  command
      .option("-o,--output", arguments->out,
              "OUT.stl, .ply or .obj; several values are objects of one .obj, or files OUT_VALUE.stl; labels "
              "are files OUT_LABEL.stl")
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
