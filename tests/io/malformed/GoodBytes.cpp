// SPDX-License-Identifier: GPL-3.0-or-later
#include "GoodBytes.h"

#include <algorithm>

namespace limn::test {
namespace {

// Deflates a piece and flushes so that what follows does not refer back to it.
std::string piece(z_stream& stream, const std::string& bytes, int flush) {
  std::string result(bytes.size() + 1024, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  deflate(&stream, flush);
  return result.substr(0, result.size() - stream.avail_out);
}

} // namespace

std::string bomb(const std::string& start, std::size_t mebibytes, int windowBits) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("no zlib");
  std::string result = piece(stream, start, Z_FULL_FLUSH);
  // Behind a full flush the same code means the same bytes again.
  const std::string zeros = piece(stream, std::string(1 << 20, '\0'), Z_FULL_FLUSH);
  for (std::size_t i = 0; i < mebibytes; ++i)
    result += zeros;
  result += piece(stream, "", Z_FINISH);
  deflateEnd(&stream);
  return result;
}

std::string littleEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i)
    text += static_cast<char>(value >> (8 * i));
  return text;
}

std::string bigEndian(std::uint64_t value, int bytes) {
  std::string text = littleEndian(value, bytes);
  std::reverse(text.begin(), text.end());
  return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
    throw std::runtime_error("the good file holds no \"" + from + "\"");
  return text.replace(at, from.size(), to);
}

} // namespace limn::test
