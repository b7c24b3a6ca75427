// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/pictures/Picture.h"

#include "io/reading/ReadError.h"

#include <array>
#include <fstream>
#include <set>
#include <vector>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr int mostPages = 65535;
constexpr std::uint64_t mostPieces = 1 << 20; // strips or tiles of a page

// Tags of the pieces of a picture: where they lie and how long they are.
constexpr std::uint64_t stripOffsets = 273, stripLengths = 279, tileOffsets = 324, tileLengths = 325;

std::uint64_t bytesOfType(std::uint64_t type) {
  static constexpr std::array<std::uint64_t, 19> bytes = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4,
                                                          8, 4, 8, 4, 0, 0, 8, 8, 8};
  return type < bytes.size() ? bytes[type] : 0;
}

// Where the values of one entry of a directory lie.
struct Entry {
  std::uint64_t tag = 0;
  std::uint64_t width = 0; // bytes of one value
  std::uint64_t count = 0;
  std::uint64_t place = 0;
};

// Walks through a TIFF file in its own byte order.
class TiffDirectories {
public:
  explicit TiffDirectories(const fs::path& file)
      : m_file(file), m_size(fs::file_size(file)), m_stream(file, std::ios::binary) {
    m_isBigEndian = m_stream.get() == 'M';
    m_isBig = number(2, 2) == 43;
    m_wide = m_isBig ? 8 : 4;
  }

  std::uint64_t firstDirectory() { return number(m_isBig ? 8 : 4, m_wide); }

  // Checks the directory at `offset` and returns the place of the one that follows; 0 behind the last.
  std::uint64_t passDirectory(std::uint64_t offset) {
    if (!m_passed.insert(offset).second)
      failCutOff();
    const std::uint64_t head = m_isBig ? 8 : 2;
    const std::uint64_t entryBytes = m_isBig ? 20 : 12;
    const std::uint64_t entries = number(offset, head);
    if (entries > 65536)
      failCutOff();
    const std::string directory = bytesAt(offset + head, entries * entryBytes);
    std::vector<std::uint64_t> places, lengths;
    for (std::uint64_t i = 0; i < entries; ++i) {
      const Entry entry = entryIn(directory, i * entryBytes, offset + head);
      if (entry.tag == stripOffsets || entry.tag == tileOffsets)
        places = valuesOf(entry);
      if (entry.tag == stripLengths || entry.tag == tileLengths)
        lengths = valuesOf(entry);
    }
    if (places.size() != lengths.size())
      failCutOff();
    for (std::size_t i = 0; i < places.size(); ++i)
      requireInside(places[i], lengths[i]);
    return number(offset + head + entries * entryBytes, m_wide);
  }

  [[noreturn]] void failCutOff() const {
    failReading(m_file, Message::tr("its pages are damaged or cut off"), copyAgain);
  }

private:
  void requireInside(std::uint64_t offset, std::uint64_t bytes) const {
    if (offset > m_size || bytes > m_size - offset)
      failCutOff();
  }

  // The entry at `at` in the bytes of a directory, which start at `offset` in the file.
  Entry entryIn(const std::string& directory, std::uint64_t at, std::uint64_t offset) const {
    Entry entry;
    entry.tag = numberIn(directory, at, 2);
    entry.width = bytesOfType(numberIn(directory, at + 2, 2));
    entry.count = numberIn(directory, at + 4, m_wide);
    entry.place = offset + at + 4 + m_wide;
    if (entry.width > 0 && entry.count > m_size / entry.width)
      failCutOff();
    // Values too long for the entry itself lie where it points to.
    if (entry.width * entry.count > m_wide)
      entry.place = numberIn(directory, at + 4 + m_wide, m_wide);
    requireInside(entry.place, entry.width * entry.count);
    return entry;
  }

  std::vector<std::uint64_t> valuesOf(const Entry& entry) {
    if (entry.width == 0)
      return {};
    if (entry.count > mostPieces)
      failCutOff();
    // Pages that share their lists would be read again and again.
    m_listed += entry.width * entry.count;
    if (m_listed > 2 * m_size)
      failCutOff();
    const std::string bytes = bytesAt(entry.place, entry.width * entry.count);
    std::vector<std::uint64_t> values(entry.count);
    for (std::uint64_t i = 0; i < entry.count; ++i)
      values[i] = numberIn(bytes, i * entry.width, entry.width);
    return values;
  }

  std::string bytesAt(std::uint64_t offset, std::uint64_t count) {
    requireInside(offset, count);
    std::string bytes(count, '\0');
    m_stream.seekg(static_cast<std::streamoff>(offset));
    if (!m_stream.read(bytes.data(), static_cast<std::streamsize>(count)))
      failCutOff();
    return bytes;
  }

  std::uint64_t numberIn(const std::string& text, std::uint64_t at, std::uint64_t bytes) const {
    std::uint64_t value = 0;
    for (std::uint64_t i = 0; i < bytes; ++i)
      value = value << 8 | static_cast<unsigned char>(text[at + (m_isBigEndian ? i : bytes - 1 - i)]);
    return value;
  }

  std::uint64_t number(std::uint64_t offset, std::uint64_t bytes) {
    return numberIn(bytesAt(offset, bytes), 0, bytes);
  }

  fs::path m_file;
  std::uint64_t m_size;
  std::ifstream m_stream;
  bool m_isBigEndian = false;
  bool m_isBig = false;
  std::uint64_t m_wide = 4; // bytes of an offset
  std::set<std::uint64_t> m_passed;
  std::uint64_t m_listed = 0; // bytes of all lists
};

} // namespace

int tiffPages(const fs::path& file) {
  TiffDirectories tiff(file);
  int pages = 0;
  for (std::uint64_t at = tiff.firstDirectory(); at != 0; at = tiff.passDirectory(at))
    if (++pages > mostPages)
      tiff.failCutOff();
  return pages;
}

} // namespace limn
