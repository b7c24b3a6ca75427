// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace limn {

/// The metadata (an XMP packet, ISO 16684-1) by which a PDF carries a description, as pictures do in their
/// own fields. `description` is ASCII; the packet stands uncompressed in the file.
std::string pdfMetadata(const std::string& description);

/// Whether a file begins as PDF files do. Never throws.
bool isPdf(const std::filesystem::path& path);

/// The description that a PDF carries by such metadata; empty where it has none, as those of other programs
/// do, or where it is longer than any that Limn writes. Never throws.
std::string readPdfDescription(const std::filesystem::path& path);

} // namespace limn
