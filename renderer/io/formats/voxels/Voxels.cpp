// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/voxels/Voxels.h"

#include "io/formats/voxels/BoxOfVoxels.h"
#include "io/reading/Bounds.h"
#include "io/reading/HeaderText.h"
#include "io/reading/PartOfVolume.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <bit>
#include <charconv>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t bytesPerStep = 1 << 20;

// Makes room for `step` more voxels, at most doubling what has been filled from real bytes.
template <class T>
void growBy(RoomVector<T>& voxels, std::size_t step, std::uint64_t final) {
  const std::size_t wanted = voxels.size() + step;
  if (wanted > voxels.capacity())
    voxels.reserve(std::min<std::uint64_t>(final, std::max(wanted, 2 * voxels.capacity())));
  voxels.resize(wanted);
}

template <class Stored>
RoomVector<Kept<Stored>> readAs(const fs::path& file, const ByteReader& bytes, const VoxelLayout& layout,
                                const Progress& progress, std::uint64_t certain,
                                const std::shared_ptr<Room>& room) {
  const auto components = static_cast<std::size_t>(layout.components);
  const std::size_t perStep =
      std::min<std::uint64_t>(bytesPerStep / sizeof(Stored) / components, layout.count);
  const auto read = [&](Stored* samples, std::size_t done, std::size_t step) {
    const std::size_t wanted = step * components * sizeof(Stored);
    const std::size_t got = bytes(reinterpret_cast<unsigned char*>(samples), wanted);
    if (got < wanted)
      failShort(file, done + got / (components * sizeof(Stored)), layout.count);
    toNativeOrder(samples, step * components, layout);
  };
  std::vector<Stored> samples;
  RoomVector<Kept<Stored>> voxels(room);
  // Growing on the disk would copy; and what was reserved there in vain is given back.
  voxels.reserve(room ? layout.count : certain);
  while (voxels.size() < layout.count) {
    reportOrStop(progress, static_cast<double>(voxels.size()) / static_cast<double>(layout.count),
                 Message::tr("Reading voxels"));
    const std::size_t first = voxels.size();
    const std::size_t step = std::min<std::uint64_t>(perStep, layout.count - first);
    if constexpr (std::is_same_v<Stored, Kept<Stored>>)
      if (components == 1) { // where they stay
        growBy(voxels, step, layout.count);
        read(voxels.data() + first, first, step);
        continue;
      }
    samples.resize(step * components);
    read(samples.data(), first, step);
    growBy(voxels, step, layout.count);
    for (std::size_t i = 0; i < step; ++i)
      voxels[first + i] = keptValue(samples.data() + i * components, layout.components);
  }
  reportOrStop(progress, 1.0, Message::tr("Reading voxels"));
  return voxels;
}

// Of the voxels as they are kept: colours are one value then.
double bytesKept(const VoxelLayout& layout) {
  return static_cast<double>(layout.count) * static_cast<double>(bytesPerVoxel(layout.type));
}

// Whether the bytes behind the first volume are as many as the header says.
void noteSurplus(const ByteLocation& location, const VoxelLayout& layout, bool moreFollows,
                 std::vector<Message>& warnings) {
  if (layout.volumes == 1 && layout.endsFile && moreFollows)
    warnings.emplace_back(surplusWarning);
  if (layout.volumes == 1 || location.encoding != Encoding::raw)
    return;
  const std::uint64_t held = fs::file_size(location.file) - location.offset - location.skip;
  const std::uint64_t bytes = bytesOf(layout);
  if (held / bytes < layout.volumes)
    warnings.emplace_back(Message::tr("The file ends before the last of its volumes: it may be cut off."));
  else if (held > bytes * layout.volumes)
    warnings.emplace_back(surplusWarning);
}

constexpr std::size_t textBytesPerStep = 1 << 16;
constexpr std::size_t voxelsPerReport = 1 << 18;
constexpr std::size_t longestWord = 400; // of a number written out: 10³⁰⁸ and its fraction

bool isWithin(const glm::ivec3& voxel, const VoxelBox& box) {
  return glm::all(glm::greaterThanEqual(voxel, box.lower)) && glm::all(glm::lessThan(voxel, box.upper));
}

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
                                const glm::ivec3& dims, const VoxelBox& box, const Progress& progress,
                                const std::shared_ptr<Room>& room) {
  RoomVector<Kept<Stored>> voxels(room);
  voxels.reserve(voxelsIn(box));
  const auto width = static_cast<std::uint64_t>(dims.x), height = static_cast<std::uint64_t>(dims.y);
  for (std::uint64_t n = 0; n < layout.count; ++n) {
    const std::string_view word = words.next();
    if (word.empty())
      failShort(file, n, layout.count);
    const auto value = static_cast<Kept<Stored>>(numberIn<Stored>(file, word));
    if (isWithin(glm::ivec3(n % width, n / width % height, n / (width * height)), box))
      voxels.push_back(value);
    if (n % voxelsPerReport == 0)
      reportOrStop(progress, static_cast<double>(n) / static_cast<double>(layout.count),
                   Message::tr("Reading voxels"));
  }
  return voxels;
}

bool mapVoxels(const ByteLocation& location, const VoxelLayout& layout, const MemoryBudget& budget,
               VolumeParts& parts) {
  const bool isNative = layout.bigEndian == (std::endian::native == std::endian::big);
  const std::uint64_t offset = location.offset + location.skip;
  return withStoredType(layout.type, [&](auto value) {
    using Stored = decltype(value);
    if constexpr (std::is_same_v<Stored, Kept<Stored>>)
      if (location.encoding == Encoding::raw && layout.components == 1 &&
          bytesKept(layout) > budget.unmappedBytes() && (isNative || sizeof(Stored) == 1) &&
          offset % alignof(Stored) == 0) {
        parts.room = std::make_shared<Room>();
        const auto bytes = parts.room->mapped(location.file, offset, bytesOf(layout));
        const auto* first = reinterpret_cast<const Stored*>(bytes.get());
        parts.stored = StoredVoxels<Stored>(std::span(first, layout.count), bytes);
        return true;
      }
    return false;
  });
}

} // namespace

std::size_t bytesPerVoxel(VoxelType type) {
  return withStoredType(type, [](auto value) { return sizeof(value); });
}

void failShort(const fs::path& file, std::uint64_t got, std::uint64_t wanted) {
  failReading(file,
              Message::tr("its voxels end after %1 of the %2 that its header asks for").arg(got, wanted),
              copyAgain);
}

std::uint64_t bytesOf(const VoxelLayout& layout) {
  return layout.count * static_cast<std::uint64_t>(layout.components) * bytesPerVoxel(layout.type);
}

std::uint64_t voxelCount(const fs::path& file, const glm::ivec3& dims) {
  constexpr std::uint64_t most = std::uint64_t{1} << 40;
  std::uint64_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const Message given =
        Message::tr("its header gives the dimensions %1 x %2 x %3").arg(dims.x, dims.y, dims.z);
    if (dims[axis] < 1)
      failReading(file, Message::tr("%1, which leave no voxels").arg(given), copyAgain);
    if (count > most / static_cast<std::uint64_t>(dims[axis]))
      failReading(
          file, Message::tr("%1, which is too large for any computer").arg(given),
          Message::tr(
              "if they are right, save a smaller part of the volume; otherwise export the file again"));
    count *= static_cast<std::uint64_t>(dims[axis]);
  }
  return count;
}

int dimension(const fs::path& file, double value) {
  if (!(value >= 1.0) || value > 2147483647.0 || value != std::floor(value))
    failReading(file, Message::tr("its header gives a dimension that is not a positive whole number"),
                copyAgain);
  return static_cast<int>(value);
}

VoxelType typeNamed(const fs::path& file, const std::string& name,
                    const std::map<std::string, VoxelType>& types) {
  const auto found = types.find(name);
  if (found == types.end())
    failReading(file, Message::tr("its voxels are of the type \"%1\", which is not supported").arg(name),
                Message::tr("convert it to integers or floats first"));
  return found->second;
}

int componentCount(const fs::path& file, const std::string& text) {
  const double count = text.empty() ? 1.0 : number(file, text);
  if (count != 1.0 && count != 3.0 && count != 4.0)
    failReading(file, Message::tr("it holds %1 values per voxel, and a volume needs one").arg(text),
                Message::tr("save one component as a volume of its own"));
  return static_cast<int>(count);
}

void noteLayout(const VoxelLayout& layout, std::vector<Message>& warnings) {
  if (layout.volumes > 1)
    warnings.push_back(Message::tr("The file holds %1 volumes; the first is shown.").arg(layout.volumes));
  if (layout.components > 1)
    warnings.emplace_back(colorWarning);
}

void readVoxels(const fs::path& file, const ByteReader& bytes, const VoxelLayout& layout,
                const VoxelKeeping& keeping, const Progress& progress, std::uint64_t certain,
                VolumeParts& parts) {
  if (keeping.box) {
    const RunReader read = passing(file, bytes, layout);
    readBox(file, read, layout, keeping.box(parts.grid, false), keeping.budget, progress, parts);
    read(bytesOf(layout), nullptr, 0); // the others must be there, too
    parts.info.warnings.emplace_back(notInParts);
    return;
  }
  parts.room = roomFor(file, bytesKept(layout), keeping.budget, parts.info.warnings);
  withStoredType(layout.type, [&](auto value) {
    parts.stored = readAs<decltype(value)>(file, bytes, layout, progress, certain, parts.room);
  });
}

bool readInPlace(const ByteLocation& location, const VoxelLayout& layout, const VoxelKeeping& keeping,
                 const Progress& progress, VolumeParts& parts) {
  if (!keeping.box || location.encoding != Encoding::raw)
    return mapVoxels(location, layout, keeping.budget, parts);
  const VoxelBox box = keeping.box(parts.grid, false);
  const bool isLarge = bytesKept(layout, box) > keeping.budget.voxelBytes();
  if (!isLarge || !mapVoxels(location, layout, keeping.budget.mappingAll(), parts))
    readBox(location.file, seeking(location), layout, box, keeping.budget, progress, parts);
  return true;
}

void readVoxels(const ByteLocation& location, const VoxelLayout& layout, const VoxelKeeping& keeping,
                const Progress& progress, VolumeParts& parts) {
  const ByteReader bytes = openBytes(location, bytesOf(layout));
  if (readInPlace(location, layout, keeping, progress, parts)) {
    const std::uint64_t end = location.offset + location.skip + bytesOf(layout);
    noteSurplus(location, layout, fs::file_size(location.file) > end, parts.info.warnings);
    return;
  }
  const bool isChecked = location.encoding == Encoding::raw;
  readVoxels(location.file, bytes, layout, keeping, progress, isChecked ? layout.count : 0, parts);
  // At the end of compressed data this makes zlib compare the check sum.
  unsigned char beyond = 0;
  noteSurplus(location, layout, bytes(&beyond, 1) > 0, parts.info.warnings);
}

double luminance(const double* samples, int components) {
  if (components < 3)
    return samples[0];
  return 0.2126 * samples[0] + 0.7152 * samples[1] + 0.0722 * samples[2];
}

void readTextVoxels(const fs::path& file, const ByteReader& text, const VoxelLayout& layout,
                    const VoxelKeeping& keeping, const Progress& progress, bool mayBeCut,
                    VolumeParts& parts) {
  if (layout.components != 1)
    failReading(file, Message::tr("it holds colours as text"),
                Message::tr("convert it to a binary encoding"));
  std::vector<Message>& warnings = parts.info.warnings;
  const glm::ivec3 dims = parts.grid.dims;
  VoxelBox box{glm::ivec3(0), dims};
  if (keeping.box) {
    box = keeping.box(parts.grid, false);
    parts.held = box;
    warnings.emplace_back(notInParts);
  }
  parts.room = roomFor(file, bytesKept(layout, box), keeping.budget, warnings);
  Words words(file, text);
  withStoredType(layout.type, [&](auto value) {
    parts.stored = readAs<decltype(value)>(file, words, layout, dims, box, progress, parts.room);
  });
  const bool isFollowed = !words.next().empty();
  if (isFollowed && layout.volumes == 1 && layout.endsFile)
    warnings.emplace_back(surplusWarning);
  if (mayBeCut && !isFollowed && words.touchesEnd())
    warnings.emplace_back(Message::tr("The text ends right behind its last number, which may be cut off."));
}

void readTextVoxels(const ByteLocation& location, const VoxelLayout& layout, const VoxelKeeping& keeping,
                    const Progress& progress, VolumeParts& parts) {
  // The shortest voxel is a digit, and white space parts it from the next.
  readTextVoxels(location.file, openBytes(location, 2 * layout.count - 1), layout, keeping, progress, true,
                 parts);
}

} // namespace limn
