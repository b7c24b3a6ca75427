// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomSegmentation.h"

#include "io/dicom/header/DicomHeader.h"
#include "io/dicom/header/DicomTags.h"
#include "io/reading/Bounds.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// XYZ of white point D50 as linear sRGB, adapted by Bradford (B. Lindbloom, brucelindbloom.com, "RGB/XYZ
// Matrices").
const glm::dmat3 xyzToLinear(3.1338561, -0.9787684, 0.0719453, -1.6168667, 1.9161415, -0.2289914, -0.4906146,
                             0.0334540, 1.4052427);
const glm::dvec3 whiteD50(0.96422, 1.0, 0.82521);

namespace fs = std::filesystem;

constexpr const char* segmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr int mostSlices = 1 << 15;
constexpr std::size_t longestName = 200;

// A frame: the pixels of one segment in one plane.
struct SegmentFrame {
  int segment = 0;
  glm::dvec3 positionMm{0.0};
};

// How the pixels lie in the file.
struct SegmentPixels {
  int columns = 0;
  int rows = 0;
  bool isFractional = false; // a byte a pixel, otherwise a bit
  std::uint32_t half = 1;    // of a fractional one, from which on it counts

  std::uint64_t perFrame() const { return static_cast<std::uint64_t>(columns) * rows; }
  std::uint64_t bitsPerFrame() const { return perFrame() * (isFractional ? 8 : 1); }
};

class SegmentationFile {
public:
  explicit SegmentationFile(const fs::path& path) : m_path(path), m_file(parseDicom(path)) {}

  DicomSegments read(const Progress& progress);

private:
  SegmentPixels pixelsOf() const;
  std::vector<SegmentFrame> framesOf(const SegmentPixels& pixels);
  Grid gridOf(const SegmentPixels& pixels, const std::vector<SegmentFrame>& frames) const;
  std::vector<std::uint16_t> numbersOn(const Grid& grid, const SegmentPixels& pixels,
                                       const std::vector<SegmentFrame>& frames,
                                       const Progress& progress) const;
  std::vector<Label> labels() const;

  fs::path m_path;
  DicomFile m_file;
  DicomFrame m_first; // of which all share the axes and the spacing
};

SegmentPixels SegmentationFile::pixelsOf() const {
  const DicomDataset& data = m_file.dataset;
  SegmentPixels pixels;
  pixels.columns = static_cast<int>(unsignedOf(data, tag::columns).value_or(0));
  pixels.rows = static_cast<int>(unsignedOf(data, tag::rows).value_or(0));
  pixels.isFractional = textOf(data, tag::segmentationType) == "FRACTIONAL";
  pixels.half = (unsignedOf(data, tag::maximumFractionalValue).value_or(255) + 1) / 2;
  if (!m_file.pixels)
    failReading(m_path, Message::tr("it holds no segments"), copyAgain);
  if (m_file.pixels->isEncapsulated)
    failReading(m_path, Message::tr("its segments are compressed"),
                Message::tr("export the segmentation uncompressed"));
  const auto bits = unsignedOf(data, tag::bitsAllocated).value_or(0);
  if (pixels.perFrame() == 0 || bits != (pixels.isFractional ? 8u : 1u))
    failReading(m_path, Message::tr("its header contradicts itself about its pixels"), copyAgain);
  return pixels;
}

// The number in a frame's functional groups, or in those that all frames share.
int segmentOf(const DicomDataset* groups) {
  const DicomDataset* item = groups ? firstItemOf(*groups, tag::segmentIdentificationSequence) : nullptr;
  return item ? static_cast<int>(unsignedOf(*item, tag::referencedSegmentNumber).value_or(0)) : 0;
}

std::vector<SegmentFrame> SegmentationFile::framesOf(const SegmentPixels& pixels) {
  const DicomDataset& data = m_file.dataset;
  const double announced = decimalOf(data, tag::numberOfFrames).value_or(1.0);
  const DicomPixelLocation& place = *m_file.pixels;
  const std::uint64_t present =
      std::min(place.length, place.streamLength - std::min(place.offset, place.streamLength));
  if (!(announced >= 1.0) ||
      announced * static_cast<double>(pixels.bitsPerFrame()) > 8.0 * static_cast<double>(present))
    failReading(m_path, Message::tr("it is too short for the frames that it announces"), copyAgain);
  const int count = static_cast<int>(announced);
  const std::vector<DicomFrame> places = limn::framesOf(data, count);
  m_first = places.front();
  const auto groups = data.elements.find(tag::perFrameFunctionalGroups);
  std::vector<SegmentFrame> frames;
  for (int n = 0; n < count; ++n) {
    const bool isListed =
        groups != data.elements.end() && static_cast<std::size_t>(n) < groups->second.items.size();
    int segment = isListed ? segmentOf(&groups->second.items[static_cast<std::size_t>(n)]) : 0;
    if (segment == 0)
      segment = segmentOf(firstItemOf(data, tag::sharedFunctionalGroups));
    const auto& position = places[static_cast<std::size_t>(n)].positionMm;
    if (segment == 0 || segment > 65535 || !position)
      failReading(m_path, Message::tr("it does not say where its frames lie and which segment each shows"),
                  Message::tr("export it again"));
    frames.push_back({segment, *position});
  }
  if (!m_first.axes || !m_first.pixelSpacingMm)
    failReading(m_path, Message::tr("it does not say how its frames lie in the patient"),
                Message::tr("export it again"));
  return frames;
}

// Planes in line, one step apart or several, because frames without a pixel of their segment may be left out.
Grid SegmentationFile::gridOf(const SegmentPixels& pixels, const std::vector<SegmentFrame>& frames) const {
  const auto& axes = *m_first.axes;
  const glm::dvec3 normal = glm::cross(axes[0], axes[1]);
  const glm::dvec2 spacing = *m_first.pixelSpacingMm;
  std::vector<double> heights;
  heights.reserve(frames.size());
  for (const SegmentFrame& frame : frames)
    heights.push_back(glm::dot(frame.positionMm, normal));
  const auto lowest =
      frames[static_cast<std::size_t>(std::min_element(heights.begin(), heights.end()) - heights.begin())];
  std::sort(heights.begin(), heights.end());
  const double same = 0.01 * std::min(spacing.x, spacing.y);
  double step = m_first.betweenSlicesMm.value_or(0.0);
  for (std::size_t n = 1; n < heights.size(); ++n)
    if (const double gap = heights[n] - heights[n - 1]; gap > same && (step == 0.0 || gap < step))
      step = gap;
  if (step == 0.0)
    step = m_first.thicknessMm.value_or(std::min(spacing.x, spacing.y));
  const double slices = std::round((heights.back() - heights.front()) / step) + 1.0;
  if (slices > mostSlices)
    failReading(m_path, Message::tr("its planes lie too far apart for one volume"), copyAgain);
  for (const SegmentFrame& frame : frames) {
    const glm::dvec3 from = frame.positionMm - lowest.positionMm;
    const double planes = glm::dot(from, normal) / step;
    const double aside = glm::length(from - glm::dot(from, normal) * normal);
    if (std::abs(planes - std::round(planes)) > 0.1 || aside > 0.1 * std::min(spacing.x, spacing.y))
      failReading(m_path, Message::tr("its planes make no even stack"),
                  Message::tr("export the segmentation as NRRD or NIfTI"));
  }
  Grid grid;
  grid.dims = {pixels.columns, pixels.rows, static_cast<int>(slices)};
  grid.spacingMm = {spacing, step};
  grid.originMm = lowest.positionMm;
  grid.direction = glm::dmat3(axes[0], axes[1], normal);
  requirePlausible(m_path, grid);
  requireMemory(m_path, 2.0 * static_cast<double>(pixels.perFrame()) * slices);
  return grid;
}

std::vector<std::uint16_t> SegmentationFile::numbersOn(const Grid& grid, const SegmentPixels& pixels,
                                                       const std::vector<SegmentFrame>& frames,
                                                       const Progress& progress) const {
  std::vector<std::uint16_t> numbers(static_cast<std::size_t>(pixels.perFrame()) * grid.dims.z, 0);
  const auto stream = openDicomStream(m_path, m_file.deflatedFrom);
  std::string bytes;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    reportOrStop(progress, static_cast<double>(n) / static_cast<double>(frames.size()),
                 Message::tr("Reading segments"));
    // Frames of bits follow each other without gaps, so that one may begin within a byte, or a swapped pair.
    const std::uint64_t firstBit = n * pixels.bitsPerFrame(), from = firstBit / 16 * 2;
    const std::uint64_t length = m_file.pixels->length;
    bytes.resize(std::min((firstBit + pixels.bitsPerFrame() + 15) / 16 * 2, length) - from);
    stream->clear();
    stream->seekg(static_cast<std::streamoff>(m_file.pixels->offset + from));
    if (!stream->read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
      failReading(m_path, Message::tr("it is cut off within its segments"), copyAgain);
    if (m_file.pixels->isWordSwapped)
      for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        std::swap(bytes[i], bytes[i + 1]);
    const std::uint64_t skipped = firstBit - 8 * from;
    const auto isSet = [&](std::uint64_t pixel) {
      if (pixels.isFractional)
        return static_cast<unsigned char>(bytes[skipped / 8 + pixel]) >= pixels.half;
      const std::uint64_t bit = skipped + pixel;
      return (static_cast<unsigned char>(bytes[bit / 8]) >> (bit % 8) & 1) != 0;
    };
    const double plane = worldToIndex(grid, frames[n].positionMm).z;
    std::uint16_t* slice = &numbers[static_cast<std::size_t>(std::lround(plane)) * pixels.perFrame()];
    for (std::uint64_t pixel = 0; pixel < pixels.perFrame(); ++pixel)
      if (isSet(pixel))
        slice[pixel] = std::max(slice[pixel], static_cast<std::uint16_t>(frames[n].segment));
  }
  return numbers;
}

// What a code of a segment means to people.
std::string meaningOf(const DicomDataset& segment, DicomTag sequence, const DicomElement* characters) {
  const DicomDataset* code = firstItemOf(segment, sequence);
  if (!code)
    return {};
  DicomDataset item = *code;
  if (characters)
    item.elements.emplace(tag::characterSet, *characters);
  return plainText(utf8TextOf(item, tag::codeMeaning), longestName);
}

std::vector<Label> SegmentationFile::labels() const {
  std::vector<Label> labels;
  const auto sequence = m_file.dataset.elements.find(tag::segmentSequence);
  if (sequence == m_file.dataset.elements.end())
    return labels;
  const auto characters = m_file.dataset.elements.find(tag::characterSet);
  for (DicomDataset item : sequence->second.items) {
    // What holds for the file holds for its items.
    if (characters != m_file.dataset.elements.end())
      item.elements.insert(*characters);
    const int number = static_cast<int>(unsignedOf(item, tag::segmentNumber).value_or(0));
    const std::vector<std::uint16_t> color = wordsOf(item, tag::recommendedDisplayCieLab);
    Label label{number, plainText(utf8TextOf(item, tag::segmentLabel), longestName), glm::dvec3(1.0)};
    if (color.size() == 3)
      label.color = colorOfCieLab({color[0], color[1], color[2]});
    const DicomElement* set = characters != m_file.dataset.elements.end() ? &characters->second : nullptr;
    label.type = meaningOf(item, tag::propertyTypeSequence, set);
    label.category = meaningOf(item, tag::propertyCategorySequence, set);
    labels.push_back(std::move(label));
  }
  return labels;
}

DicomSegments SegmentationFile::read(const Progress& progress) {
  const SegmentPixels pixels = pixelsOf();
  const std::vector<SegmentFrame> frames = framesOf(pixels);
  const Grid grid = gridOf(pixels, frames);
  std::vector<std::uint16_t> numbers = numbersOn(grid, pixels, frames, part(progress, 0.0, 0.9));
  VolumeInfo info;
  info.format = "DICOM";
  info.modality = "SEG";
  return {std::make_shared<const Volume>(grid, std::move(numbers), Rescale{}, std::nullopt, std::move(info),
                                         effortOf(part(progress, 0.9, 1.0), countingVoxels)),
          labels()};
}

} // namespace

bool isDicomSegmentation(const fs::path& file) {
  std::error_code unknown;
  const auto parsed = fs::is_regular_file(file, unknown) ? parseIfDicom(file) : std::nullopt;
  return parsed && textOf(parsed->dataset, tag::sopClass) == segmentationClass;
}

DicomSegments readDicomSegmentation(const fs::path& file, const Progress& progress) {
  return SegmentationFile(file).read(progress);
}

glm::dvec3 colorOfCieLab(const std::array<std::uint16_t, 3>& words) {
  const glm::dvec3 lab(words[0] * 100.0 / 65535.0, words[1] * 255.0 / 65535.0 - 128.0,
                       words[2] * 255.0 / 65535.0 - 128.0);
  const auto linear = [](double t) {
    return t > 6.0 / 29.0 ? t * t * t : 3.0 * 36.0 / 841.0 * (t - 4.0 / 29.0);
  };
  const double y = (lab.x + 16.0) / 116.0;
  const glm::dvec3 xyz =
      whiteD50 * glm::dvec3(linear(y + lab.y / 500.0), linear(y), linear(y - lab.z / 200.0));
  glm::dvec3 color = glm::clamp(xyzToLinear * xyz, 0.0, 1.0);
  for (int channel = 0; channel < 3; ++channel)
    color[channel] = color[channel] <= 0.0031308 ? 12.92 * color[channel]
                                                 : 1.055 * std::pow(color[channel], 1.0 / 2.4) - 0.055;
  return color;
}

std::array<std::uint16_t, 3> cieLabOfColor(const glm::dvec3& color) {
  glm::dvec3 linear = glm::clamp(color, 0.0, 1.0);
  for (int channel = 0; channel < 3; ++channel)
    linear[channel] = linear[channel] <= 0.04045 ? linear[channel] / 12.92
                                                 : std::pow((linear[channel] + 0.055) / 1.055, 2.4);
  glm::dvec3 t = glm::inverse(xyzToLinear) * linear / whiteD50;
  for (int channel = 0; channel < 3; ++channel)
    t[channel] =
        t[channel] > 216.0 / 24389.0 ? std::cbrt(t[channel]) : 841.0 / 108.0 * t[channel] + 4.0 / 29.0;
  const glm::dvec3 lab(116.0 * t.y - 16.0, 500.0 * (t.x - t.y), 200.0 * (t.y - t.z));
  const auto word = [](double share) {
    return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(share, 0.0, 1.0)));
  };
  return {word(lab.x / 100.0), word((lab.y + 128.0) / 255.0), word((lab.z + 128.0) / 255.0)};
}

} // namespace limn
