// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/Voxels.h"

#include "io/formats/ReadError.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t bytesPerStep = 1 << 20;

// Calls `function(T{})` with a number of the C++ type that stores `type`.
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

// The type in which a stored type is kept.
template <class Stored>
using Kept = std::conditional_t<std::is_integral_v<Stored> && sizeof(Stored) == 8, double, Stored>;

template <class Stored>
void swapBytes(Stored* values, std::size_t count) {
  auto* bytes = reinterpret_cast<unsigned char*>(values);
  for (std::size_t i = 0; i < count; ++i)
    std::reverse(bytes + i * sizeof(Stored), bytes + (i + 1) * sizeof(Stored));
}

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

void reportStep(const Progress& progress, std::uint64_t done, std::uint64_t all) {
  if (progress.isCancelled && progress.isCancelled())
    throw Cancelled();
  if (progress.report)
    progress.report(static_cast<double>(done) / static_cast<double>(all), "Reading voxels");
}

[[noreturn]] void failShort(const fs::path& file, std::uint64_t got, std::uint64_t wanted) {
  failReading(file,
              "its voxels end after " + std::to_string(got) + " of the " + std::to_string(wanted) +
                  " that its header asks for",
              copyAgain);
}

// Makes room for `step` more voxels, at most doubling what has been filled from real bytes.
template <class T>
void growBy(std::vector<T>& voxels, std::size_t step, std::uint64_t final) {
  const std::size_t wanted = voxels.size() + step;
  if (wanted > voxels.capacity())
    voxels.reserve(std::min<std::uint64_t>(final, std::max(wanted, 2 * voxels.capacity())));
  voxels.resize(wanted);
}

template <class Stored>
std::vector<Kept<Stored>> readAs(const fs::path& file, const ByteReader& bytes, const VoxelLayout& layout,
                                 const Progress& progress, std::uint64_t certain) {
  const auto components = static_cast<std::size_t>(layout.components);
  const bool swap = layout.bigEndian != (std::endian::native == std::endian::big);
  const std::size_t perStep = bytesPerStep / sizeof(Stored) / components;
  std::vector<Stored> samples(perStep * components);
  std::vector<Kept<Stored>> voxels;
  voxels.reserve(certain);
  while (voxels.size() < layout.count) {
    reportStep(progress, voxels.size(), layout.count);
    const std::size_t step = std::min<std::uint64_t>(perStep, layout.count - voxels.size());
    const std::size_t wanted = step * components * sizeof(Stored);
    const std::size_t got = bytes(reinterpret_cast<unsigned char*>(samples.data()), wanted);
    if (got < wanted)
      failShort(file, voxels.size() + got / (components * sizeof(Stored)), layout.count);
    if (swap)
      swapBytes(samples.data(), step * components);
    const std::size_t first = voxels.size();
    growBy(voxels, step, layout.count);
    for (std::size_t i = 0; i < step; ++i)
      voxels[first + i] = keptValue(samples.data() + i * components, layout.components);
  }
  // Ask for one byte more: at the end of compressed data this makes zlib compare the check sum.
  unsigned char beyond = 0;
  bytes(&beyond, 1);
  reportStep(progress, layout.count, layout.count);
  return voxels;
}

std::string readText(const ByteLocation& location, std::uint64_t least) {
  const ByteReader bytes = openBytes(location, least);
  std::string text;
  std::size_t got = 0;
  do {
    const std::size_t before = text.size();
    text.resize(before + bytesPerStep);
    got = bytes(reinterpret_cast<unsigned char*>(text.data() + before), bytesPerStep);
    text.resize(before + got);
  } while (got == bytesPerStep);
  return text;
}

template <class Stored>
std::vector<Kept<Stored>> parseAs(const fs::path& file, std::string_view text, const VoxelLayout& layout,
                                  const Progress& progress) {
  std::vector<Kept<Stored>> voxels;
  voxels.reserve(layout.count);
  const char* at = text.data();
  const char* const end = at + text.size();
  while (voxels.size() < layout.count) {
    while (at < end && (*at == ' ' || *at == '\n' || *at == '\r' || *at == '\t'))
      ++at;
    if (at == end)
      failShort(file, voxels.size(), layout.count);
    Stored value{};
    const auto [after, problem] = std::from_chars(at, end, value);
    if (problem != std::errc{} || after == at)
      failReading(file, "a voxel's text is not a number of the type that the header names", copyAgain);
    voxels.push_back(static_cast<Kept<Stored>>(value));
    at = after;
    if (voxels.size() % bytesPerStep == 0)
      reportStep(progress, voxels.size(), layout.count);
  }
  return voxels;
}

} // namespace

std::size_t bytesPerVoxel(VoxelType type) {
  return withStoredType(type, [](auto value) { return sizeof(value); });
}

std::uint64_t bytesOf(const VoxelLayout& layout) {
  return layout.count * static_cast<std::uint64_t>(layout.components) * bytesPerVoxel(layout.type);
}

std::uint64_t voxelCount(const fs::path& file, const glm::ivec3& dims) {
  constexpr std::uint64_t most = std::uint64_t{1} << 40;
  std::uint64_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (dims[axis] < 1 || count > most / static_cast<std::uint64_t>(dims[axis]))
      failReading(file,
                  "its header gives the dimensions " + std::to_string(dims.x) + " x " +
                      std::to_string(dims.y) + " x " + std::to_string(dims.z),
                  copyAgain);
    count *= static_cast<std::uint64_t>(dims[axis]);
  }
  return count;
}

int dimension(const fs::path& file, double value) {
  if (!(value >= 1.0) || value > 2147483647.0 || value != std::floor(value))
    failReading(file, "its header gives a dimension that is not a positive whole number", copyAgain);
  return static_cast<int>(value);
}

VoxelArray readVoxels(const fs::path& file, const ByteReader& bytes, const VoxelLayout& layout,
                      const Progress& progress, std::uint64_t certain) {
  return withStoredType(layout.type, [&](auto value) -> VoxelArray {
    return readAs<decltype(value)>(file, bytes, layout, progress, certain);
  });
}

VoxelArray readVoxels(const ByteLocation& location, const VoxelLayout& layout, const Progress& progress) {
  const ByteReader bytes = openBytes(location, bytesOf(layout));
  const bool isChecked = location.encoding == Encoding::raw;
  return readVoxels(location.file, bytes, layout, progress, isChecked ? layout.count : 0);
}

VoxelArray readTextVoxels(const ByteLocation& location, const VoxelLayout& layout, const Progress& progress) {
  // The shortest voxel is a digit, and white space parts it from the next.
  return parseTextVoxels(location.file, readText(location, 2 * layout.count - 1), layout, progress);
}

VoxelArray parseTextVoxels(const fs::path& file, std::string_view text, const VoxelLayout& layout,
                           const Progress& progress) {
  if (layout.components != 1)
    failReading(file, "it holds colours as text", "convert it to a binary encoding");
  if (text.size() < 2 * layout.count - 1)
    failReading(file, "its text is too short for the voxels that its header asks for", copyAgain);
  return withStoredType(layout.type, [&](auto value) -> VoxelArray {
    return parseAs<decltype(value)>(file, text, layout, progress);
  });
}

double luminance(const double* samples, int components) {
  if (components < 3)
    return samples[0];
  return 0.2126 * samples[0] + 0.7152 * samples[1] + 0.0722 * samples[2];
}

} // namespace limn
