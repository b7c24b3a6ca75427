// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/VolumeReader.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace limn::test {

/// The bytes of numbers in either byte order.
template <class T>
std::string bytesOf(const std::vector<T>& values, bool bigEndian = false) {
  std::string result;
  for (const T value : values) {
    std::array<char, sizeof(T)> raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (bigEndian)
      std::reverse(raw.begin(), raw.end());
    result.append(raw.data(), raw.size());
  }
  return result;
}

/// The bytes as a gzip file (or a zlib stream).
inline std::string deflated(const std::string& bytes, bool asGzip = true) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, asGzip ? 31 : 15, 8, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::runtime_error("no zlib");
  std::string result(deflateBound(&stream, bytes.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

/// The numbers 0, 1, 2 …
template <class T>
std::vector<T> rising(std::size_t count) {
  std::vector<T> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = static_cast<T>(i);
  return values;
}

/// The voxels of most of these files, 2 × 3 × 4 of them: 0 to 23.
inline std::string voxels() {
  return bytesOf(rising<std::int16_t>(24));
}

/// Expects two points of the world to agree; float32 headers carry seven figures.
inline void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-5) {
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(actual[axis], expected[axis], tolerance) << "axis " << axis;
}

/// The sentence with which a file is refused; it must name the file, and be an error of the input.
inline std::string refusalOf(const std::filesystem::path& file, const ReadOptions& options = {}) {
  try {
    readVolume(file, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos) << error.what();
    return error.what();
  }
  ADD_FAILURE() << file << " was not refused";
  return {};
}

/// What a file of that name and content is read as.
inline std::shared_ptr<const Volume> openedAs(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  writeBytes(folder.path() / name, bytes);
  return readVolume(folder.path() / name);
}

/// The sentence with which a file of that name and content is refused.
inline std::string refusalAs(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  writeBytes(folder.path() / name, bytes);
  return refusalOf(folder.path() / name);
}

/// Whether some warning of the volume contains the text.
inline bool warns(const Volume& volume, const std::string& text) {
  const auto& warnings = volume.info().warnings;
  return std::any_of(warnings.begin(), warnings.end(), [&](const Message& warning) {
    return warning.english().find(text) != std::string::npos;
  });
}

} // namespace limn::test
