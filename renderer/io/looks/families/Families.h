// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"

namespace limn {

// One function a family.
LookFormat limnSceneFormat();
LookFormat limnPresetFormat();
LookFormat dicomFormat();
LookFormat slicerJsonFormat();
LookFormat slicerTextFormat();
LookFormat mrmlFormat();
LookFormat osirixPlistFormat();
LookFormat paraViewJsonFormat();
LookFormat weasisJsonFormat();
LookFormat weasisMapsFormat();
LookFormat inviwoFunctionFormat();
LookFormat voreenFunctionFormat();
LookFormat mitkFunctionFormat();
LookFormat mricroglClutFormat();
LookFormat niivueMapFormat();
LookFormat imageVisTableFormat();

} // namespace limn
