// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/json/JsonFields.h"
#include "scene/view/PlaneSettings.h"

#include <nlohmann/json_fwd.hpp>

namespace limn {

/// What a session file says of the slices beside its picture. Throws Error (input).
PlaneSettings readPlanes(JsonFields fields);

/// The same as it is written.
nlohmann::ordered_json planesJson(const PlaneSettings& settings);

} // namespace limn
