// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomHeader.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace limn {
namespace {

constexpr std::string_view storage = "1.2.840.10008.5.1.4.1.1.";
constexpr std::string_view doseClass = "481.2"; // may give the dose of single points, without a picture

// Whether a class is `root` or a part of it.
bool isBelow(std::string_view name, std::string_view root) {
  return name.starts_with(root) && (name.size() == root.size() || name[root.size()] == '.');
}

template <std::size_t count>
bool isBelowAny(std::string_view name, const std::array<std::string_view, count>& roots) {
  return std::any_of(roots.begin(), roots.end(), [&](std::string_view root) { return isBelow(name, root); });
}

// Whether a storage class, given by what follows the common root, is one of images.
bool isImageClass(std::string_view name) {
  // Radiotherapy images; segmentations among the results of registration and measurement.
  static constexpr std::array<std::string_view, 6> images = {"481.1", "481.23", "481.24",
                                                             "66.4",  "66.7",   "66.8"};
  // Spectra; overlays, curves and waveforms; presentation states; raw data, registrations and surfaces; real
  // world values; measurements of the eye; reports; annotations; documents; protocols; inventories; plans.
  static constexpr std::array<std::string_view, 21> others = {
      "4.2", "8",  "9",  "10",  "11",  "66",  "67",  "68",  "78",  "79",   "80",
      "88",  "90", "91", "104", "129", "131", "200", "201", "481", "501.3"};
  return isBelowAny(name, images) || !isBelowAny(name, others);
}

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
  if (header.pixels)
    return false;
  const std::string_view name = header.sopClass;
  if (name.empty())
    return isImageModality(header.modality);
  const bool describesPixels = header.rows > 0 || header.columns > 0;
  if (!name.starts_with(storage) || isBelow(name.substr(storage.size()), doseClass))
    return describesPixels;
  return isImageClass(name.substr(storage.size()));
}

} // namespace limn
