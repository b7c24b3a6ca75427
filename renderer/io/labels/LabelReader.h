// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <filesystem>
#include <vector>

namespace limn {

/// Labels that were read, and what of them is not as their files have it: empty, or a sentence or two.
struct Segmentation {
  Region region;
  Message remark;
  Message covered{}; ///< which labels others left no voxel to; the remark begins with it
  /// Where that happened, the files of its masks from the largest to the smallest, which as a list
  /// (readMasks) leave as many as can be a voxel; empty where they came so.
  std::vector<std::filesystem::path> smallestLast{};
};

/// Labels as a volume on a grid of their own, and what the file and its name say of them.
struct LabelVolume {
  std::shared_ptr<const Volume> volume;
  std::vector<Label> described; ///< names and colours by value, as the file has them
  std::string structure{};      ///< where the file itself names none
};

/// Whether a file may hold one of several masks: a volume by its ending, or a DICOM segmentation.
bool mayBeMask(const std::filesystem::path& file);

/// Reads the file of a label map, no folder of masks. Throws as readLabels does.
LabelVolume readLabelVolume(const std::filesystem::path& path, const Progress& progress = {},
                            const PatientLabel& patient = {});

/// Reads a label map: a DICOM segmentation, a volume of whole numbers in any format that readVolume reads, or
/// a folder of masks (MaskFolder.h). It comes on `grid`, nearest label by nearest label where it has another
/// one, with the names and colours that the file gives (DICOM segments, Slicer's segmentations in NRRD, label
/// tables in NIfTI); the only label of a file that gives none is called after the file (LabelNames.h), but
/// for what may name the volume's patient. Every label weighs 1. Throws Error (input) with one sentence
/// naming the file; Cancelled.
Segmentation readSegmentation(const std::filesystem::path& path, const Grid& grid,
                              const Progress& progress = {}, const PatientLabel& patient = {});

/// The same of several files, which are masks (readMasks in MaskFolder.h), or of one.
Segmentation readSegmentations(const std::vector<std::filesystem::path>& paths, const Grid& grid,
                               const Progress& progress = {}, const PatientLabel& patient = {});

/// The same without the remark, for volumes of nobody.
Region readLabels(const std::filesystem::path& path, const Grid& grid, const Progress& progress = {});

/// How a region names where its labels are: absolute, without a slash at its end.
std::string sourceOf(const std::filesystem::path& path);

/// Throws Error (input) with the path where labels on a grid lie wholly beside the volume's.
void requireNear(const std::filesystem::path& path, const Grid& labels, const Grid& volume);

} // namespace limn
