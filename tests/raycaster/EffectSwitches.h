// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/scenes/SimpleScenes.h"

namespace limn::test {

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

} // namespace limn::test
