// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SceneFile.h"

namespace limn {

struct Comparison;

/// What a saved picture tells of its sides, so that it is drawn and opened as it was. A look is called by the
/// name of the program's preset that it is, and otherwise by none: pictures travel, and names that somebody
/// gave stay here.
ShownSides savedSides(const Comparison& shown);

} // namespace limn
