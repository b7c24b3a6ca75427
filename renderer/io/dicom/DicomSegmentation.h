// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace limn {

/// The segments of a DICOM segmentation: a volume of their numbers on a grid of its own, 0 between them, and
/// what the file calls them. Where segments overlap, the higher number stands.
struct DicomSegments {
  std::shared_ptr<const Volume> numbers;
  std::vector<Label> labels;
};

/// Whether a file is a Segmentation object (PS3.3, A.51): frames that say which pixels belong to a segment.
bool isDicomSegmentation(const std::filesystem::path& file);

/// Reads a Segmentation object, binary or fractional (a pixel belongs to it from half on), uncompressed.
/// Frames may be missing where a segment is empty. Throws Error (input) naming the file; Cancelled.
DicomSegments readDicomSegmentation(const std::filesystem::path& file, const Progress& progress);

/// A colour given as DICOM gives it: CIELab of white point D50 in 16-bit words (PS3.3, C.10.7.1.1), as sRGB
/// 0..1, clamped to what a screen can show.
glm::dvec3 colorOfCieLab(const std::array<std::uint16_t, 3>& words);

/// The words of an sRGB colour, 0..1: the other way round.
std::array<std::uint16_t, 3> cieLabOfColor(const glm::dvec3& color);

} // namespace limn
