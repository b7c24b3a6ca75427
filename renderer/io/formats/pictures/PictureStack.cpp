// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/pictures/PictureStack.h"

#include "io/formats/voxels/BoxOfVoxels.h"
#include "io/openimageio/PictureLibrary.h"
#include "io/reading/Bounds.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

namespace limn {
namespace {

namespace fs = std::filesystem;

// The library keeps the segments before a picture in a list and walks it for each.
constexpr int mostSegments = 4096;
// Pixels come in chunks of 8 KiB and more.
constexpr int mostChunks = 1 << 20;

[[noreturn]] void failDamagedPicture(const fs::path& file) {
  failReading(file, Message::tr("the picture is damaged or cut off"), copyAgain);
}

VoxelType typeOfSample(const fs::path& file, StoredPicture::Sample stored) {
  switch (stored) {
  case StoredPicture::Sample::uint8:
    return VoxelType::uint8;
  case StoredPicture::Sample::uint16:
    return VoxelType::uint16;
  case StoredPicture::Sample::float32:
  case StoredPicture::Sample::other:
    break;
  }
  failReading(file, Message::tr("its samples are of a type that is not supported"),
              Message::tr("convert it to 8 or 16 bits first"));
}

// Walks the segments of a JPEG file up to its pixels. Throws where there are more than any camera writes, or
// no mark of the end follows: the decoder fills what is missing with grey.
void requireSoundJpeg(const fs::path& file) {
  using namespace std::string_view_literals;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(2);
  for (int segments = 0;; ++segments) {
    int mark = stream.get();
    while (mark == 0xff)
      mark = stream.get();
    const int high = stream.get();
    const int low = stream.get();
    if (!stream || segments > mostSegments)
      failDamagedPicture(file);
    if (mark == 0xda)
      break;
    stream.seekg((high << 8 | low) - 2, std::ios::cur);
    if (stream.get() != 0xff)
      failDamagedPicture(file);
  }
  constexpr std::streamoff tailBytes = 4096;
  stream.clear();
  stream.seekg(0, std::ios::end);
  stream.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(stream.tellg()) - tailBytes));
  const std::string tail{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (tail.rfind("\xff\xd9"sv) == std::string::npos)
    failReading(file, Message::tr("the picture is cut off"), copyAgain);
}

// Walks the chunks of a PNG file to its end, so that a picture that is cut off never reaches the decoder,
// which prints its own complaints.
void requireWholePng(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(8);
  std::string head(8, '\0');
  for (int chunks = 0; chunks < mostChunks && stream.read(head.data(), 8); ++chunks) {
    if (head.ends_with("IEND"))
      return;
    std::uint32_t length = 0;
    for (int i = 0; i < 4; ++i)
      length = length << 8 | static_cast<unsigned char>(head[static_cast<std::size_t>(i)]);
    stream.seekg(static_cast<std::streamoff>(length) + 4, std::ios::cur);
  }
  failReading(file, Message::tr("the picture is cut off"), copyAgain);
}

bool isJpeg(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return stream.get() == 0xff;
}

constexpr std::size_t bytesPerBand = 1 << 20;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

// Takes the run of digits at `at` without its leading zeros.
std::string_view takeDigits(std::string_view text, std::size_t& at) {
  while (at < text.size() && text[at] == '0')
    ++at;
  const std::size_t first = at;
  while (at < text.size() && isDigit(text[at]))
    ++at;
  return text.substr(first, at - first);
}

// The kind of picture by its first bytes; empty where it is none.
std::string kindOf(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv))
    return "PNG";
  if (bytes.starts_with("\xff\xd8\xff"sv))
    return "JPEG";
  for (const std::string_view magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
    if (bytes.starts_with(magic))
      return "TIFF";
  return {};
}

std::string kindOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(8, '\0');
  stream.read(bytes.data(), 8);
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return kindOf(std::string_view(bytes));
}

// Collects slices that all look like the first, or the voxels of a box of them.
class Stack {
public:
  Stack(fs::path path, const VoxelKeeping& keeping) : m_path(std::move(path)), m_keeping(keeping) {}

  // Whether the next slice must be opened at all: the first tells what all are.
  bool needsNext() const { return m_slices == 0 || isKept(m_slices); }

  // In place of `add`, where it is not.
  void pass() { ++m_slices; }

  // Reads a picture. There will be so many slices.
  void add(const Picture& picture, const fs::path& file, int page, std::size_t expectedSlices) {
    if (m_slices == 0)
      start(picture.shape, expectedSlices);
    else if (picture.shape != m_shape)
      failReading(m_path,
                  Message::tr("its picture %1 (page %2) has another size or type than the first")
                      .arg(file.filename().string(), page + 1),
                  Message::tr("keep only the slices of one stack in the folder"));
    if (isKept(m_slices))
      withStoredType(m_shape.type, [&](auto value) { append<decltype(value)>(picture); });
    ++m_slices;
  }

  VolumeParts parts() && {
    VolumeParts parts = std::move(m_parts);
    parts.grid.dims = {m_shape.width, m_shape.height, m_slices};
    parts.stored = storedVoxels(std::move(m_stored));
    if (m_keeping.box)
      parts.held = m_box;
    parts.info.spacingKnown = false;
    parts.info.orientationKnown = false;
    if (m_shape.channels > 2)
      parts.info.warnings.emplace_back(colorWarning);
    return parts;
  }

private:
  bool isKept(int slice) const { return slice >= m_box.lower.z && slice < m_box.upper.z; }

  void start(const PictureShape& shape, std::size_t expectedSlices) {
    m_shape = shape;
    Grid grid;
    grid.dims = {shape.width, shape.height, static_cast<int>(expectedSlices)};
    m_box = m_keeping.box ? m_keeping.box(grid, true) : VoxelBox{glm::ivec3(0), grid.dims};
    const std::size_t voxels = voxelsIn(m_box);
    m_parts.room =
        roomFor(m_path, static_cast<double>(voxels) * static_cast<double>(bytesPerVoxel(shape.type)),
                m_keeping.budget, m_parts.info.warnings);
    withStoredType(shape.type, [&](auto value) {
      RoomVector<Kept<decltype(value)>> stored(m_parts.room);
      stored.reserve(voxels);
      m_stored = std::move(stored);
    });
  }

  // Decodes band after band, so that a picture that promises more than it holds takes little memory.
  template <class Stored>
  void append(const Picture& picture) {
    auto& voxels = std::get<RoomVector<Kept<Stored>>>(m_stored);
    const auto channels = static_cast<std::size_t>(m_shape.channels);
    const auto width = static_cast<std::size_t>(m_shape.width);
    const auto band = static_cast<int>(std::max<std::size_t>(1, bytesPerBand / rowBytes(m_shape)));
    const auto first = static_cast<std::size_t>(m_box.lower.x), end = static_cast<std::size_t>(m_box.upper.x);
    std::vector<Stored> samples;
    for (int y = 0; y < m_box.upper.y; y += band) {
      const int rows = std::min(band, m_box.upper.y - y);
      samples.resize(width * channels * static_cast<std::size_t>(rows));
      picture.readRows(reinterpret_cast<unsigned char*>(samples.data()), y, rows);
      for (int row = std::max(m_box.lower.y - y, 0); row < rows; ++row)
        for (std::size_t i = first; i < end; ++i)
          voxels.push_back(keptValue(samples.data() + (static_cast<std::size_t>(row) * width + i) * channels,
                                     m_shape.channels));
    }
  }

  fs::path m_path;
  VoxelKeeping m_keeping;
  VoxelBox m_box; // of the voxels that are kept, once the first picture is known
  VolumeParts m_parts;
  PictureShape m_shape;
  VoxelVectors m_stored;
  int m_slices = 0;
};

// Whether the last numbers in the names rise by one step throughout.
bool numbersAreEven(const std::vector<fs::path>& files) {
  std::set<long long> steps;
  std::optional<long long> last;
  for (const fs::path& file : files) {
    const std::string stem = file.stem().string();
    const std::size_t end = stem.find_last_of("0123456789");
    if (end == std::string::npos || end > 17 + stem.find_last_not_of("0123456789", end))
      return true;
    const std::size_t before = stem.find_last_not_of("0123456789", end);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    const long long number = std::stoll(stem.substr(first, std::min<std::size_t>(end - first + 1, 17)));
    if (last)
      steps.insert(number - *last);
    last = number;
  }
  return steps.size() <= 1;
}

} // namespace

void requireRoom(const fs::path& file, const PictureShape& shape) {
  // The best compression that the formats know is deflate's, 1032 to 1, of pixels of one bit.
  constexpr std::uint64_t largestRatio = 8 * 1032;
  const bool hasPixels = shape.width >= 1 && shape.height >= 1 && shape.channels >= 1;
  if (!hasPixels ||
      rowBytes(shape) * static_cast<std::uint64_t>(shape.height) / largestRatio > fs::file_size(file))
    failReading(file, Message::tr("its header asks for more pixels than the file can hold"), copyAgain);
}

Picture openPicture(const fs::path& file) {
  if (isJpeg(file))
    requireSoundJpeg(file);
  else
    requireWholePng(file);
  const std::optional<StoredPicture> stored = pictureLibrary().open(file.string());
  if (!stored)
    failDamagedPicture(file);
  Picture picture;
  picture.shape = {stored->width, stored->height, stored->channels, typeOfSample(file, stored->sample)};
  requireRoom(file, picture.shape);
  picture.readRows = [read = stored->readRows, file](unsigned char* to, int first, int count) {
    if (!read(to, first, count))
      failDamagedPicture(file);
  };
  return picture;
}

bool isPicture(std::string_view bytes) {
  return !kindOf(bytes).empty();
}

bool naturalLess(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string_view x = takeDigits(a, i);
      const std::string_view y = takeDigits(b, j);
      if (x != y)
        return x.size() != y.size() ? x.size() < y.size() : x < y;
    } else if (a[i] != b[j]) {
      return a[i] < b[j];
    } else {
      ++i;
      ++j;
    }
  }
  return a.size() - i < b.size() - j;
}

std::vector<fs::path> picturesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (std::error_code ignored; entry.is_regular_file(ignored) &&
                                 !entry.path().filename().string().starts_with('.') &&
                                 !kindOf(entry.path()).empty())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return naturalLess(a.filename().string(), b.filename().string());
  });
  return files;
}

void requireWholeStack(const fs::path& folder, const std::vector<fs::path>& pictures) {
  NameLikeness names;
  for (const fs::path& picture : pictures)
    names.add(picture);
  std::set<fs::path> lost;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (std::error_code ignored; entry.is_regular_file(ignored) && names.isLike(entry.path()) &&
                                 std::find(pictures.begin(), pictures.end(), entry.path()) == pictures.end())
      lost.insert(entry.path());
  if (lost.empty())
    return;
  const fs::path& first = *lost.begin();
  std::error_code ignored;
  failReading(first,
              Message::tr("%1, so that a slice is missing from the stack")
                  .arg(fs::file_size(first, ignored) == 0
                           ? Message::tr("the file is empty")
                           : Message::tr("it does not start as a picture does")),
              Message::tr("copy it again, or take it out of the folder if it is no slice"));
}

VolumeParts readPictures(const fs::path& path, const std::vector<fs::path>& files,
                         const VoxelKeeping& keeping, const Progress& progress) {
  Stack stack(path, keeping);
  std::set<std::string> kinds;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string kind = kindOf(files[i]);
    kinds.insert(kind);
    if (files.size() > 1 && !stack.needsNext()) {
      reportOrStop(progress, static_cast<double>(i) / static_cast<double>(files.size()),
                   Message::tr("Reading slices"));
      stack.pass();
      continue;
    }
    const int pages = kind == "TIFF" ? tiffPages(files[i]) : 1;
    if (files.size() > 1 && pages > 1)
      failReading(path, Message::tr("its picture %1 has several pages").arg(files[i].filename().string()),
                  Message::tr("open that file by itself"));
    if (files.size() == 1 && pages == 1)
      failReading(files[i], Message::tr("it is a single picture, and a volume needs a stack of slices"),
                  Message::tr("open the folder that holds all slices, or a TIFF file with several pages"));
    const std::size_t slices = std::max(files.size(), static_cast<std::size_t>(pages));
    int page = 0;
    const auto add = [&](const Picture& picture) {
      reportOrStop(progress,
                   static_cast<double>(i + static_cast<std::size_t>(page)) / static_cast<double>(slices),
                   Message::tr("Reading slices"));
      stack.add(picture, files[i], page++, slices);
    };
    if (kind == "TIFF")
      forEachTiffPage(files[i], add);
    else
      add(openPicture(files[i]));
  }
  if (kinds.size() > 1)
    failReading(path, Message::tr("it holds pictures of several kinds"),
                Message::tr("keep only the slices of one stack in the folder"));
  VolumeParts parts = std::move(stack).parts();
  parts.info.format = *kinds.begin() + " stack";
  if (kinds.contains("JPEG"))
    parts.info.warnings.emplace_back(
        Message::tr("JPEG compression is lossy: the values are not the original ones."));
  if (!numbersAreEven(files))
    parts.info.warnings.emplace_back(
        Message::tr("The numbers in the file names are uneven: slices may be missing."));
  return parts;
}

} // namespace limn
