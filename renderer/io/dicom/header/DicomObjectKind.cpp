// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomHeader.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <dcmtk/config/osconfig.h> // before other headers of DCMTK

#include <dcmtk/dcmdata/dcuid.h>

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

} // namespace limn
