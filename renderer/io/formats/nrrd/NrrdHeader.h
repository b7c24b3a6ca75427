// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace limn {

/// The text of a NRRD header: its fields by lower-case name, and where the voxels start in an attached file.
struct NrrdHeader {
  std::map<std::string, std::string> fields;
  std::uint64_t end = 0; ///< bytes of header, the blank line included

  /// The value of a field; empty where it is absent.
  std::string field(const std::string& name) const;
};

/// Whether the bytes start as a NRRD file does.
bool isNrrd(std::string_view bytes);

/// Reads the header of a NRRD or NHDR file. Throws Error where it is damaged or longer than 1 MiB.
/// Source: teem.sourceforge.net/nrrd/format.html.
NrrdHeader readNrrdHeader(const std::filesystem::path& file);

} // namespace limn
