// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Suggestion.h"

#include <QString>

namespace limn {

/// How the values of a volume are told.
struct ValueNames {
  QString unit;
  bool isHounsfield = false; ///< tissues have names
};

/// What a boundary is called: "Bone", "Fat to soft tissue, blood", "Surface at 460".
QString boundaryName(const Boundary& boundary, const ValueNames& names);

/// Where it lies and how much of all boundaries it is.
QString boundaryExplained(const Boundary& boundary, const ValueNames& names);

} // namespace limn
