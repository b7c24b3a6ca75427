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

/// What switches an effect on or off, to be combined.
const std::vector<Variation>& switches();

/// A value of an effect that draws nothing, and one just off it.
struct Neutral {
  const char* what;
  void (*setNeutral)(Scene&);
  void (*setJustOff)(Scene&);
};

/// Every effect that has a neutral value.
const std::vector<Neutral>& neutralValues();

} // namespace limn
