// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

class DcmItem;

namespace limn {

namespace dicom {

/// Says of an object, by that profile and by name, that its colours are sRGB's (PS3.3 C.11.15).
void putSrgb(DcmItem& object);

} // namespace dicom

} // namespace limn
