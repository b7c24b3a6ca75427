// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/json/JsonFields.h"
#include "io/scenefile/SceneFile.h"

// What the files that contain a scene share; for this folder only.

namespace limn {

/// Reads every field of a scene file and refuses others.
SceneDocument readScene(JsonFields fields);

/// The fields of a scene file; `volume` is stored as given.
nlohmann::ordered_json sceneJson(const Scene& scene, const std::string& volume);

} // namespace limn
