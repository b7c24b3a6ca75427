// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace limn {

/// Delivers the next `count` bytes to `to`; fewer only at the end of the data.
using ByteReader = std::function<std::size_t(unsigned char* to, std::size_t count)>;

/// How bytes lie in a file.
enum class Encoding {
  raw,
  deflated, ///< gzip (any number of members) or zlib, told apart by their first bytes
};

/// A run of bytes inside a file.
struct ByteLocation {
  std::filesystem::path file;
  std::uint64_t offset = 0; ///< in the file, before decoding
  Encoding encoding = Encoding::raw;
  std::uint64_t skip = 0; ///< after decoding
};

/// Opens a run of at least `needed` bytes. Throws Error where the file is missing or cannot hold that many:
/// exactly by its length when raw, by the largest ratio deflate can reach otherwise.
ByteReader openBytes(const ByteLocation& location, std::uint64_t needed);

/// Moves a raw location to the last `bytes` of its file. Throws Error where there are fewer behind it.
void moveToLast(std::uint64_t bytes, ByteLocation& location);

/// At most `count` bytes from the start of a file, inflated where it is a gzip file. Throws Error where the
/// file cannot be opened.
std::string firstBytes(const std::filesystem::path& file, std::size_t count);

/// Whether a file starts as a gzip file does.
bool isGzip(const std::filesystem::path& file);

/// The file beside `header` that the header names. Throws Error where the name is absolute, leaves the
/// header's folder (also through a link), or names no file, several or the header itself.
std::filesystem::path detachedFile(const std::filesystem::path& header, const std::string& name);

} // namespace limn
