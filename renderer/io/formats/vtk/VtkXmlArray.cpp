// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/vtk/VtkXmlArray.h"

#include "io/reading/ReadError.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <vector>

namespace limn {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failDamagedArray(const fs::path& file) {
  failReading(file, Message::tr("its array of values is damaged or cut off"), copyAgain);
}

// The six bits of a base64 letter; nothing where it is none.
std::optional<unsigned> bitsOf(unsigned char letter) {
  static constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t at = alphabet.find(static_cast<char>(letter));
  return at == std::string_view::npos ? std::nullopt : std::optional(static_cast<unsigned>(at));
}

// Decodes base64 letters as they are asked for, in groups of four.
class Base64 {
public:
  Base64(fs::path file, ByteReader letters) : m_file(std::move(file)), m_letters(std::move(letters)) {}

  std::size_t read(unsigned char* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count && (m_taken < m_held || takeGroup()))
      to[done++] = m_group[m_taken++];
    return done;
  }

private:
  // Decodes the next group; false at the end of the letters.
  bool takeGroup() {
    unsigned bits = 0;
    std::size_t letters = 0;
    for (int i = 0; i < 4; ++i) {
      const auto letter = nextLetter();
      if (!letter && i == 0)
        return false;
      const auto value = letter ? bitsOf(*letter) : std::nullopt;
      if (!letter || (!value && *letter != '='))
        failDamagedArray(m_file);
      bits = bits << 6 | value.value_or(0);
      letters += value ? 1 : 0;
    }
    m_taken = 0;
    m_held = letters * 6 / 8;
    if (m_held == 0)
      failDamagedArray(m_file);
    for (std::size_t i = 0; i < 3; ++i)
      m_group[i] = static_cast<unsigned char>(bits >> (16 - 8 * i) & 0xff);
    return true;
  }

  std::optional<unsigned char> nextLetter() {
    while (true) {
      if (m_at == m_filled) {
        m_filled = m_letters(m_buffer.data(), m_buffer.size());
        m_at = 0;
        if (m_filled == 0)
          return std::nullopt;
      }
      const unsigned char letter = m_buffer[m_at++];
      if (letter != '\n' && letter != '\r' && letter != ' ' && letter != '\t')
        return letter;
    }
  }

  fs::path m_file;
  ByteReader m_letters;
  std::array<unsigned char, 1 << 16> m_buffer{};
  std::size_t m_at = 0;
  std::size_t m_filled = 0;
  std::array<unsigned char, 3> m_group{};
  std::size_t m_taken = 0;
  std::size_t m_held = 0;
};

// The bytes behind the code. Each unit of base64 ends with a whole group, so one starts where another ends.
ByteReader decoded(const fs::path& file, const ByteReader& coded, const VtkXmlEncoding& encoding) {
  if (!encoding.isBase64)
    return coded;
  auto decoder = std::make_shared<Base64>(file, coded);
  return [decoder](unsigned char* to, std::size_t count) { return decoder->read(to, count); };
}

std::uint64_t takeLength(const fs::path& file, const ByteReader& bytes, const VtkXmlEncoding& encoding) {
  const auto width = static_cast<std::size_t>(encoding.bytesPerLength);
  std::array<unsigned char, 8> raw{};
  if (bytes(raw.data(), width) < width)
    failDamagedArray(file);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < width; ++i)
    value = value << 8 | raw[encoding.bigEndian ? i : width - 1 - i];
  return value;
}

// The blocks of a compressed array: lengths before and after compression.
struct Blocks {
  std::vector<std::uint64_t> packed;
  std::uint64_t size = 0;
  std::uint64_t lastSize = 0; // 0: the last is as long as the others

  std::uint64_t sizeOf(std::size_t block) const {
    return block + 1 == packed.size() && lastSize > 0 ? lastSize : size;
  }
};

Blocks blocksOf(const fs::path& file, const ByteReader& bytes, const VtkXmlEncoding& encoding,
                std::uint64_t expected) {
  const std::uint64_t count = takeLength(file, bytes, encoding);
  Blocks blocks;
  blocks.size = takeLength(file, bytes, encoding);
  blocks.lastSize = takeLength(file, bytes, encoding);
  // All blocks but the last are as long as one, so their number follows from the sizes.
  if (blocks.size == 0 || blocks.size > expected || blocks.lastSize > blocks.size ||
      count != expected / blocks.size + (expected % blocks.size > 0 ? 1 : 0))
    failDamagedArray(file);
  for (std::uint64_t i = 0; i < count; ++i)
    blocks.packed.push_back(takeLength(file, bytes, encoding));
  if (blocks.sizeOf(count - 1) != expected - (count - 1) * blocks.size)
    failDamagedArray(file);
  return blocks;
}

// Inflates block after block as bytes are asked for.
class BlockReader {
public:
  BlockReader(fs::path file, Blocks blocks, ByteReader packed)
      : m_file(std::move(file)), m_blocks(std::move(blocks)), m_packed(std::move(packed)) {
    if (inflateInit(&m_zlib) != Z_OK)
      throw std::bad_alloc();
  }
  ~BlockReader() { inflateEnd(&m_zlib); }
  BlockReader(const BlockReader&) = delete;
  BlockReader& operator=(const BlockReader&) = delete;

  std::size_t read(unsigned char* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count && (m_plainLeft > 0 || startNext()))
      done += inflateSome(to + done, count - done);
    return done;
  }

private:
  bool startNext() {
    if (m_next == m_blocks.packed.size())
      return false;
    inflateReset(&m_zlib);
    m_zlib.avail_in = 0;
    m_packedLeft = m_blocks.packed[m_next];
    m_plainLeft = m_blocks.sizeOf(m_next);
    ++m_next;
    return true;
  }

  void refill() {
    if (m_zlib.avail_in > 0 || m_packedLeft == 0)
      return;
    const auto step = static_cast<std::size_t>(std::min<std::uint64_t>(m_input.size(), m_packedLeft));
    if (m_packed(m_input.data(), step) < step)
      failDamagedArray(m_file);
    m_packedLeft -= step;
    m_zlib.next_in = m_input.data();
    m_zlib.avail_in = static_cast<uInt>(step);
  }

  std::size_t inflateSome(unsigned char* to, std::size_t count) {
    refill();
    const auto room =
        static_cast<uInt>(std::min<std::uint64_t>({count, m_plainLeft, std::uint64_t{1} << 30}));
    m_zlib.next_out = to;
    m_zlib.avail_out = room;
    const int status = inflate(&m_zlib, Z_NO_FLUSH);
    const std::size_t got = room - m_zlib.avail_out;
    m_plainLeft -= got;
    if ((status != Z_OK && status != Z_STREAM_END) ||
        (got == 0 && m_zlib.avail_in == 0 && m_packedLeft == 0) ||
        (status == Z_STREAM_END && m_plainLeft > 0))
      failDamagedArray(m_file);
    if (m_plainLeft == 0)
      endBlock(status);
    return got;
  }

  // A block holds no more than its size: behind the last value the stream ends, with its check sum.
  void endBlock(int status) {
    unsigned char beyond = 0;
    while (status == Z_OK) {
      refill();
      m_zlib.next_out = &beyond;
      m_zlib.avail_out = 1;
      status = inflate(&m_zlib, Z_NO_FLUSH);
      if (m_zlib.avail_out == 0)
        failDamagedArray(m_file);
    }
    if (status != Z_STREAM_END || m_packedLeft > 0)
      failDamagedArray(m_file);
  }

  fs::path m_file;
  Blocks m_blocks;
  ByteReader m_packed;
  z_stream m_zlib{};
  std::array<unsigned char, 1 << 16> m_input{};
  std::size_t m_next = 0;
  std::uint64_t m_packedLeft = 0; // of the block under way, not yet given to zlib
  std::uint64_t m_plainLeft = 0;  // of the block under way, not yet handed out
};

} // namespace

ByteReader arrayBytes(const fs::path& file, const ByteReader& coded, const VtkXmlEncoding& encoding,
                      std::uint64_t expected) {
  ByteReader bytes = decoded(file, coded, encoding);
  if (!encoding.isCompressed) {
    if (takeLength(file, bytes, encoding) != expected)
      failDamagedArray(file);
    return bytes;
  }
  Blocks blocks = blocksOf(file, bytes, encoding, expected);
  auto reader = std::make_shared<BlockReader>(file, std::move(blocks), bytes);
  return [reader](unsigned char* to, std::size_t count) { return reader->read(to, count); };
}

} // namespace limn
