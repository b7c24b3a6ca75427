// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/pixels/DicomCodestream.h"

#include "io/dicom/pixels/DicomJpeg.h"
#include "scene/basics/Error.h"

#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <array>
#include <exception>

namespace limn {
namespace {

[[noreturn]] void fail(const DicomHeader& header, const Message& why) {
  throw Error(
      Error::Kind::input,
      Message::tr("The compressed pixels of %1 %2 (transfer syntax %3); export the series uncompressed.")
          .arg(header.path.string(), why, header.transferSyntax));
}

int word(const DicomCodestream& stream, std::size_t at) {
  return stream[at] << 8 | stream[at + 1];
}

// Walks the marker segments of a JPEG or JPEG-LS stream to the start of the frame.
std::optional<CodestreamFacts> jpegFacts(const DicomCodestream& stream) {
  std::size_t at = 2;
  while (at + 10 <= stream.size()) {
    if (stream[at] != 0xFF)
      return std::nullopt;
    const int marker = stream[at + 1];
    if (marker == 0xFF) {
      ++at;
      continue;
    }
    const bool isTable = marker == 0xC4 || marker == 0xC8 || marker == 0xCC;
    if ((marker >= 0xC0 && marker <= 0xCF && !isTable) || marker == 0xF7)
      return CodestreamFacts{word(stream, at + 7), word(stream, at + 5), stream[at + 4], stream[at + 9]};
    at += 2 + static_cast<std::size_t>(word(stream, at + 2));
  }
  return std::nullopt;
}

// Finds the size marker, which opens a JPEG 2000 stream; a JP2 file has boxes before it.
std::optional<CodestreamFacts> jpeg2000Facts(const DicomCodestream& stream) {
  static constexpr std::array<unsigned char, 4> start = {0xFF, 0x4F, 0xFF, 0x51};
  const auto found = std::search(stream.begin(), stream.end(), start.begin(), start.end());
  if (stream.end() - found < 45)
    return std::nullopt;
  const auto at = static_cast<std::size_t>(found - stream.begin()) + 8;
  const auto number = [&](std::size_t offset) {
    return static_cast<std::int64_t>(word(stream, at + offset)) << 16 | word(stream, at + offset + 2);
  };
  const auto columns = number(0) - number(8);
  const auto rows = number(4) - number(12);
  if (columns <= 0 || rows <= 0 || columns > 65535 || rows > 65535)
    return std::nullopt;
  return CodestreamFacts{static_cast<int>(columns), static_cast<int>(rows), (stream[at + 34] & 0x7F) + 1,
                         word(stream, at + 32)};
}

CodestreamFacts agreedFacts(const DicomHeader& header, const DicomCodestream& stream) {
  const auto facts = factsOf(stream);
  if (!facts)
    fail(header, Message::tr("are damaged or in a form this program does not read"));
  if (facts->columns != header.columns || facts->rows != header.rows)
    fail(header, Message::tr("make a picture of %1 × %2 pixels where the header says %3 × %4")
                     .arg(facts->columns, facts->rows, header.columns, header.rows));
  if (facts->components != header.format.samples)
    fail(header, Message::tr("have %1 samples per pixel where the header says %2")
                     .arg(facts->components, header.format.samples));
  if ((facts->bits + 7) / 8 * 8 != header.format.bitsAllocated)
    fail(header,
         Message::tr("have %1 bits where the header says %2").arg(facts->bits, header.format.bitsAllocated));
  return *facts;
}

// Whether the mark that closes a picture (one for JPEG, JPEG-LS and JPEG 2000) stands at the end, but for
// padding.
bool isClosed(const DicomCodestream& stream) {
  std::size_t end = stream.size();
  while (end > 2 && (stream[end - 1] == 0x00 || (stream[end - 1] == 0xFF && stream[end - 2] != 0xFF)))
    --end;
  return end > 2 && stream[end - 2] == 0xFF && stream[end - 1] == 0xD9;
}

void silenceGdcm() {
  gdcm::Trace::DebugOff();
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
}

gdcm::DataElement encapsulated(const DicomCodestream& stream) {
  auto fragments = gdcm::SequenceOfFragments::New();
  gdcm::Fragment fragment;
  fragment.SetByteValue(reinterpret_cast<const char*>(stream.data()),
                        gdcm::VL(static_cast<std::uint32_t>(stream.size())));
  fragments->AddFragment(fragment);
  gdcm::DataElement element(gdcm::Tag(0x7FE0, 0x0010));
  element.SetVR(gdcm::VR::OB);
  element.SetVL(gdcm::VL(0xFFFFFFFF));
  element.SetValue(*fragments);
  return element;
}

gdcm::Image imageOf(const DicomHeader& header, gdcm::TransferSyntax::TSType syntax) {
  const DicomPixelFormat& format = header.format;
  const auto narrow = [](int value) { return static_cast<unsigned short>(value); };
  gdcm::Image image;
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, static_cast<unsigned int>(header.columns));
  image.SetDimension(1, static_cast<unsigned int>(header.rows));
  image.SetPixelFormat(gdcm::PixelFormat(narrow(format.samples), narrow(format.bitsAllocated),
                                         narrow(format.bitsStored), narrow(format.highBit),
                                         format.isSigned ? 1 : 0));
  image.SetPlanarConfiguration(0);
  const std::string photometric = format.samples == 1 ? "MONOCHROME2" : format.photometric;
  image.SetPhotometricInterpretation(
      gdcm::PhotometricInterpretation(gdcm::PhotometricInterpretation::GetPIType(photometric.c_str())));
  image.SetTransferSyntax(gdcm::TransferSyntax(syntax));
  return image;
}

// The colours of a JPEG stream are as the header says, unless the stream itself is marked as Y, Cb, Cr.
DicomRawFrame decodedJpeg(const DicomHeader& header, const DicomCodestream& stream, int bits) {
  try {
    JpegPicture picture = bits <= 8    ? decodeJpeg8(stream)
                          : bits <= 12 ? decodeJpeg12(stream)
                                       : decodeJpeg16(stream);
    const bool isYbr = header.format.samples == 3 && picture.isMarkedYbr;
    return {std::move(picture.bytes), isYbr ? "YBR_FULL" : header.format.photometric};
  } catch (const JpegDamage& damage) {
    fail(header, Message::tr("are damaged or cut off (%1)").arg(damage.what()));
  }
}

DicomRawFrame decodedByImage(const DicomHeader& header, const DicomCodestream& stream,
                             gdcm::TransferSyntax::TSType syntax) {
  gdcm::Image image = imageOf(header, syntax);
  image.SetDataElement(encapsulated(stream));
  DicomRawFrame frame;
  if (image.GetBufferLength() != frameBytes(header))
    fail(header, Message::tr("do not fill the picture"));
  frame.bytes.resize(frameBytes(header));
  if (!image.GetBuffer(reinterpret_cast<char*>(frame.bytes.data())))
    fail(header,
         Message::tr("cannot be decoded, for they are damaged or in a form this program does not read"));
  frame.photometric = image.GetPhotometricInterpretation().GetString();
  return frame;
}

bool isClassicJpeg(gdcm::TransferSyntax::TSType syntax) {
  using Syntax = gdcm::TransferSyntax;
  return syntax == Syntax::JPEGBaselineProcess1 || syntax == Syntax::JPEGExtendedProcess2_4 ||
         syntax == Syntax::JPEGExtendedProcess3_5 || syntax == Syntax::JPEGSpectralSelectionProcess6_8 ||
         syntax == Syntax::JPEGFullProgressionProcess10_12 || syntax == Syntax::JPEGLosslessProcess14 ||
         syntax == Syntax::JPEGLosslessProcess14_1;
}

DicomRawFrame decodedByGdcm(const DicomHeader& header, const DicomCodestream& stream,
                            gdcm::TransferSyntax::TSType syntax, int bits) {
  return isClassicJpeg(syntax) ? decodedJpeg(header, stream, bits) : decodedByImage(header, stream, syntax);
}

constexpr std::size_t headerBytes = 64;

[[noreturn]] void fail(const DicomHeader& header) {
  throw Error(
      Error::Kind::input,
      Message::tr(
          "The run-length encoded pixels of %1 are damaged or cut off; copy the file again from its source.")
          .arg(header.path.string()));
}

std::uint32_t lengthAt(const DicomCodestream& stream, std::size_t at) {
  return stream[at] | stream[at + 1] << 8 | stream[at + 2] << 16 | std::uint32_t{stream[at + 3]} << 24;
}

// Unpacks one segment into every `stride`-th byte from `first`.
void unpack(const DicomHeader& header, const DicomCodestream& stream, std::size_t from, std::size_t to,
            std::vector<unsigned char>& out, std::size_t first, std::size_t stride) {
  std::size_t at = first;
  while (at < out.size()) {
    if (from >= to)
      fail(header);
    const auto control = static_cast<signed char>(stream[from++]);
    if (control == -128)
      continue;
    const bool isLiteral = control >= 0;
    const std::size_t count = static_cast<std::size_t>(isLiteral ? control + 1 : 1 - control);
    if (from + (isLiteral ? count : 1) > to)
      fail(header);
    for (std::size_t i = 0; i < count && at < out.size(); ++i, at += stride)
      out[at] = stream[isLiteral ? from + i : from];
    from += isLiteral ? count : 1;
  }
}

} // namespace

std::optional<CodestreamFacts> factsOf(const DicomCodestream& stream) {
  if (stream.size() < 12)
    return std::nullopt;
  return stream[0] == 0xFF && stream[1] == 0xD8 ? jpegFacts(stream) : jpeg2000Facts(stream);
}

DicomRawFrame decoded(const DicomHeader& header, const DicomCodestream& stream) {
  if (header.transferSyntax == "1.2.840.10008.1.2.5")
    return {decodedRunLengths(header, stream), header.format.photometric};
  const auto syntax = gdcm::TransferSyntax::GetTSType(header.transferSyntax.c_str());
  if (syntax == gdcm::TransferSyntax::TS_END)
    fail(header, Message::tr("are in a form this program does not read"));
  const CodestreamFacts facts = agreedFacts(header, stream);
  if (!isClosed(stream))
    fail(header, Message::tr("are cut off"));
  silenceGdcm();
  DicomRawFrame frame;
  try {
    frame = decodedByGdcm(header, stream, syntax, facts.bits);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    fail(header, Message::tr("cannot be decoded: %1").arg(error.what()));
  }
  if (frame.bytes.size() != frameBytes(header))
    fail(header, Message::tr("do not fill the picture"));
  return frame;
}

std::vector<unsigned char> decodedRunLengths(const DicomHeader& header, const DicomCodestream& stream) {
  const auto samples = static_cast<std::size_t>(header.format.samples);
  const auto bytesPerSample = static_cast<std::size_t>(header.format.bitsAllocated / 8);
  const std::size_t planes = samples * bytesPerSample;
  if (stream.size() < headerBytes || lengthAt(stream, 0) != planes)
    fail(header);
  std::vector<unsigned char> out(frameBytes(header));
  for (std::size_t plane = 0; plane < planes; ++plane) {
    const std::size_t from = lengthAt(stream, 4 + 4 * plane);
    const std::size_t to = plane + 1 < planes ? lengthAt(stream, 8 + 4 * plane) : stream.size();
    if (from < headerBytes || from >= to || to > stream.size())
      fail(header);
    // Segments run sample by sample, the most significant byte first.
    const std::size_t sample = plane / bytesPerSample;
    const std::size_t byte = bytesPerSample - 1 - plane % bytesPerSample;
    unpack(header, stream, from, to, out, sample * bytesPerSample + byte, planes);
  }
  return out;
}

} // namespace limn
