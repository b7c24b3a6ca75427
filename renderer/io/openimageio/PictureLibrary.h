// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace limn {

/// A picture file as OpenImageIO opened it.
struct StoredPicture {
  enum class Sample { uint8, uint16, float32, other };
  int width = 0;
  int height = 0;
  int channels = 0;
  Sample sample = Sample::other;
  std::string description;
  /// Writes rows `first` to `first + count`, samples of a pixel together, in the file's type and native byte
  /// order. False where anything is damaged.
  std::function<bool(void* to, int first, int count)> readRows;
};

/// Pixels to be written, row by row from the top.
struct PictureToWrite {
  enum class Format { png, tiff, jpeg, exr };
  Format format = Format::png;
  int width = 0;
  int height = 0;
  const void* pixels = nullptr; ///< RGBA floats for EXR, with three of radiance behind where it has them; RGB
                                ///< bytes otherwise
  std::string description;      ///< ASCII, may be empty
  bool hasAlpha = false;        ///< RGBA bytes instead, the colours not multiplied by alpha; not for JPEG
  double dotsPerInch = 0.0;     ///< at which it is meant to be printed; 0: nothing is said
  bool hasRadiance = false;     ///< EXR alone
};

/// What Limn asks of OpenImageIO. The library brings two hundred others, which took most of the program's
/// start, so it stands behind a module that is loaded with the first picture.
struct PictureLibrary {
  /// Absent where the file is no picture, or a damaged one. Alpha is not multiplied into the colours.
  std::optional<StoredPicture> (*open)(const std::string& path);
  /// Empty where the file was written, otherwise why not. Of PNG that is writePng's, which needs no library.
  std::string (*write)(const std::string& path, const PictureToWrite& picture);
};

/// Loads the module at the first call. Throws Error (other) where it is missing. Any thread.
const PictureLibrary& pictureLibrary();

} // namespace limn
