// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace limn {

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

/// Throws the sentence of voxels that end early.
[[noreturn]] void failShort(const std::filesystem::path& file, std::uint64_t got, std::uint64_t wanted);

/// The warning of a file that holds more than its header asks for.
inline const Message surplusWarning =
    Message::tr("The file holds more data than its header asks for: its dimensions may be wrong.");

} // namespace limn
