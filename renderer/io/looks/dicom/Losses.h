// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <vector>

namespace limn {

/// What the standard attributes of a presentation state cannot hold of a scene, a sentence each, as other
/// programs see it; Limn itself reads everything back but label maps.
std::vector<Message> lossesOf(const Scene& scene);

} // namespace limn
