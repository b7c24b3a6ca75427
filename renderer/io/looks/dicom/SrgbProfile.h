// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

class DcmItem;

namespace limn {

/// An ICC profile (version 4.3) of the class that DICOM asks for, an input device, which says that colours
/// are sRGB's (IEC 61966-2-1): its primaries adapted to D50 by Bradford, its curve as the parametric one it
/// is.
std::string srgbProfile();

namespace dicom {

/// Says of an object, by that profile and by name, that its colours are sRGB's (PS3.3 C.11.15).
void putSrgb(DcmItem& object);

} // namespace dicom

} // namespace limn
