// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <vector>

namespace limn {

/// One change of a scene.
struct Variation {
  const char* what;
  void (*apply)(Scene&);
};

/// Every parameter of a scene changed in turn: each must show in a lit picture of the robust model.
const std::vector<Variation>& everyParameter();

} // namespace limn
