// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class DcmItem;

namespace limn::dicom {

/// Says of an object, by an ICC profile and by name, that its colours are sRGB's (PS3.3 C.11.15).
void putSrgb(DcmItem& object);

} // namespace limn::dicom
