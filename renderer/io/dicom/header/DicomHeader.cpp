// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomHeader.h"

#include "io/dicom/header/DicomTags.h"

#include <vtkDICOMCharacterSet.h>

#include <cmath>
#include <cstdio>

namespace limn {
namespace {

constexpr int mostFrames = 1 << 20;

// "Family^Given^Middle=…" becomes "Family, Given Middle".
std::string readableName(const std::string& name) {
  std::string text = name.substr(0, name.find('='));
  if (text.empty() && name.size() > 1)
    text = name.substr(1, name.find('=', 1) - 1);
  std::string result;
  bool isFamily = true;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t end = std::min(text.find('^', start), text.size());
    const std::string part = text.substr(start, end - start);
    if (!part.empty() && !result.empty())
      result += isFamily ? ", " : " ";
    if (!part.empty() && !result.empty())
      isFamily = false;
    result += part;
    start = end + 1;
  }
  return result;
}

std::string readableDate(const std::string& date) {
  if (date.size() != 8 || !std::all_of(date.begin(), date.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return date;
  return date.substr(0, 4) + "-" + date.substr(4, 2) + "-" + date.substr(6, 2);
}

DicomPixelFormat formatOf(const DicomDataset& dataset) {
  DicomPixelFormat format;
  const auto number = [&](DicomTag tag, int otherwise) {
    return static_cast<int>(unsignedOf(dataset, tag).value_or(static_cast<std::uint32_t>(otherwise)));
  };
  format.bitsAllocated = number(tag::bitsAllocated, 16);
  format.bitsStored = number(tag::bitsStored, format.bitsAllocated);
  format.highBit = number(tag::highBit, format.bitsStored - 1);
  format.isSigned = number(tag::pixelRepresentation, 0) == 1;
  format.samples = number(tag::samplesPerPixel, 1);
  format.isPlanar = number(tag::planarConfiguration, 0) == 1;
  format.photometric = textOf(dataset, tag::photometricInterpretation);
  return format;
}

// The padding is a bit pattern whose sign the pixel representation decides, whatever its own VR says.
std::optional<PaddingRange> paddingOf(const DicomDataset& dataset, bool isSigned) {
  const auto first = unsignedOf(dataset, tag::pixelPadding);
  if (!first)
    return std::nullopt;
  const auto limit = unsignedOf(dataset, tag::pixelPaddingLimit).value_or(*first);
  const auto stored = [&](std::uint32_t pattern) {
    return isSigned ? double(static_cast<std::int16_t>(pattern)) : double(pattern);
  };
  return PaddingRange{std::min(stored(*first), stored(limit)), std::max(stored(*first), stored(limit))};
}

std::optional<DicomLut> modalityLutOf(const DicomDataset& dataset, bool isSigned) {
  const DicomDataset* item = firstItemOf(dataset, tag::modalityLutSequence);
  if (!item)
    return std::nullopt;
  const std::vector<std::uint16_t> descriptor = wordsOf(*item, tag::lutDescriptor);
  DicomLut lut;
  lut.values = wordsOf(*item, tag::lutData);
  if (descriptor.size() < 3 || lut.values.empty())
    return std::nullopt;
  lut.first = isSigned ? static_cast<std::int16_t>(descriptor[1]) : descriptor[1];
  const std::size_t entries = descriptor[0] == 0 ? 65536 : descriptor[0];
  lut.values.resize(std::min(lut.values.size(), entries));
  return lut;
}

// The luminance of every palette entry (ITU-R BT.601 weights).
std::optional<DicomLut> paletteOf(const DicomDataset& dataset) {
  const std::vector<std::uint16_t> descriptor = wordsOf(dataset, tag::redPaletteDescriptor);
  const std::vector<std::uint16_t> red = wordsOf(dataset, tag::redPalette);
  const std::vector<std::uint16_t> green = wordsOf(dataset, tag::greenPalette);
  const std::vector<std::uint16_t> blue = wordsOf(dataset, tag::bluePalette);
  const bool isUsable = descriptor.size() >= 3 && descriptor[2] == 16 && !red.empty() &&
                        red.size() == green.size() && red.size() == blue.size();
  if (!isUsable)
    return std::nullopt;
  DicomLut lut;
  lut.first = descriptor[1];
  for (std::size_t i = 0; i < red.size(); ++i)
    lut.values.push_back(
        static_cast<std::uint16_t>(std::lround(0.299 * red[i] + 0.587 * green[i] + 0.114 * blue[i])));
  return lut;
}

// Some syntaxes always lose detail; others may, which an attribute can deny.
bool isLossy(const DicomDataset& dataset, const std::string& syntax) {
  const auto isOneOf = [&](std::initializer_list<const char*> ends) {
    return std::any_of(ends.begin(), ends.end(),
                       [&](const char* end) { return syntax == std::string("1.2.840.10008.1.2.4.") + end; });
  };
  const std::string stated = textOf(dataset, tag::lossyCompression);
  return stated == "01" || isOneOf({"50", "51"}) || (stated.empty() && isOneOf({"81", "91", "93"}));
}

// A film counts its frames in time and places none of them.
bool isFilm(const DicomDataset& dataset) {
  const std::vector<std::uint16_t> pointer = wordsOf(dataset, tag::frameIncrementPointer);
  if (pointer.size() < 2)
    return false;
  const DicomTag counted = static_cast<DicomTag>(pointer[0]) << 16 | pointer[1];
  return counted == tag::frameTime || counted == tag::frameTimeVector;
}

std::string unitOf(const DicomDataset& dataset, const std::string& modality, const DicomFrame& frame) {
  if (modality == "CT")
    return frame.rescale && (frame.rescaleType.empty() || frame.rescaleType == "HU") ? "HU" : "";
  if (modality == "PT") {
    const std::string units = textOf(dataset, tag::petUnits);
    return units == "BQML" ? "Bq/ml" : units == "GML" ? "g/ml" : "";
  }
  return modality == "RTDOSE" && textOf(dataset, tag::doseUnits) == "GY" ? "Gy" : "";
}

void readFrameCount(const DicomDataset& dataset, DicomHeader& header) {
  const double count =
      has(dataset, tag::numberOfFrames) ? decimalOf(dataset, tag::numberOfFrames).value_or(-1.0) : 1.0;
  if (count < 1.0 || count > mostFrames || count != std::floor(count)) {
    const std::string text = textOf(dataset, tag::numberOfFrames);
    header.frameCountFlaw = text.empty() ? "nothing" : text;
  }
  header.announcedFrames = header.frameCountFlaw.empty() ? static_cast<std::uint64_t>(count) : 1;
  const std::uint64_t held = std::min(header.announcedFrames, roomForFrames(header) + 1);
  header.frames = framesOf(dataset, static_cast<int>(held));
}

void readIdentity(const DicomDataset& dataset, DicomHeader& header) {
  header.sopClass = textOf(dataset, tag::sopClass);
  if (header.sopClass.empty())
    header.sopClass = textOf(dataset, tag::mediaStorageClass);
  header.sopInstance = textOf(dataset, tag::sopInstance);
  header.studyInstance = textOf(dataset, tag::studyInstance);
  header.seriesInstance = textOf(dataset, tag::seriesInstance);
  header.seriesDescription = utf8TextOf(dataset, tag::seriesDescription);
  header.seriesNumber = decimalOf(dataset, tag::seriesNumber);
  header.instanceNumber = decimalOf(dataset, tag::instanceNumber);
  header.modality = textOf(dataset, tag::modality);
  header.patient = {readableName(utf8TextOf(dataset, tag::patientName)), utf8TextOf(dataset, tag::patientId),
                    readableDate(textOf(dataset, tag::studyDate))};
}

// Of the words only what they hint at is kept.
ScanHints hintsOf(const DicomDataset& dataset, const std::string& modality) {
  ScanHints hints;
  for (const auto& text : {textOf(dataset, tag::bodyPart), textOf(dataset, tag::protocolName),
                           textOf(dataset, tag::seriesDescription)})
    hints = withHintsOf(hints, text);
  hints.modality = modality;
  const std::optional<double> repetition = decimalOf(dataset, tag::repetitionTime);
  const std::optional<double> echo = decimalOf(dataset, tag::echoTime);
  if (modality == "MR" && hints.weighting == ScanHints::Weighting::unknown && repetition && echo)
    hints.weighting = weightingBy(*repetition, *echo);
  return hints;
}

// How far unit vectors may be off length and right angle before they are called damaged.
constexpr double orientationTolerance = 1e-2;

// Where the attributes of a frame may stand, most specific first.
struct Sources {
  const DicomDataset* perFrame = nullptr;
  const DicomDataset* shared = nullptr;
  const DicomDataset* root = nullptr;

  // The item of a functional group that holds `tag`; the root where none does.
  const DicomDataset& holding(DicomTag sequence, DicomTag tag) const {
    for (const DicomDataset* groups : {perFrame, shared}) {
      const DicomDataset* item = groups ? firstItemOf(*groups, sequence) : nullptr;
      if (item && has(*item, tag))
        return *item;
    }
    return *root;
  }
};

std::optional<std::array<glm::dvec3, 2>> axesOf(const DicomDataset& dataset) {
  const std::vector<double> n = decimalsOf(dataset, tag::imageOrientation);
  if (n.size() != 6)
    return std::nullopt;
  const glm::dvec3 row(n[0], n[1], n[2]);
  const glm::dvec3 column(n[3], n[4], n[5]);
  const bool isSound = std::abs(glm::length(row) - 1.0) < orientationTolerance &&
                       std::abs(glm::length(column) - 1.0) < orientationTolerance &&
                       std::abs(glm::dot(row, column)) < orientationTolerance;
  if (!isSound)
    return std::nullopt;
  const glm::dvec3 x = glm::normalize(row);
  return std::array{x, glm::normalize(column - x * glm::dot(x, column))};
}

// A place within a thousand kilometres: beyond, numbers are damage, and distances lose their digits.
std::optional<glm::dvec3> sane(const std::optional<glm::dvec3>& place) {
  constexpr double farthestMm = 1e9;
  return place && glm::length(*place) <= farthestMm ? place : std::nullopt;
}

// (0028,0030) gives the distance between rows first.
std::optional<glm::dvec2> spacingOf(const DicomDataset& dataset, DicomTag tag) {
  const std::vector<double> rowsThenColumns = decimalsOf(dataset, tag);
  if (rowsThenColumns.size() != 2 || !(rowsThenColumns[0] > 0.0) || !(rowsThenColumns[1] > 0.0))
    return std::nullopt;
  return glm::dvec2(rowsThenColumns[1], rowsThenColumns[0]);
}

std::optional<double> positive(std::optional<double> length) {
  return length && *length > 0.0 ? length : std::nullopt;
}

// One number of an attribute: `otherwise` where it is absent, NaN where it is no number or several.
double numberOr(const DicomDataset& dataset, DicomTag tag, double otherwise) {
  if (!has(dataset, tag) || textOf(dataset, tag).empty())
    return otherwise;
  const std::vector<double> numbers = decimalsOf(dataset, tag);
  return numbers.size() == 1 ? numbers.front() : std::nan("");
}

std::optional<Rescale> rescaleOf(const Sources& from) {
  const auto sequence = tag::pixelValueTransformationSequence;
  const DicomDataset& dataset = from.holding(sequence, tag::rescaleSlope);
  if (has(dataset, tag::rescaleSlope) || has(dataset, tag::rescaleIntercept))
    return Rescale{numberOr(dataset, tag::rescaleSlope, 1.0), numberOr(dataset, tag::rescaleIntercept, 0.0)};
  if (const auto scaling = decimalOf(*from.root, tag::doseGridScaling))
    return Rescale{*scaling, 0.0};
  return std::nullopt;
}

std::string numberText(std::optional<double> number) {
  if (!number)
    return {};
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", *number);
  return text;
}

std::array<std::string, dicomPhaseCount> phasesOf(const Sources& from) {
  const auto index = [](DicomPhase phase) { return static_cast<std::size_t>(phase); };
  std::array<std::string, dicomPhaseCount> phase;
  const DicomDataset& content = from.holding(tag::frameContentSequence, tag::temporalPositionIndex);
  const auto temporal = unsignedOf(content, tag::temporalPositionIndex);
  phase[index(DicomPhase::temporalPosition)] =
      temporal ? std::to_string(*temporal) : textOf(*from.root, tag::temporalPosition);
  phase[index(DicomPhase::triggerTime)] = textOf(*from.root, tag::triggerTime);
  phase[index(DicomPhase::cardiacDelay)] = numberText(floatOf(
      from.holding(tag::cardiacSynchronizationSequence, tag::cardiacTriggerDelay), tag::cardiacTriggerDelay));
  const auto echo =
      floatOf(from.holding(tag::mrEchoSequence, tag::effectiveEchoTime), tag::effectiveEchoTime);
  phase[index(DicomPhase::echoTime)] = echo ? numberText(echo) : textOf(*from.root, tag::echoTime);
  phase[index(DicomPhase::diffusionBValue)] =
      numberText(floatOf(from.holding(tag::mrDiffusionSequence, tag::diffusionBValue), tag::diffusionBValue));
  phase[index(DicomPhase::imageType)] = textOf(*from.root, tag::imageType);
  phase[index(DicomPhase::acquisitionNumber)] = textOf(*from.root, tag::acquisitionNumber);
  phase[index(DicomPhase::acquisitionTime)] = textOf(*from.root, tag::acquisitionTime);
  phase[index(DicomPhase::contentTime)] = textOf(*from.root, tag::contentTime);
  return phase;
}

DicomFrame frameFrom(const Sources& from, bool mayUseRootPosition) {
  DicomFrame frame;
  const DicomDataset& place = from.holding(tag::planePositionSequence, tag::imagePosition);
  if (&place != from.root || mayUseRootPosition)
    frame.positionMm = sane(decimalVectorOf(place, tag::imagePosition));
  frame.axes = axesOf(from.holding(tag::planeOrientationSequence, tag::imageOrientation));
  const auto measures = tag::pixelMeasuresSequence;
  frame.pixelSpacingMm = spacingOf(from.holding(measures, tag::pixelSpacing), tag::pixelSpacing);
  if (!frame.pixelSpacingMm)
    frame.pixelSpacingMm = spacingOf(*from.root, tag::imagerPixelSpacing);
  frame.thicknessMm = positive(decimalOf(from.holding(measures, tag::sliceThickness), tag::sliceThickness));
  frame.betweenSlicesMm =
      positive(decimalOf(from.holding(measures, tag::spacingBetweenSlices), tag::spacingBetweenSlices));
  frame.rescale = rescaleOf(from);
  frame.rescaleType =
      textOf(from.holding(tag::pixelValueTransformationSequence, tag::rescaleType), tag::rescaleType);
  frame.stackId = textOf(from.holding(tag::frameContentSequence, tag::stackId), tag::stackId);
  frame.phase = phasesOf(from);
  return frame;
}

// Places the frames of a dose grid: offsets along the normal from the first, or patient z where the first
// offset is not 0 (PS3.3, C.8.8.3.2).
void placeByOffsets(const DicomDataset& dataset, std::vector<DicomFrame>& frames) {
  const std::vector<double> offsets = decimalsOf(dataset, tag::gridFrameOffsets);
  const auto first = decimalVectorOf(dataset, tag::imagePosition);
  if (offsets.size() != frames.size() || !first || !frames.front().axes)
    return;
  const auto& axes = *frames.front().axes;
  const glm::dvec3 normal = glm::cross(axes[0], axes[1]);
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i].positionMm = sane(*first + (offsets[i] - offsets[0]) * normal);
}

} // namespace

DicomHeader headerOf(const std::filesystem::path& path, const DicomFile& file) {
  const DicomDataset& dataset = file.dataset;
  DicomHeader header;
  header.path = path;
  header.transferSyntax = file.transferSyntax;
  header.deflatedFrom = file.deflatedFrom;
  header.pixels = file.pixels;
  readIdentity(dataset, header);
  header.hints = hintsOf(dataset, header.modality);
  header.columns = static_cast<int>(unsignedOf(dataset, tag::columns).value_or(0) & 0xFFFF);
  header.rows = static_cast<int>(unsignedOf(dataset, tag::rows).value_or(0) & 0xFFFF);
  header.format = formatOf(dataset);
  header.padding = paddingOf(dataset, header.format.isSigned);
  header.modalityLut = modalityLutOf(dataset, header.format.isSigned);
  header.palette = paletteOf(dataset);
  const std::vector<std::string> type = textsOf(dataset, tag::imageType);
  header.isMosaic = std::find(type.begin(), type.end(), "MOSAIC") != type.end();
  header.isLossy = isLossy(dataset, header.transferSyntax);
  const std::vector<double> ratios = decimalsOf(dataset, tag::lossyRatio);
  if (!ratios.empty())
    header.lossyRatio = ratios.back();
  readFrameCount(dataset, header);
  header.isFilm = header.frames.size() > 1 && isFilm(dataset) && !header.frames.front().positionMm;
  header.unit = unitOf(dataset, header.modality, header.frames.front());
  return header;
}

std::uint64_t frameBytes(const DicomHeader& header) {
  return static_cast<std::uint64_t>(header.columns) * static_cast<std::uint64_t>(header.rows) *
         static_cast<std::uint64_t>(header.format.samples) *
         static_cast<std::uint64_t>(header.format.bitsAllocated / 8);
}

std::string utf8TextOf(const DicomDataset& dataset, DicomTag tag) {
  const auto set = dataset.elements.find(tag::characterSet);
  const std::string name = set == dataset.elements.end() ? std::string() : set->second.bytes;
  return vtkDICOMCharacterSet(name).ToUTF8(textOf(dataset, tag));
}

std::vector<DicomFrame> framesOf(const DicomDataset& dataset, int count) {
  const auto groups = dataset.elements.find(tag::perFrameFunctionalGroups);
  Sources from;
  from.shared = firstItemOf(dataset, tag::sharedFunctionalGroups);
  from.root = &dataset;
  std::vector<DicomFrame> frames;
  frames.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const bool isListed =
        groups != dataset.elements.end() && static_cast<std::size_t>(i) < groups->second.items.size();
    from.perFrame = isListed ? &groups->second.items[static_cast<std::size_t>(i)] : nullptr;
    frames.push_back(frameFrom(from, count == 1));
  }
  if (count > 1 && has(dataset, tag::gridFrameOffsets))
    placeByOffsets(dataset, frames);
  return frames;
}

} // namespace limn
