// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/surfaces/SurfaceMaker.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limn {

/// A surface that was written.
struct WrittenSurface {
  std::filesystem::path file;
  MadeSurface made;
};

/// Where surfaces of these values go: all into the one OBJ; of STL and PLY a single one into the path itself,
/// several into files beside it with the value in their names ("skull_300.stl").
std::vector<std::filesystem::path> surfacePaths(const std::filesystem::path& path,
                                                const std::vector<double>& isovalues);

/// Makes a surface of each order and writes them: all files complete or none touched. What a file says of
/// itself names nobody. Throws Error, of kind usage where the ending names no format or a value comes twice,
/// as makeSurface does, and Cancelled.
std::vector<WrittenSurface> exportSurfaces(const Scene& scene, const std::vector<SurfaceOrder>& orders,
                                           const std::filesystem::path& path, const Progress& progress = {});

/// What is told of surfaces: one JSON object, as the command line documents it.
std::string surfacesJson(const std::vector<WrittenSurface>& surfaces);

} // namespace limn
