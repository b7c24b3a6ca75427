// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/voxels/TextVoxels.h"

#include "io/formats/voxels/StoredType.h"
#include "io/reading/Bounds.h"
#include "io/reading/ReadError.h"

#include <charconv>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t textBytesPerStep = 1 << 16;
constexpr std::size_t voxelsPerReport = 1 << 18;
constexpr std::size_t longestWord = 400; // of a number written out: 10³⁰⁸ and its fraction

bool isBlank(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

// Takes words off a text as it arrives.
class Words {
public:
  Words(fs::path file, ByteReader text) : m_file(std::move(file)), m_text(std::move(text)) {}

  // The next word, valid until the one after it is asked for; empty at the end.
  std::string_view next() {
    while (m_at == m_buffer.size() || isBlank(m_buffer[m_at]))
      if (m_at < m_buffer.size())
        ++m_at;
      else if (!refill())
        return {};
    std::size_t end = m_at;
    while (true) {
      while (end < m_buffer.size() && !isBlank(m_buffer[end]))
        ++end;
      if (end < m_buffer.size() || end - m_at > longestWord)
        break;
      const std::size_t length = end - m_at;
      m_touchesEnd = !refill();
      end = m_at + length;
      if (m_touchesEnd)
        break;
    }
    const std::string_view word = std::string_view(m_buffer).substr(m_at, end - m_at);
    m_at = end;
    return word;
  }

  // Whether the last word was not parted from the end of the text.
  bool touchesEnd() const { return m_touchesEnd; }

private:
  // Drops what was taken and appends what follows; false where nothing does.
  bool refill() {
    m_buffer.erase(0, m_at);
    m_at = 0;
    const std::size_t kept = m_buffer.size();
    m_buffer.resize(kept + textBytesPerStep);
    m_buffer.resize(kept +
                    m_text(reinterpret_cast<unsigned char*>(m_buffer.data() + kept), textBytesPerStep));
    return m_buffer.size() > kept;
  }

  fs::path m_file;
  ByteReader m_text;
  std::string m_buffer;
  std::size_t m_at = 0;
  bool m_touchesEnd = false;
};

template <class Stored>
Stored numberIn(const fs::path& file, std::string_view word) {
  Stored value{};
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem != std::errc{} || end != word.data() + word.size())
    failReading(file, Message::tr("a voxel's text is not a number of the type that the header names"),
                copyAgain);
  return value;
}

template <class Stored>
RoomVector<Kept<Stored>> readAs(const fs::path& file, Words& words, const VoxelLayout& layout,
                                const Progress& progress, const std::shared_ptr<Room>& room) {
  RoomVector<Kept<Stored>> voxels(room);
  voxels.reserve(layout.count);
  while (voxels.size() < layout.count) {
    const std::string_view word = words.next();
    if (word.empty())
      failShort(file, voxels.size(), layout.count);
    voxels.push_back(static_cast<Kept<Stored>>(numberIn<Stored>(file, word)));
    if (voxels.size() % voxelsPerReport == 0)
      reportOrStop(progress, static_cast<double>(voxels.size()) / static_cast<double>(layout.count),
                   Message::tr("Reading voxels"));
  }
  return voxels;
}

} // namespace

void readTextVoxels(const fs::path& file, const ByteReader& text, const VoxelLayout& layout,
                    const MemoryBudget& budget, const Progress& progress, bool mayBeCut, VolumeParts& parts) {
  if (layout.components != 1)
    failReading(file, Message::tr("it holds colours as text"),
                Message::tr("convert it to a binary encoding"));
  std::vector<Message>& warnings = parts.info.warnings;
  parts.room =
      roomFor(file, static_cast<double>(layout.count) * static_cast<double>(bytesPerVoxel(layout.type)),
              budget, warnings);
  Words words(file, text);
  withStoredType(layout.type, [&](auto value) {
    parts.stored = readAs<decltype(value)>(file, words, layout, progress, parts.room);
  });
  const bool isFollowed = !words.next().empty();
  if (isFollowed && layout.volumes == 1 && layout.endsFile)
    warnings.emplace_back(surplusWarning);
  if (mayBeCut && !isFollowed && words.touchesEnd())
    warnings.emplace_back(Message::tr("The text ends right behind its last number, which may be cut off."));
}

void readTextVoxels(const ByteLocation& location, const VoxelLayout& layout, const MemoryBudget& budget,
                    const Progress& progress, VolumeParts& parts) {
  // The shortest voxel is a digit, and white space parts it from the next.
  readTextVoxels(location.file, openBytes(location, 2 * layout.count - 1), layout, budget, progress, true,
                 parts);
}

} // namespace limn
