// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/DicomObjects.h"
#include "io/looks/dicom/Items.h"

namespace limn::dicom {

/// Fills in the Secondary Capture module and the pixels (PS3.3 A.8.1): what made them, of which images, and
/// that nothing is burned into them. `image` is one of the series.
void putPicture(DcmItem& object, DcmItem& image, const DicomWriting& writing);

} // namespace limn::dicom
