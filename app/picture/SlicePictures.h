// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/PlaneSettings.h"

namespace limn {

struct WindowContext;

/// Puts the slice in a plane on the clipboard as it is seen, with sides, scale and measurements, but without
/// the crosshair. A volume is open.
void copySlice(WindowContext& context, PatientPlane plane);

/// Asks where to save the same as a picture of 8 bits, PNG or TIFF. A volume is open.
void saveSlice(WindowContext& context, PatientPlane plane);

} // namespace limn
