// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomParser.h"
#include "scene/volume/Volume.h"

#include <algorithm>
#include <array>

namespace limn {

/// What can tell images at one position apart, in the order in which a phase is chosen.
enum class DicomPhase {
  temporalPosition,
  triggerTime,
  cardiacDelay,
  echoTime,
  diffusionBValue,
  imageType,
  acquisitionNumber,
  acquisitionTime,
  contentTime
};
inline constexpr std::size_t dicomPhaseCount = 9;

/// One picture of a file: a plane of pixels and where it lies.
struct DicomFrame {
  std::optional<glm::dvec3> positionMm;          ///< LPS, centre of the first pixel
  std::optional<std::array<glm::dvec3, 2>> axes; ///< unit vectors: along a row, along a column
  std::optional<glm::dvec2> pixelSpacingMm;      ///< x: between columns, y: between rows
  std::optional<double> thicknessMm;
  std::optional<double> betweenSlicesMm;
  std::optional<Rescale> rescale;
  std::string rescaleType;
  std::string stackId;
  std::array<std::string, dicomPhaseCount> phase; ///< empty where the file does not say
};

/// The modality look-up table: the value of stored pixel `first + i`, clamped at both ends.
struct DicomLut {
  int first = 0;
  std::vector<std::uint16_t> values;

  double valueOf(double stored) const {
    const double last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::clamp(stored - first, 0.0, last))];
  }
};

/// How the pixels of a file are stored.
struct DicomPixelFormat {
  int bitsAllocated = 16;
  int bitsStored = 16;
  int highBit = 15;
  bool isSigned = false;
  int samples = 1;
  bool isPlanar = false;   ///< colour: all red, all green, all blue
  std::string photometric; ///< MONOCHROME2, RGB, …
  bool operator==(const DicomPixelFormat&) const = default;
};

/// The facts of one DICOM image file that reading a volume needs.
struct DicomHeader {
  std::filesystem::path path;
  std::string transferSyntax;
  std::uint64_t deflatedFrom = 0;
  std::optional<DicomPixelLocation> pixels;
  std::string sopClass;
  std::string sopInstance;
  std::string studyInstance;
  std::string seriesInstance;
  std::string seriesDescription;
  std::optional<double> seriesNumber;
  std::optional<double> instanceNumber;
  std::string modality;
  ScanHints hints;
  std::string unit;
  int columns = 0;
  int rows = 0;
  DicomPixelFormat format;
  std::optional<PaddingRange> padding;
  std::optional<DicomLut> modalityLut;
  std::optional<DicomLut> palette; ///< luminance of a palette entry
  bool isMosaic = false;
  bool isFilm = false;               ///< several frames, one per moment
  std::string frameCountFlaw;        ///< the text of a number of frames that is none
  std::uint64_t announcedFrames = 1; ///< `frames` holds no more than the file has room for, and one more
  bool isLossy = false;
  std::optional<double> lossyRatio; ///< of the last compression
  std::vector<DicomFrame> frames;
  PatientLabel patient;
};

/// Gathers the facts of a parsed file. Does not judge them: requireSupported does.
DicomHeader headerOf(const std::filesystem::path& path, const DicomFile& file);

/// Throws Error (input) with the reason where the pixels of a file cannot become a volume: no image, unusual
/// bits, mosaic, film, video.
void requireSupported(const DicomHeader& header);

/// Throws Error (input) where a file (that is supported) is too short for the pixels it announces.
void requireWhole(const DicomHeader& header);

/// How many frames the pixels of a file have room for: exactly where uncompressed, at the fewest bytes that
/// any compression needs otherwise.
std::uint64_t roomForFrames(const DicomHeader& header);

/// Bytes of one uncompressed frame.
std::uint64_t frameBytes(const DicomHeader& header);

/// The text of an attribute in UTF-8, decoded from the file's character set.
std::string utf8TextOf(const DicomDataset& dataset, DicomTag tag);

/// The facts of each of `count` frames: from the per-frame functional groups, else from the shared ones, else
/// from the data set itself (a single image; a dose grid with its frame offsets).
std::vector<DicomFrame> framesOf(const DicomDataset& dataset, int count);

/// Whether a file without pixels must once have had them: its class is one of images, or the attributes that
/// describe pixels are there, or it ends before it says what it is. False for reports, presentation states,
/// plans, structures, waveforms, raw data and other objects that hold no picture by their kind (PS3.4, B.5),
/// and for private kinds that describe no pixels.
bool hasLostPicture(const DicomHeader& header);

} // namespace limn
