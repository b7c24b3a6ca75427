// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"

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

} // namespace limn
