// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/PictureStack.h"

#include "io/formats/ReadError.h"
#include "io/formats/TiffPages.h"
#include "io/formats/Voxels.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

namespace limn {
namespace {

namespace fs = std::filesystem;
using OIIO::TypeDesc;

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

// One page as OpenImageIO gives it.
struct Page {
  OIIO::ImageSpec spec;
  bool operator==(const Page& other) const {
    return spec.width == other.spec.width && spec.height == other.spec.height &&
           spec.nchannels == other.spec.nchannels && spec.format == other.spec.format;
  }
};

TypeDesc keptFormat(const fs::path& file, TypeDesc stored) {
  switch (stored.basetype) {
  case TypeDesc::HALF:
    return TypeDesc::FLOAT;
  case TypeDesc::UINT64:
  case TypeDesc::INT64:
    return TypeDesc::DOUBLE;
  case TypeDesc::UINT8:
  case TypeDesc::INT8:
  case TypeDesc::UINT16:
  case TypeDesc::INT16:
  case TypeDesc::UINT32:
  case TypeDesc::INT32:
  case TypeDesc::FLOAT:
  case TypeDesc::DOUBLE:
    return stored;
  default:
    failReading(file, "its samples are of a type that is not supported", "convert it to 8 or 16 bits first");
  }
}

VoxelArray emptyArray(TypeDesc format) {
  switch (format.basetype) {
  case TypeDesc::UINT8:
    return std::vector<std::uint8_t>();
  case TypeDesc::INT8:
    return std::vector<std::int8_t>();
  case TypeDesc::UINT16:
    return std::vector<std::uint16_t>();
  case TypeDesc::INT16:
    return std::vector<std::int16_t>();
  case TypeDesc::UINT32:
    return std::vector<std::uint32_t>();
  case TypeDesc::INT32:
    return std::vector<std::int32_t>();
  case TypeDesc::FLOAT:
    return std::vector<float>();
  default:
    return std::vector<double>();
  }
}

// Refuses a header that asks for more pixels than its file can hold: the best compression that the formats
// know is deflate's, 1032 to 1, of pixels of one bit.
void requireRoom(const fs::path& file, const OIIO::ImageSpec& spec) {
  constexpr std::uint64_t largestRatio = 8 * 1032;
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 ||
      spec.image_bytes() / largestRatio > fs::file_size(file))
    failReading(file, "its header asks for more pixels than the file can hold", copyAgain);
}

// Refuses a JPEG file without the mark of its end: the decoder fills what is missing with grey.
void requireJpegEnd(const fs::path& file) {
  using namespace std::string_view_literals;
  constexpr std::streamoff tailBytes = 4096;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  stream.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(stream.tellg()) - tailBytes));
  const std::string tail{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (tail.rfind("\xff\xd9"sv) == std::string::npos)
    failReading(file, "the picture is cut off", copyAgain);
}

// Collects slices that all look like the first.
class Stack {
public:
  explicit Stack(fs::path path) : m_path(std::move(path)) {}

  // Reads the page the input stands at; `expectedSlices` only guides the room made.
  void addPage(OIIO::ImageInput& input, const fs::path& file, int page, std::size_t expectedSlices) {
    if (!input.seek_subimage(page, 0))
      failReading(file, "the picture is damaged (" + input.geterror() + ")", copyAgain);
    const Page current{input.spec_dimensions(page)};
    requireRoom(file, current.spec);
    if (m_slices == 0) {
      m_first = current;
      m_format = keptFormat(file, current.spec.format);
      m_stored = emptyArray(m_format);
    } else if (!(current == m_first)) {
      failReading(m_path,
                  "its picture " + file.filename().string() + " (page " + std::to_string(page + 1) +
                      ") has another size or type than the first",
                  "keep only the slices of one stack in the folder");
    }
    std::visit([&](auto& voxels) { readInto(voxels, input, file, page, expectedSlices); }, m_stored);
    ++m_slices;
  }

  VolumeParts parts() && {
    VolumeParts parts;
    parts.grid.dims = {m_first.spec.width, m_first.spec.height, m_slices};
    parts.stored = std::move(m_stored);
    parts.info.spacingKnown = false;
    parts.info.orientationKnown = false;
    if (m_first.spec.nchannels > 2)
      parts.info.warnings.emplace_back(colorWarning);
    return parts;
  }

private:
  template <class T>
  void readInto(std::vector<T>& voxels, OIIO::ImageInput& input, const fs::path& file, int page,
                std::size_t expectedSlices) {
    const auto pixels =
        static_cast<std::size_t>(m_first.spec.width) * static_cast<std::size_t>(m_first.spec.height);
    const auto channels = static_cast<std::size_t>(m_first.spec.nchannels);
    std::vector<T> samples(pixels * channels);
    if (!input.read_image(page, 0, 0, static_cast<int>(channels), m_format, samples.data()))
      failReading(file, "the picture is damaged (" + input.geterror() + ")", copyAgain);
    if (m_slices == 0)
      voxels.reserve(pixels * expectedSlices);
    if (channels == 1) {
      voxels.insert(voxels.end(), samples.begin(), samples.end());
      return;
    }
    for (std::size_t i = 0; i < pixels; ++i) {
      double values[4] = {};
      for (std::size_t c = 0; c < std::min<std::size_t>(channels, 4); ++c)
        values[c] = static_cast<double>(samples[i * channels + c]);
      const double luma = luminance(values, static_cast<int>(channels));
      voxels.push_back(static_cast<T>(std::is_integral_v<T> ? std::round(luma) : luma));
    }
  }

  fs::path m_path;
  Page m_first;
  TypeDesc m_format;
  VoxelArray m_stored;
  int m_slices = 0;
};

void reportStep(const Progress& progress, std::size_t done, std::size_t all) {
  if (progress.isCancelled && progress.isCancelled())
    throw Cancelled();
  if (progress.report)
    progress.report(static_cast<double>(done) / static_cast<double>(all), "Reading slices");
}

std::unique_ptr<OIIO::ImageInput> openPicture(const fs::path& file) {
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(file.string(), &wishes);
  if (!input)
    failReading(file, "the picture is damaged (" + OIIO::geterror() + ")", copyAgain);
  return input;
}

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
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.') &&
        !kindOf(entry.path()).empty())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return naturalLess(a.filename().string(), b.filename().string());
  });
  return files;
}

VolumeParts readPictures(const fs::path& path, const std::vector<fs::path>& files, const Progress& progress) {
  Stack stack(path);
  std::set<std::string> kinds;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string kind = kindOf(files[i]);
    kinds.insert(kind);
    if (kind == "JPEG")
      requireJpegEnd(files[i]);
    const int pages = kind == "TIFF" ? tiffPages(files[i]) : 1;
    const auto input = openPicture(files[i]);
    if (files.size() > 1 && pages > 1)
      failReading(path, "its picture " + files[i].filename().string() + " has several pages",
                  "open that file by itself");
    if (files.size() == 1 && pages == 1)
      failReading(files[i], "it is a single picture, and a volume needs a stack of slices",
                  "open the folder that holds all slices, or a TIFF file with several pages");
    for (int page = 0; page < pages; ++page) {
      const std::size_t slices = std::max(files.size(), static_cast<std::size_t>(pages));
      reportStep(progress, i + static_cast<std::size_t>(page), slices);
      stack.addPage(*input, files[i], page, slices);
    }
  }
  if (kinds.size() > 1)
    failReading(path, "it holds pictures of several kinds",
                "keep only the slices of one stack in the folder");
  VolumeParts parts = std::move(stack).parts();
  parts.info.format = *kinds.begin() + " stack";
  if (kinds.contains("JPEG"))
    parts.info.warnings.emplace_back("JPEG compression is lossy: the values are not the original ones.");
  if (!numbersAreEven(files))
    parts.info.warnings.emplace_back("The numbers in the file names are uneven: slices may be missing.");
  return parts;
}

} // namespace limn
