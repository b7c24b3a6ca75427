// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "io/surfaces/SurfaceMesh.h"

#include <filesystem>
#include <iosfwd>
#include <string>

namespace limn {

/// STL is binary, its 80 bytes of header say units and axes; PLY is binary, least byte first, with normals;
/// OBJ is text, with normals, and holds several surfaces as objects.
enum class SurfaceFormat { stl, ply, obj };

/// By the ending. Throws Error (usage) where it names none.
SurfaceFormat surfaceFormatOf(const std::filesystem::path& path);

/// A surface to be written, and what its file says of it: plain ASCII on one line, nothing of the patient.
struct NamedSurface {
  const SurfaceMesh* mesh = nullptr;
  std::string name;        ///< of the object ("value_300")
  std::string description; ///< units, axes, value, distance
};

/// Writes surfaces, of which STL and PLY take one. The stream fails where the disk is full. Throws Cancelled.
void writeSurfaces(std::ostream& to, SurfaceFormat format, const std::vector<NamedSurface>& surfaces,
                   const Progress& progress);

} // namespace limn
