// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomHeader.h"

namespace limn {

/// Whether a file without pixels must once have had them: its class is one of images, or the attributes that
/// describe pixels are there, or it ends before it says what it is. False for reports, presentation states,
/// plans, structures, waveforms, raw data and other objects that hold no picture by their kind (PS3.4, B.5),
/// and for private kinds that describe no pixels.
bool hasLostPicture(const DicomHeader& header);

} // namespace limn
