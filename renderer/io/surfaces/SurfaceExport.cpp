// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceExport.h"

#include "io/AtomicFile.h"
#include "io/surfaces/SurfaceFile.h"
#include "scene/basics/Error.h"
#include "scene/volume/Volume.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace limn {
namespace {

namespace fs = std::filesystem;

// A file and the surfaces that go into it.
struct FileToWrite {
  fs::path path;
  std::vector<NamedSurface> surfaces;
};

std::string valueName(double value) {
  return Message::rounded(value, 6).english();
}

// Eighty characters fit into the header of an STL, which must not begin with "solid".
std::string descriptionOf(const MadeSurface& made, const std::string& unit) {
  char text[80];
  std::snprintf(text, sizeof text, "Limn surface at %s%s%.8s, mm, axes LPS, within %.3g mm",
                valueName(made.order.isovalue).c_str(), unit.empty() ? "" : " ", unit.c_str(),
                made.error.largest());
  return text;
}

std::vector<FileToWrite> filesOf(const std::vector<MadeSurface>& made, const fs::path& path,
                                 const std::string& unit) {
  std::vector<double> isovalues(made.size());
  std::transform(made.begin(), made.end(), isovalues.begin(),
                 [](const MadeSurface& surface) { return surface.order.isovalue; });
  std::vector<FileToWrite> files;
  for (std::size_t i = 0; const fs::path& file : surfacePaths(path, isovalues)) {
    if (files.empty() || files.back().path != file)
      files.push_back({file, {}});
    files.back().surfaces.push_back(
        {&made[i].mesh, "value_" + valueName(isovalues[i]), descriptionOf(made[i], unit)});
    ++i;
  }
  return files;
}

void writeTo(const fs::path& temporary, const FileToWrite& file, const Progress& progress) {
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  errno = 0;
  writeSurfaces(stream, surfaceFormatOf(file.path), file.surfaces, progress);
  stream.close();
  if (!stream)
    throw Error(Error::Kind::other,
                Message::tr("Cannot write %1: %2; choose another folder or make room.")
                    .arg(file.path.string(),
                         errno != 0 ? Message(std::strerror(errno)) : Message::tr("the disk is full")));
}

// The next file is written before this one takes its place: no name points to a new file until all are
// written.
void writeFrom(std::size_t first, const std::vector<FileToWrite>& files, const Progress& progress) {
  if (first == files.size())
    return;
  const double share = 1.0 / static_cast<double>(files.size());
  replaceAtomically(files[first].path, [&](const fs::path& temporary) {
    writeTo(temporary, files[first],
            part(progress, share * static_cast<double>(first), share * static_cast<double>(first + 1)));
    writeFrom(first + 1, files, progress);
  });
}

void requireDifferent(std::vector<double> isovalues) {
  std::sort(isovalues.begin(), isovalues.end());
  const auto twice = std::adjacent_find(isovalues.begin(), isovalues.end(),
                                        [](double a, double b) { return valueName(a) == valueName(b); });
  if (twice != isovalues.end())
    throw Error(Error::Kind::usage,
                Message::tr("The value %1 was given twice; give each once.").arg(valueName(*twice)));
}

using OrderedJson = nlohmann::ordered_json;

OrderedJson distancesJson(const Distances& distances) {
  return {{"largest", distances.largest}, {"mean", distances.mean}, {"points", distances.points}};
}

OrderedJson surfaceJson(const WrittenSurface& surface) {
  const MadeSurface& made = surface.made;
  return {
      {"value", made.order.isovalue},
      {"file", surface.file.filename().string()},
      {"triangles", made.mesh.triangles.size()},
      {"triangles_before", made.trianglesBefore},
      {"closed", made.order.isClosed},
      {"watertight", made.edges.isWatertight()},
      {"edges_of_holes", made.edges.usedOnce},
      {"edges_used_otherwise", made.edges.usedOtherwise},
      {"volume_mm3", made.edges.isWatertight() ? OrderedJson(made.enclosedMm3) : OrderedJson()},
      {"parts", made.parts},
      {"dropped",
       {{"parts", made.dropped.parts},
        {"hollows", made.dropped.hollows},
        {"volume_mm3", made.dropped.enclosedMm3}}},
      {"tolerance_mm", made.order.toleranceMm > 0.0 ? OrderedJson(made.order.toleranceMm) : OrderedJson()},
      {"distance_mm",
       {{"largest", made.error.largest()},
        {"mesh_to_surface", distancesJson(made.error.ofMesh)},
        {"surface_to_mesh", distancesJson(made.error.ofSurface)}}}};
}

} // namespace

std::vector<fs::path> surfacePaths(const fs::path& path, const std::vector<double>& isovalues) {
  std::vector<fs::path> paths(isovalues.size(), path);
  if (isovalues.size() > 1 && surfaceFormatOf(path) != SurfaceFormat::obj)
    for (std::size_t i = 0; i < paths.size(); ++i)
      paths[i].replace_filename(path.stem().string() + "_" + valueName(isovalues[i]) +
                                path.extension().string());
  return paths;
}

std::vector<WrittenSurface> exportSurfaces(const Scene& scene, const std::vector<SurfaceOrder>& orders,
                                           const fs::path& path, const Progress& progress) {
  surfaceFormatOf(path);
  std::vector<double> isovalues(orders.size());
  std::transform(orders.begin(), orders.end(), isovalues.begin(),
                 [](const SurfaceOrder& order) { return order.isovalue; });
  requireDifferent(isovalues);
  for (const fs::path& file : surfacePaths(path, isovalues))
    requireWritable(file);
  constexpr double shareOfMaking = 0.9;
  std::vector<MadeSurface> made;
  made.reserve(orders.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const double share = shareOfMaking / static_cast<double>(orders.size());
    made.push_back(
        makeSurface(scene, orders[i],
                    part(progress, share * static_cast<double>(i), share * static_cast<double>(i + 1))));
  }
  requireWhole(*scene.volume);
  writeFrom(0, filesOf(made, path, scene.volume->info().unit), part(progress, shareOfMaking, 1.0));
  std::vector<WrittenSurface> written;
  const std::vector<fs::path> paths = surfacePaths(path, isovalues);
  written.reserve(made.size());
  for (std::size_t i = 0; i < made.size(); ++i)
    written.push_back({paths[i], std::move(made[i])});
  return written;
}

std::string surfacesJson(const std::vector<WrittenSurface>& surfaces) {
  OrderedJson list = OrderedJson::array();
  for (const WrittenSurface& surface : surfaces)
    list.push_back(surfaceJson(surface));
  return OrderedJson{{"axes", "LPS"}, {"unit", "mm"}, {"surfaces", list}}.dump(2) + "\n";
}

} // namespace limn
