// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/VtkXmlArray.h"

#include "io/formats/ReadError.h"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace limn {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failDamaged(const fs::path& file) {
  failReading(file, "its array of values is damaged or cut off", copyAgain);
}

// The six bits of a base64 letter; nothing where it is none.
std::optional<unsigned> bitsOf(char letter) {
  static constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t at = alphabet.find(letter);
  return at == std::string_view::npos ? std::nullopt : std::optional(static_cast<unsigned>(at));
}

// Decodes units of base64: each is padded to whole groups of four letters.
class Base64 {
public:
  Base64(fs::path file, std::string_view text) : m_file(std::move(file)), m_text(text) {}

  std::string take(std::uint64_t bytes) {
    if (bytes / 3 > m_text.size() / 4)
      failDamaged(m_file);
    std::string result;
    result.reserve(bytes);
    while (result.size() < bytes)
      takeGroup(result, bytes - result.size());
    return result;
  }

private:
  void takeGroup(std::string& result, std::uint64_t wanted) {
    unsigned bits = 0;
    std::size_t letters = 0;
    for (int i = 0; i < 4; ++i) {
      const char letter = nextLetter();
      const auto value = bitsOf(letter);
      if (!value && letter != '=')
        failDamaged(m_file);
      bits = bits << 6 | value.value_or(0);
      letters += value ? 1 : 0;
    }
    const std::size_t held = letters * 6 / 8;
    const std::size_t used = static_cast<std::size_t>(std::min<std::uint64_t>(held, wanted));
    if (used == 0)
      failDamaged(m_file);
    for (std::size_t i = 0; i < used; ++i)
      result.push_back(static_cast<char>(bits >> (16 - 8 * i) & 0xff));
  }

  char nextLetter() {
    while (m_at < m_text.size() &&
           (m_text[m_at] == '\n' || m_text[m_at] == '\r' || m_text[m_at] == ' ' || m_text[m_at] == '\t'))
      ++m_at;
    if (m_at == m_text.size())
      failDamaged(m_file);
    return m_text[m_at++];
  }

  fs::path m_file;
  std::string_view m_text;
  std::size_t m_at = 0;
};

std::uint64_t lengthAt(const std::string& bytes, std::size_t index, const VtkXmlEncoding& encoding) {
  const auto width = static_cast<std::size_t>(encoding.bytesPerLength);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const std::size_t place = encoding.bigEndian ? i : width - 1 - i;
    value = value << 8 | static_cast<unsigned char>(bytes[index * width + place]);
  }
  return value;
}

// Bytes in memory, handed out one after the other.
ByteReader bytesInMemory(std::string bytes, std::size_t first) {
  auto held = std::make_shared<std::string>(std::move(bytes));
  return [held, first](unsigned char* to, std::size_t count) mutable {
    const std::size_t step = std::min(count, held->size() - first);
    std::copy_n(held->data() + first, step, to);
    first += step;
    return step;
  };
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

Blocks blocksOf(const fs::path& file, const UnitReader& units, const VtkXmlEncoding& encoding,
                std::uint64_t expected) {
  const auto width = static_cast<std::uint64_t>(encoding.bytesPerLength);
  // Three lengths are whole base64 groups, so the rest of the unit can be taken apart from them.
  const std::string start = units(3 * width);
  const std::uint64_t count = lengthAt(start, 0, encoding);
  Blocks blocks{{}, lengthAt(start, 1, encoding), lengthAt(start, 2, encoding)};
  if (count == 0 || count > expected || blocks.size == 0 || blocks.size > expected)
    failDamaged(file);
  const std::string lengths = units(count * width);
  for (std::uint64_t i = 0; i < count; ++i)
    blocks.packed.push_back(lengthAt(lengths, i, encoding));
  if ((count - 1) * blocks.size + blocks.sizeOf(count - 1) != expected)
    failDamaged(file);
  return blocks;
}

// Inflates block after block as bytes are asked for.
class BlockReader {
public:
  BlockReader(fs::path file, Blocks blocks, std::string packed)
      : m_file(std::move(file)), m_blocks(std::move(blocks)), m_packed(std::move(packed)) {}

  std::size_t read(unsigned char* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count && (m_used < m_plain.size() || inflateNext())) {
      const std::size_t step = std::min(count - done, m_plain.size() - m_used);
      std::copy_n(m_plain.data() + m_used, step, to + done);
      m_used += step;
      done += step;
    }
    return done;
  }

private:
  bool inflateNext() {
    if (m_next == m_blocks.packed.size())
      return false;
    const std::uint64_t wanted = m_blocks.sizeOf(m_next);
    const std::uint64_t length = m_blocks.packed[m_next];
    // Deflate codes at best 258 bytes in 2 bits.
    if (length > m_packed.size() - m_at || wanted / 1032 > length)
      failDamaged(m_file);
    m_plain.resize(wanted);
    uLongf got = wanted;
    const auto* from = reinterpret_cast<const Bytef*>(m_packed.data() + m_at);
    if (uncompress(m_plain.data(), &got, from, length) != Z_OK || got != wanted)
      failDamaged(m_file);
    m_at += length;
    m_used = 0;
    ++m_next;
    return true;
  }

  fs::path m_file;
  Blocks m_blocks;
  std::string m_packed;
  std::size_t m_at = 0;
  std::size_t m_next = 0;
  std::vector<unsigned char> m_plain;
  std::size_t m_used = 0;
};

} // namespace

UnitReader base64Units(const fs::path& file, std::string_view text) {
  auto decoder = std::make_shared<Base64>(file, text);
  return [decoder](std::uint64_t bytes) { return decoder->take(bytes); };
}

UnitReader plainUnits(const fs::path& file, std::uint64_t offset) {
  return [file, offset](std::uint64_t bytes) mutable {
    const ByteReader reader = openBytes({file, offset}, bytes);
    std::string unit(bytes, '\0');
    if (reader(reinterpret_cast<unsigned char*>(unit.data()), unit.size()) < bytes)
      failDamaged(file);
    offset += bytes;
    return unit;
  };
}

ByteReader arrayBytes(const fs::path& file, const UnitReader& units, const VtkXmlEncoding& encoding,
                      std::uint64_t expected) {
  if (!encoding.isCompressed) {
    const auto width = static_cast<std::uint64_t>(encoding.bytesPerLength);
    std::string unit = units(width + expected);
    if (lengthAt(unit, 0, encoding) != expected)
      failDamaged(file);
    return bytesInMemory(std::move(unit), width);
  }
  Blocks blocks = blocksOf(file, units, encoding, expected);
  std::uint64_t packed = 0;
  for (const std::uint64_t length : blocks.packed) {
    packed += length;
    if (length > expected + 1024 || packed > (std::uint64_t{1} << 40))
      failDamaged(file);
  }
  auto reader = std::make_shared<BlockReader>(file, std::move(blocks), units(packed));
  return [reader](unsigned char* to, std::size_t count) { return reader->read(to, count); };
}

} // namespace limn
