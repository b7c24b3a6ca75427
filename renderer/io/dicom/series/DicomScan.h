// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomHeader.h"
#include "io/reading/Progress.h"

#include <filesystem>

namespace limn {

/// The images found under a path.
struct DicomScan {
  std::vector<DicomHeader> images;
  int withoutImage = 0; ///< DICOM objects that hold no image: reports, plans, indices
  /// The names of files that must have been images: those whose header cannot be read or ends before the
  /// picture, and those that do not start as DICOM but are called as the images are.
  std::vector<std::string> damaged;
};

/// The regular files under a folder and its subfolders, sorted by path; links to folders are not followed,
/// and folders of the kernel such as /proc not entered. Throws Error (input) where there are more than a
/// study ever holds.
std::vector<std::filesystem::path> filesUnder(const std::filesystem::path& folder);

/// Reads the headers of a file or of all DICOM files under a folder; for a DICOMDIR, under the folder that
/// holds it. What is not DICOM, and is not called as the images are, is passed over. Reports fractions 0..1.
/// Throws Error (input) where a single file is no DICOM or damaged; Cancelled.
DicomScan scanDicom(const std::filesystem::path& path, const Progress& progress);

/// Whether a folder shows the state of the kernel (/proc, /sys and the like) rather than files on a disk: its
/// files announce lengths that they do not have, and reading some of them has effects.
bool isPseudoFolder(const std::filesystem::path& folder);

} // namespace limn
