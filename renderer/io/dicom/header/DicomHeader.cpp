// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomHeader.h"

#include "io/dicom/header/DicomTags.h"

#include <algorithm>
#include <cmath>

#include <vtkDICOMCharacterSet.h>

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

} // namespace limn
