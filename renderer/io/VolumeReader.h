// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Volume.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// How long work reports and is stopped. Both functions may be empty and are called from the worker thread.
struct Progress {
  std::function<void(double fraction, const std::string& what)> report; ///< fraction 0..1
  std::function<bool()> isCancelled;                                    ///< true: throw Cancelled soon
};

/// What the person who opens a file adds to it.
struct ReadOptions {
  std::optional<glm::dvec3> spacingMm; ///< for image stacks and files without spacing; overrides otherwise
  std::optional<int> series;           ///< number of a series as listSeries gives it
};

/// One series of a DICOM folder, without patient data.
struct SeriesSummary {
  int number = 0; ///< 1, 2, … in the order listed; what `--series` takes
  std::string description;
  std::string modality;
  glm::ivec3 dims{0}; ///< columns, rows, images
  std::string folder; ///< of its files below the folder listed, empty where they lie in it
};

/// The series in a DICOM folder (or file), largest first; empty where `path` is not DICOM.
std::vector<SeriesSummary> listSeries(const std::filesystem::path& path);

/// Reads any supported volume: DICOM folder or file, NIfTI, NRRD, MetaImage, VTI, legacy VTK, a stack of
/// TIFF/PNG/JPEG (folder or multi-page file), InVesalius project. Safe on a worker thread.
/// Throws Error (input) with one sentence naming the file, the reason and a way out; Cancelled when asked to
/// stop.
std::shared_ptr<const Volume> readVolume(const std::filesystem::path& path, const ReadOptions& options = {},
                                         const Progress& progress = {});

} // namespace limn
