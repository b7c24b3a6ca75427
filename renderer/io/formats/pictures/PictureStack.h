// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "io/reading/VoxelKeeping.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace limn {

/// What one picture of a stack is.
struct PictureShape {
  int width = 0;
  int height = 0;
  int channels = 1; ///< 1, 2 (with alpha), 3 (RGB) or 4 (RGBA)
  VoxelType type = VoxelType::uint8;
  bool operator==(const PictureShape&) const = default;
};

/// One picture, decoded as its rows are asked for.
struct Picture {
  PictureShape shape;
  /// Writes `count` rows, in native byte order and the samples of a pixel together. Rows must be asked for
  /// once each and in order. Throws Error where the picture is damaged.
  std::function<void(unsigned char* to, int first, int count)> readRows;
};

/// Bytes of one row.
inline std::size_t rowBytes(const PictureShape& shape) {
  return static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels) *
         bytesPerVoxel(shape.type);
}

/// Throws Error where a header asks for more pixels than its file can hold, or for none.
void requireRoom(const std::filesystem::path& file, const PictureShape& shape);

/// Opens a PNG or JPEG picture.
Picture openPicture(const std::filesystem::path& file);

/// Opens a TIFF file and hands its pages to `use`, one after the other. Throws Error.
void forEachTiffPage(const std::filesystem::path& file, const std::function<void(const Picture&)>& use);

/// The number of pages of a TIFF or BigTIFF file, once all that its directories point to has been found
/// inside the file: readers take a chain of pages that breaks off for its end, and missing strips for zeros.
/// Throws Error where the file is cut off or damaged. Source: TIFF 6.0, section 2; BigTIFF design of libtiff.
int tiffPages(const std::filesystem::path& file);

/// Whether the bytes start as a TIFF, PNG or JPEG picture does.
bool isPicture(std::string_view bytes);

/// The pictures of a folder (not of its subfolders), in the order of the numbers in their names: 2 before 10.
std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder);

/// Throws Error where a file of the folder is called as its pictures are, but is none: a lost slice.
void requireWholeStack(const std::filesystem::path& folder,
                       const std::vector<std::filesystem::path>& pictures);

/// Whether `a` comes before `b` when runs of digits count as numbers.
bool naturalLess(std::string_view a, std::string_view b);

/// Reads a stack of pictures, one slice each in the order given, or the pages of one file. All must have one
/// size and type; colours become luminance with a warning. Pictures say nothing of spacing along the stack
/// or of orientation: both are unknown. Of a part of a folder no other pictures are opened, but for the
/// first. Throws Error; Cancelled.
VolumeParts readPictures(const std::filesystem::path& path, const std::vector<std::filesystem::path>& files,
                         const VoxelKeeping& keeping, const Progress& progress);

} // namespace limn
