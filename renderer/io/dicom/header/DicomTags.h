// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomDataset.h"

#include <array>

/// The attributes Limn reads: a constant for each row of DicomTagList.inl, and the rows themselves.
namespace limn::tag {

/// How an attribute is read: as a value, as a sequence of items, or as pixels.
enum class Kind { value, sequence, pixels };

/// A row of the list.
struct Attribute {
  DicomTag tag = 0;
  Kind kind = Kind::value;
};

#define LIMN_DICOM_TAG(name, number, kind) inline constexpr DicomTag name = number;
#include "io/dicom/header/DicomTagList.inl"
#undef LIMN_DICOM_TAG

#define LIMN_DICOM_TAG(name, number, kind) Attribute{number, Kind::kind},
inline constexpr std::array all = {
#include "io/dicom/header/DicomTagList.inl"
};
#undef LIMN_DICOM_TAG

/// Whether the parser keeps an attribute.
bool isKept(DicomTag tag);

/// Whether an attribute is a sequence. In implicit syntax only a dictionary tells one of known length from
/// other bytes.
bool isSequence(DicomTag tag);

/// Whether an attribute holds the pixels.
bool isPixels(DicomTag tag);

} // namespace limn::tag
