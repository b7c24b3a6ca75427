// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcfilefo.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

// DICOM objects as bytes, by DCMTK; for this folder only.

namespace limn::dicom {

/// Reads the attributes of an object. Throws Error (input) where it is no DICOM file, truncated, or
/// compressed as a whole.
std::unique_ptr<DcmDataset> objectIn(std::string_view bytes, const std::string& name);

/// What a file says before its pixels. Throws Error (input).
std::unique_ptr<DcmFileFormat> headerOfFile(const std::filesystem::path& file);

/// An object as a file in Explicit VR Little Endian. Throws Error (other).
std::string bytesOf(DcmFileFormat& object);

} // namespace limn::dicom
