// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Bytes.h"
#include "io/reading/Progress.h"
#include "io/reading/VoxelKeeping.h"
#include "scene/volume/Volume.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace limn {

/// What a format reader found, before the reader's options are applied and the volume is made. Readers set
/// `info.spacingKnown` and `info.orientationKnown`; the sentences about them are added in one place.
struct VolumeParts {
  Grid grid;
  VoxelArray stored;
  Rescale rescale;
  VolumeInfo info;
  std::shared_ptr<Room> room;   ///< where `stored` lies; null: in memory
  std::optional<VoxelBox> held; ///< the voxels `stored`, where they are not all
};

/// The number types that files store; 64-bit integers become double.
enum class VoxelType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

/// As the file stores one number, 1..8.
std::size_t bytesPerVoxel(VoxelType type);

/// How the voxels of a file lie in its bytes.
struct VoxelLayout {
  VoxelType type = VoxelType::uint8;
  bool bigEndian = false;
  int components = 1;        ///< 1; 2 (grey, alpha), 3 (RGB) and 4 (RGBA) become luminance
  std::uint64_t count = 0;   ///< voxels
  std::uint64_t volumes = 1; ///< of which the first is read; the others follow it
  bool endsFile = true;      ///< nothing else follows
};

/// Bytes that the voxels of one volume fill.
std::uint64_t bytesOf(const VoxelLayout& layout);

/// Throws Error, naming `file`: so many voxels of those that its header asks for are there.
[[noreturn]] void failShort(const std::filesystem::path& file, std::uint64_t got, std::uint64_t wanted);

/// Product of the dimensions. Throws Error where one is not positive or the product is beyond any file.
std::uint64_t voxelCount(const std::filesystem::path& file, const glm::ivec3& dims);

/// A header's number as a dimension. Throws Error where it is not within 1 .. 2³¹-1.
int dimension(const std::filesystem::path& file, double value);

/// The type that a format calls `name`. Throws Error where `types` does not have it.
VoxelType typeNamed(const std::filesystem::path& file, const std::string& name,
                    const std::map<std::string, VoxelType>& types);

/// A header's number of values per voxel, 1 where the text is empty, 3 or 4 of a colour. Throws Error where
/// it is another.
int componentCount(const std::filesystem::path& file, const std::string& text);

/// Says where only the first of several volumes is shown, and where colours become luminance.
void noteLayout(const VoxelLayout& layout, std::vector<Message>& warnings);

/// Reads exactly the voxels that `layout` describes into `parts.stored`: in memory, or in `parts.room` where
/// the budget does not hold them. In memory, room is made at once for `certain` voxels, whose bytes are known
/// to exist, and beyond them only as bytes arrive. Of a part alone no others are kept, which a warning says.
/// `parts.grid` must be known. Throws Error, naming `file`, where the bytes end early or there is no room;
/// Cancelled.
void readVoxels(const std::filesystem::path& file, const ByteReader& bytes, const VoxelLayout& layout,
                const VoxelKeeping& keeping, const Progress& progress, std::uint64_t certain,
                VolumeParts& parts);

/// Opens `location` and reads exactly the voxels that `layout` describes; where the budget does not hold them
/// and they lie in the file as they are kept, they are mapped. Of a part of what is not compressed no other
/// bytes are read. Warns where the file holds more than its
/// header asks for, which then is likely wrong, or ends within the volumes behind the first.
void readVoxels(const ByteLocation& location, const VoxelLayout& layout, const VoxelKeeping& keeping,
                const Progress& progress, VolumeParts& parts);

/// Does without a look at all voxels of a file that is not compressed, which must be known to hold them: of a
/// part those bytes alone are read. All, and a part that the budget does not hold, are mapped where they lie
/// in the file as they are kept: one component of a type that is kept, in this machine's order of bytes, at
/// a place where such numbers may lie. Returns whether it did either. Throws Error, naming the file, where it
/// became shorter or there is no room; Cancelled.
bool readInPlace(const ByteLocation& location, const VoxelLayout& layout, const VoxelKeeping& keeping,
                 const Progress& progress, VolumeParts& parts);

/// The luma of colour samples in display encoding (ITU-R BT.709 weights); the sample itself where grey.
double luminance(const double* samples, int components);

/// Calls `function(T{})` with a number of the C++ type that stores `type`.
template <class Function>
auto withStoredType(VoxelType type, Function&& function) {
  switch (type) {
  case VoxelType::uint8:
    return function(std::uint8_t{});
  case VoxelType::int8:
    return function(std::int8_t{});
  case VoxelType::uint16:
    return function(std::uint16_t{});
  case VoxelType::int16:
    return function(std::int16_t{});
  case VoxelType::uint32:
    return function(std::uint32_t{});
  case VoxelType::int32:
    return function(std::int32_t{});
  case VoxelType::uint64:
    return function(std::uint64_t{});
  case VoxelType::int64:
    return function(std::int64_t{});
  case VoxelType::float32:
    return function(float{});
  case VoxelType::float64:
    break;
  }
  return function(double{});
}

/// Turns numbers as a file stores them into those of this machine.
template <class Stored>
void toNativeOrder(Stored* values, std::size_t count, const VoxelLayout& layout) {
  if (layout.bigEndian == (std::endian::native == std::endian::big))
    return;
  auto* bytes = reinterpret_cast<unsigned char*>(values);
  for (std::size_t i = 0; i < count; ++i)
    std::reverse(bytes + i * sizeof(Stored), bytes + (i + 1) * sizeof(Stored));
}

/// The type in which a stored type is kept.
template <class Stored>
using Kept = std::conditional_t<std::is_integral_v<Stored> && sizeof(Stored) == 8, double, Stored>;

/// The value of a pixel or voxel: its sample, or the luminance of its colours.
template <class Stored>
Kept<Stored> keptValue(const Stored* samples, int components) {
  if (components == 1)
    return static_cast<Kept<Stored>>(samples[0]);
  double values[4] = {};
  for (int c = 0; c < components; ++c)
    values[c] = static_cast<double>(samples[c]);
  const double luma = luminance(values, components);
  return static_cast<Kept<Stored>>(std::is_integral_v<Kept<Stored>> ? std::round(luma) : luma);
}

/// The warning of a file that holds more than its header asks for.
inline const Message surplusWarning =
    Message::tr("The file holds more data than its header asks for: its dimensions may be wrong.");

/// The sentence for a volume whose colours became luminance.
inline const Message colorWarning = Message::tr("The file holds colours; their luminance is shown.");

/// Reads voxels written as decimal numbers between white space, scalar only, as the bytes arrive; keeps and
/// warns as readVoxels does. `warnings` takes note of numbers behind the last voxel; with `mayBeCut` also of
/// a text that ends right behind a digit, of which it may have lost others. Throws Error, naming `file`,
/// where the text is too short or a word is no number of the layout's type; Cancelled.
void readTextVoxels(const std::filesystem::path& file, const ByteReader& text, const VoxelLayout& layout,
                    const VoxelKeeping& keeping, const Progress& progress, bool mayBeCut, VolumeParts& parts);

/// The same from a place in a file, which must not be compressed.
void readTextVoxels(const ByteLocation& location, const VoxelLayout& layout, const VoxelKeeping& keeping,
                    const Progress& progress, VolumeParts& parts);

} // namespace limn
