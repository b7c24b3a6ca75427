// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Bytes.h"

#include <string>

namespace limn {

/// The elements of a VTK XML file without the values between them, which may be long: where text stood, its
/// place in the file stands instead, as two numbers (offset and length).
struct VtkXmlText {
  std::string xml;            ///< up to the appended bytes, which are no XML, or to the end
  std::uint64_t appended = 0; ///< where the appended bytes start; 0 where there are none
  bool appendedIsBase64 = false;
};

/// Reads the elements of a file. Throws Error where they are no XML or longer than any in use.
VtkXmlText readVtkXmlText(const std::filesystem::path& file);

/// A run of bytes of a file.
struct VtkXmlRun {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
};

/// The place that stands in an element instead of its text; empty where the element had none.
VtkXmlRun runOf(const std::string& placeText);

/// The bytes of a run.
ByteReader bytesOfRun(const std::filesystem::path& file, const VtkXmlRun& run);

} // namespace limn
