// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "io/reading/VoxelKeeping.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace limn {

/// The text of a NRRD header: its fields by lower-case name, keys, and where the voxels start in an attached
/// file.
struct NrrdHeader {
  std::map<std::string, std::string> fields;
  std::map<std::string, std::string> keys; ///< what programs added ("key:=value"), by its name as written
  std::uint64_t end = 0;                   ///< bytes of header, the blank line included

  /// The value of a field; empty where it is absent.
  std::string field(const std::string& name) const;
};

/// Whether the bytes start as a NRRD file does.
bool isNrrd(std::string_view bytes);

/// Reads the header of a NRRD or NHDR file. Throws Error where it is damaged or longer than 1 MiB.
/// Source: teem.sourceforge.net/nrrd/format.html.
NrrdHeader readNrrdHeader(const std::filesystem::path& file);

/// Reads a NRRD volume, attached (.nrrd) or detached (.nhdr), raw, gzip or text. Three spatial axes (two
/// make one slice), before them at most an axis of colours, after them further volumes of which the first
/// is read with a warning. Throws Error; Cancelled.
VolumeParts readNrrd(const std::filesystem::path& path, const VoxelKeeping& keeping,
                     const Progress& progress);

} // namespace limn
