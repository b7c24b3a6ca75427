// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/SrgbProfile.h"

#include "io/looks/dicom/Items.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace limn {
namespace {

std::string bigEndian(std::uint32_t number, int bytes = 4) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
    text += static_cast<char>(number >> shift & 0xFF);
  return text;
}

// s15Fixed16Number of the ICC specification.
std::string fixedPoint(double number) {
  return bigEndian(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(number * 65536.0))));
}

std::string element(const std::string& type, const std::string& content) {
  std::string text = type + bigEndian(0) + content;
  text.resize((text.size() + 3) / 4 * 4, '\0');
  return text;
}

std::string numbers(const std::string& type, const std::vector<double>& values) {
  std::string content;
  for (const double value : values)
    content += fixedPoint(value);
  return element(type, content);
}

// One language, English, in UTF-16.
std::string words(const std::string& ascii) {
  std::string wide;
  for (const char letter : ascii)
    wide += std::string(1, '\0') + letter;
  return element("mluc", bigEndian(1) + bigEndian(12) + "enUS" +
                             bigEndian(static_cast<std::uint32_t>(wide.size())) + bigEndian(28) + wide);
}

using Tags = std::vector<std::pair<std::string, std::string>>;

Tags srgbTags() {
  // y = ((x + 0.055)/1.055)^2.4 from 0.04045 on, x/12.92 below.
  const std::string curve =
      element("para", bigEndian(3, 2) + bigEndian(0, 2) + fixedPoint(2.4) + fixedPoint(1.0 / 1.055) +
                          fixedPoint(0.055 / 1.055) + fixedPoint(1.0 / 12.92) + fixedPoint(0.04045));
  return {{"desc", words("sRGB")},
          {"cprt", words("No copyright, use freely")},
          {"wtpt", numbers("XYZ ", {0.9642, 1.0, 0.8249})},
          {"chad", numbers("sf32", {1.0478112, 0.0228866, -0.0501270, 0.0295424, 0.9904844, -0.0170491,
                                    -0.0092345, 0.0150436, 0.7521316})},
          {"rXYZ", numbers("XYZ ", {0.4360747, 0.2225045, 0.0139322})},
          {"gXYZ", numbers("XYZ ", {0.3850649, 0.7168786, 0.0971045})},
          {"bXYZ", numbers("XYZ ", {0.1430804, 0.0606169, 0.7141733})},
          {"rTRC", curve},
          {"gTRC", curve},
          {"bTRC", curve}};
}

std::string header(std::uint32_t size) {
  const std::string date = bigEndian(2024, 2) + bigEndian(1, 2) + bigEndian(1, 2) + std::string(6, '\0');
  std::string text = bigEndian(size) + std::string(4, '\0') + bigEndian(0x04300000) + "scnrRGB XYZ " + date +
                     "acsp" + std::string(28, '\0');
  text += fixedPoint(0.9642) + fixedPoint(1.0) + fixedPoint(0.8249); // the space that profiles meet in: D50
  text.resize(128, '\0');
  return text;
}

// An ICC profile (version 4.3) of the class that DICOM asks for, an input device, which says that colours
// are sRGB's (IEC 61966-2-1): its primaries adapted to D50 by Bradford, its curve as the parametric one it
// is.
std::string srgbProfile() {
  const Tags tags = srgbTags();
  const auto count = static_cast<std::uint32_t>(tags.size());
  const std::uint32_t start = 128 + 4 + 12 * count;
  std::string table = bigEndian(count), data;
  for (const auto& [name, content] : tags) {
    table += name + bigEndian(start + static_cast<std::uint32_t>(data.size())) +
             bigEndian(static_cast<std::uint32_t>(content.size()));
    data += content;
  }
  return header(start + static_cast<std::uint32_t>(data.size())) + table + data;
}

} // namespace

void dicom::putSrgb(DcmItem& object) {
  const std::string profile = srgbProfile();
  require(object
              .putAndInsertUint8Array(DCM_ICCProfile, reinterpret_cast<const Uint8*>(profile.data()),
                                      static_cast<unsigned long>(profile.size()))
              .good(),
          DCM_ICCProfile);
  putText(object, DCM_ColorSpace, "SRGB");
}

} // namespace limn
