// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// Group in the upper 16 bits, element in the lower: (0028,0010) is 0x00280010.
using DicomTag = std::uint32_t;

struct DicomDataset;

/// One attribute: the bytes as the file holds them, or the items of a sequence.
struct DicomElement {
  std::string bytes;
  std::vector<DicomDataset> items;
};

/// The attributes of a file or of one item of a sequence that Limn reads, without pixels and bulk data.
struct DicomDataset {
  std::map<DicomTag, DicomElement> elements;
  bool bigEndian = false;
};

/// Whether the attribute is there and not empty.
bool has(const DicomDataset& dataset, DicomTag tag);

/// The text of an attribute without padding; empty where absent.
std::string textOf(const DicomDataset& dataset, DicomTag tag);

/// The values of a text attribute, which backslashes separate, each without padding.
std::vector<std::string> textsOf(const DicomDataset& dataset, DicomTag tag);

/// The numbers of a decimal or integer string (VR DS, IS). Empty where absent or where any of them is not a
/// finite number.
std::vector<double> decimalsOf(const DicomDataset& dataset, DicomTag tag);

/// The first number of a decimal or integer string.
std::optional<double> decimalOf(const DicomDataset& dataset, DicomTag tag);

/// Three numbers of a decimal string, e.g. a position.
std::optional<glm::dvec3> decimalVectorOf(const DicomDataset& dataset, DicomTag tag);

/// A binary unsigned number of two or four bytes (VR US, UL); also the bit pattern of SS.
std::optional<std::uint32_t> unsignedOf(const DicomDataset& dataset, DicomTag tag);

/// All 16-bit words of an attribute (VR US, SS, OW) as bit patterns.
std::vector<std::uint16_t> wordsOf(const DicomDataset& dataset, DicomTag tag);

/// The first binary floating-point number (VR FD or FL, told apart by length).
std::optional<double> floatOf(const DicomDataset& dataset, DicomTag tag);

/// The first item of a sequence; null where there is none.
const DicomDataset* firstItemOf(const DicomDataset& dataset, DicomTag tag);

} // namespace limn
