// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcdatset.h>
#include <dcmtk/dcmdata/dcdeftag.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// The attributes of an item of DCMTK's as plain values; for this folder only.

namespace limn::dicom {

/// The way out where a look is damaged or contradicts itself.
inline const Message exportAgain = Message::tr("export the look again");

/// Whether the attribute is there and not empty.
bool holds(DcmItem& item, const DcmTagKey& tag);

/// A text without padding; empty where absent.
std::string textIn(DcmItem& item, const DcmTagKey& tag);

/// The numbers of an attribute of VR FD or DS; empty where absent or where one is not finite.
std::vector<double> numbersIn(DcmItem& item, const DcmTagKey& tag);

/// The first of them.
std::optional<double> numberIn(DcmItem& item, const DcmTagKey& tag);

/// The numbers of VR US.
std::vector<std::uint16_t> wordsIn(DcmItem& item, const DcmTagKey& tag);

/// The items of a sequence; none where it is absent.
std::vector<DcmItem*> itemsIn(DcmItem& item, const DcmTagKey& tag);

/// As "Viewpoint Position (0070,1603)".
std::string nameOf(const DcmTagKey& tag);

/// The shortest text of VR DS, at most 16 characters, that reads as the number, or as the nearest one that
/// fits.
std::string decimalText(double number);

// Writing; what does not fit throws Error (other).
void putText(DcmItem& item, const DcmTagKey& tag, const std::string& text);
void putNumbers(DcmItem& item, const DcmTagKey& tag, const std::vector<double>& numbers); ///< VR FD
void putCount(DcmItem& item, const DcmTagKey& tag, int number);                           ///< VR US
void putNothing(DcmItem& item, const DcmTagKey& tag);                                     ///< there, empty
DcmItem& addItem(DcmItem& item, const DcmTagKey& sequence);

/// Throws where a step of DCMTK's failed while an object was made.
void require(bool succeeded, const DcmTagKey& tag);

} // namespace limn::dicom
