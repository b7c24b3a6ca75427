// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomHeader.h"
#include "io/reading/ReadError.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace limn {
namespace {

// A compressed frame is a fragment: its mark, its length, and at the least a header of its own.
constexpr std::uint64_t shortestFragment = 8 + 16;

// No volume has more slices; each takes half a kilobyte of memory before its pixels are read.
constexpr std::uint64_t mostFramesOfVolume = 1u << 15;

// The most by which a compression shrinks a picture; a header that says more is damaged. Run lengths take two
// bytes for 128. JPEG takes a bit for a block of 64 samples, of which those of 12 bits have two bytes; its
// lossless kind takes a bit for each sample. The others shrink empty pictures further.
std::uint64_t largestCompression(const std::string& syntax) {
  const std::string compressed = "1.2.840.10008.1.2.4.";
  if (syntax == "1.2.840.10008.1.2.5")
    return 64;
  if (syntax == compressed + "57" || syntax == compressed + "70")
    return 16;
  if (syntax.starts_with(compressed + "5"))
    return 1024;
  return 1u << 14;
}

std::uint64_t presentBytes(const DicomPixelLocation& pixels) {
  const std::uint64_t present = pixels.streamLength - std::min(pixels.offset, pixels.streamLength);
  return pixels.isEncapsulated ? present : std::min(pixels.length, present);
}

// What a header says, fit to stand in a sentence.
std::string quoted(const std::string& text) {
  std::string result(1, '\'');
  return result.append(plainText(text, 40)).append(1, '\'');
}

[[noreturn]] void refuse(const DicomHeader& header, const std::string& why) {
  throw Error(Error::Kind::input, "The DICOM file " + header.path.string() + " " + why);
}

void requirePicture(const DicomHeader& header) {
  if (header.sopClass == "1.2.840.10008.1.3.10")
    refuse(header, "is the index of a medium (DICOMDIR) and no image; open the folder that holds it.");
  if (hasLostPicture(header))
    refuse(header, "is cut off before its picture; copy it again from its source.");
  if (!header.pixels)
    refuse(header,
           "holds no image" +
               (header.modality.empty() ? std::string() : " (its kind is " + quoted(header.modality) + ")") +
               "; open the folder of an image series instead.");
  if (header.pixels->isFloatingPoint)
    refuse(header, "stores its pixels as floating-point numbers, which this program does not read from "
                   "DICOM; convert it to NIfTI.");
  if (header.isMosaic)
    refuse(header, "is a mosaic: many slices tiled in one picture; convert it with dcm2niix first.");
  if (!header.frameCountFlaw.empty())
    refuse(header,
           "gives " + quoted(header.frameCountFlaw) + " as its number of frames; its header is damaged.");
  if (header.isFilm)
    refuse(header,
           "is a film: its frames follow each other in time and not in space, so they make no volume.");
  const std::string compressed = "1.2.840.10008.1.2.4.";
  if (header.transferSyntax.rfind(compressed + "10", 0) == 0)
    refuse(header, "is a video, whose frames make no volume; export the series as single images.");
  if (header.transferSyntax == compressed + "94" || header.transferSyntax == compressed + "95")
    refuse(header, "only names a server that holds its pixels (JPIP); export the images themselves.");
}

void requireFormat(const DicomHeader& header) {
  const DicomPixelFormat& format = header.format;
  if (header.columns == 0 || header.rows == 0)
    refuse(header, "says its picture is " + std::to_string(header.columns) + " × " +
                       std::to_string(header.rows) + " pixels; its header is damaged.");
  const int bits = format.bitsAllocated;
  if (bits != 8 && bits != 16 && bits != 32)
    refuse(header, "stores " + std::to_string(bits) +
                       " bits per pixel, which this program does not read; convert it to 8, 16 or 32 bits.");
  if (format.bitsStored < 1 || format.bitsStored > bits || format.highBit < format.bitsStored - 1 ||
      format.highBit >= bits)
    refuse(header, "contradicts itself: " + std::to_string(format.bitsStored) + " bits up to bit " +
                       std::to_string(format.highBit) + " stored in " + std::to_string(bits) +
                       "; its header is damaged.");
  if (format.samples != 1 && format.samples != 3)
    refuse(header, "has " + std::to_string(format.samples) +
                       " samples per pixel; only grey (1) and colour (3) can be opened.");
  static constexpr std::array<std::string_view, 4> grey = {"", "MONOCHROME1", "MONOCHROME2", "PALETTE COLOR"};
  static constexpr std::array<std::string_view, 5> colour = {"RGB", "YBR_FULL", "YBR_FULL_422", "YBR_ICT",
                                                             "YBR_RCT"};
  const bool isKnown = format.samples == 1 ? std::ranges::find(grey, format.photometric) != grey.end()
                                           : std::ranges::find(colour, format.photometric) != colour.end();
  if (!isKnown)
    refuse(header, "says its " + std::to_string(format.samples) + " samples per pixel mean " +
                       quoted(format.photometric) +
                       ", which this program does not know; export it as grey values.");
  if (format.photometric == "PALETTE COLOR" && !header.palette)
    refuse(header, "is coloured by a palette this program cannot read; export it as grey values.");
  if (!header.pixels->isEncapsulated && format.photometric.rfind("YBR_", 0) == 0 &&
      format.photometric != "YBR_FULL")
    refuse(header, "stores uncompressed colour with reduced resolution (" + format.photometric +
                       "), which this program does not read; export it as grey values.");
}

} // namespace

std::uint64_t roomForFrames(const DicomHeader& header) {
  if (!header.pixels)
    return 0;
  const std::uint64_t bytes = header.pixels->isEncapsulated ? shortestFragment : frameBytes(header);
  return bytes == 0 ? 0 : std::min(presentBytes(*header.pixels) / bytes, mostFramesOfVolume);
}

void requireWhole(const DicomHeader& header) {
  const DicomPixelLocation& pixels = *header.pixels;
  const std::uint64_t present = presentBytes(pixels);
  const std::uint64_t needed = frameBytes(header) * header.announcedFrames;
  if (pixels.isEncapsulated) {
    if (needed / largestCompression(header.transferSyntax) > present ||
        header.announcedFrames > roomForFrames(header))
      refuse(header, "is too short for the " + std::to_string(header.announcedFrames) + " pictures of " +
                         std::to_string(header.columns) + " × " + std::to_string(header.rows) +
                         " pixels it announces; it is damaged or cut off, so copy it again from its source.");
    return;
  }
  if (present >= needed && header.announcedFrames > mostFramesOfVolume)
    refuse(header, "announces " + std::to_string(header.announcedFrames) +
                       " pictures, more than any volume has; export it again.");
  if (present < needed)
    refuse(header, "is cut off: its pixels need " + std::to_string(needed) + " bytes, and it holds " +
                       std::to_string(present) + "; copy it again from its source.");
}

void requireSupported(const DicomHeader& header) {
  requirePicture(header);
  requireFormat(header);
}

} // namespace limn
