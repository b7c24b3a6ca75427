// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <vector>

namespace limn {

/// Scenes that a slider can reach from this one in one drag and that ask for effects which it may not ask
/// for: every slider off the value at which its effect vanishes (a density of 0, a range of width 0, …), with
/// and without pre-integration where the program chooses, and the gradient curve at both sides of its
/// straight line. Choices from lists are left as they are, but that classic counts as the enhanced model that
/// it is a case of.
std::vector<Scene> neighbours(const Scene& scene);

} // namespace limn
