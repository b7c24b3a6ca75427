// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"

namespace limn {

// One function a family; each stands in a file of its own.
LookFormat limnPresetFormat();
LookFormat dicomFormat();

} // namespace limn
