// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomHeader.h"
#include "io/reading/ReadError.h"
#include "scene/basics/Error.h"

#include <dcmtk/config/osconfig.h> // before other headers of DCMTK
#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace limn {
namespace {

constexpr std::string_view storage = "1.2.840.10008.5.1.4.1.1.";

bool isImageModality(std::string_view modality) {
  static constexpr std::array<std::string_view, 36> others = {
      "SR",  "PR",   "KO",    "DOC", "RTSTRUCT", "RTPLAN", "RTRECORD", "RTINTENT", "RTRAD",
      "REG", "FID",  "PLAN",  "RWV", "ECG",      "EPS",    "HD",       "RESP",     "AU",
      "ANN", "ASMT", "LEN",   "KER", "VA",       "OAM",    "IOL",      "OPV",      "SRF",
      "AR",  "M3D",  "STAIN", "POS", "EEG",      "EMG",    "EOG",      "RTSEGANN", "TEXTUREMAP"};
  return std::find(others.begin(), others.end(), modality) == others.end();
}

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

[[noreturn]] void refuse(const DicomHeader& header, const Message& why) {
  throw Error(Error::Kind::input, Message::tr("The DICOM file %1 %2").arg(header.path.string(), why));
}

void requirePicture(const DicomHeader& header) {
  if (header.sopClass == "1.2.840.10008.1.3.10")
    refuse(header,
           Message::tr("is the index of a medium (DICOMDIR) and no image; open the folder that holds it."));
  if (hasLostPicture(header))
    refuse(header, Message::tr("is cut off before its picture; copy it again from its source."));
  if (!header.pixels)
    refuse(header,
           Message::tr("holds no image%1; open the folder of an image series instead.")
               .arg(header.modality.empty() ? Message()
                                            : Message::tr(" (its kind is %1)").arg(quoted(header.modality))));
  if (header.pixels->isFloatingPoint)
    refuse(header, Message::tr("stores its pixels as floating-point numbers, which this program does not "
                               "read from DICOM; convert it to NIfTI."));
  if (header.isMosaic)
    refuse(header,
           Message::tr("is a mosaic: many slices tiled in one picture; convert it with dcm2niix first."));
  if (!header.frameCountFlaw.empty())
    refuse(header, Message::tr("gives %1 as its number of frames; its header is damaged.")
                       .arg(quoted(header.frameCountFlaw)));
  if (header.isFilm)
    refuse(header,
           Message::tr(
               "is a film: its frames follow each other in time and not in space, so they make no volume."));
  const std::string compressed = "1.2.840.10008.1.2.4.";
  if (header.transferSyntax.rfind(compressed + "10", 0) == 0)
    refuse(header,
           Message::tr("is a video, whose frames make no volume; export the series as single images."));
  if (header.transferSyntax == compressed + "94" || header.transferSyntax == compressed + "95")
    refuse(header,
           Message::tr("only names a server that holds its pixels (JPIP); export the images themselves."));
}

void requireFormat(const DicomHeader& header) {
  const DicomPixelFormat& format = header.format;
  if (header.columns == 0 || header.rows == 0)
    refuse(header, Message::tr("says its picture is %1 × %2 pixels; its header is damaged.")
                       .arg(header.columns, header.rows));
  const int bits = format.bitsAllocated;
  if (bits != 8 && bits != 16 && bits != 32)
    refuse(header,
           Message::tr(
               "stores %1 bits per pixel, which this program does not read; convert it to 8, 16 or 32 bits.")
               .arg(bits));
  if (format.bitsStored < 1 || format.bitsStored > bits || format.highBit < format.bitsStored - 1 ||
      format.highBit >= bits)
    refuse(header,
           Message::tr("contradicts itself: %1 bits up to bit %2 stored in %3; its header is damaged.")
               .arg(format.bitsStored, format.highBit, bits));
  if (format.samples != 1 && format.samples != 3)
    refuse(header, Message::tr("has %1 samples per pixel; only grey (1) and colour (3) can be opened.")
                       .arg(format.samples));
  static constexpr std::array<std::string_view, 4> grey = {"", "MONOCHROME1", "MONOCHROME2", "PALETTE COLOR"};
  static constexpr std::array<std::string_view, 5> colour = {"RGB", "YBR_FULL", "YBR_FULL_422", "YBR_ICT",
                                                             "YBR_RCT"};
  const bool isKnown = format.samples == 1 ? std::ranges::find(grey, format.photometric) != grey.end()
                                           : std::ranges::find(colour, format.photometric) != colour.end();
  if (!isKnown)
    refuse(header, Message::tr("says its %1 samples per pixel mean %2, which this program does not know; "
                               "export it as grey values.")
                       .arg(format.samples, quoted(format.photometric)));
  if (format.photometric == "PALETTE COLOR" && !header.palette)
    refuse(header,
           Message::tr("is coloured by a palette this program cannot read; export it as grey values."));
  if (!header.pixels->isEncapsulated && format.photometric.rfind("YBR_", 0) == 0 &&
      format.photometric != "YBR_FULL")
    refuse(header, Message::tr("stores uncompressed colour with reduced resolution (%1), which this program "
                               "does not read; export it as grey values.")
                       .arg(format.photometric));
}

} // namespace

bool hasLostPicture(const DicomHeader& header) {
  const std::string& kind = header.sopClass;
  if (header.pixels)
    return false;
  if (dcmIsImageStorageSOPClassUID(kind.c_str()) || kind == UID_SegmentationStorage)
    return true;
  const bool isDose = kind == UID_RTDoseStorage; // may give the dose of single points, without a picture
  if (!isDose && dcmIsaStorageSOPClassUID(kind.c_str(), ESSC_All))
    return false;
  // A class of the standard that DCMTK does not know is younger than it: the modality is left to tell.
  if (kind.empty() || (!isDose && kind.starts_with(storage)))
    return isImageModality(header.modality);
  return header.rows > 0 || header.columns > 0;
}

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
      refuse(header, Message::tr("is too short for the %1 pictures of %2 × %3 pixels it announces; it is "
                                 "damaged or cut off, so copy it again from its source.")
                         .arg(header.announcedFrames, header.columns, header.rows));
    return;
  }
  if (present >= needed && header.announcedFrames > mostFramesOfVolume)
    refuse(header, Message::tr("announces %1 pictures, more than any volume has; export it again.")
                       .arg(header.announcedFrames));
  if (present < needed)
    refuse(
        header,
        Message::tr("is cut off: its pixels need %1 bytes, and it holds %2; copy it again from its source.")
            .arg(needed, present));
}

void requireSupported(const DicomHeader& header) {
  requirePicture(header);
  requireFormat(header);
}

} // namespace limn
