// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

#include <string>

namespace limn {

/// A camera that was kept under a name.
struct NamedView {
  std::string name; ///< UTF-8, not empty
  Camera camera;
  bool operator==(const NamedView&) const = default;
};

} // namespace limn
