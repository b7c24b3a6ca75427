// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/JsonFields.h"
#include "io/scenefile/SceneFile.h"

// What the files that contain a scene share; for this folder only.

namespace limn {

/// The text as JSON. Throws Error (input) calling the file `name`.
nlohmann::json parsedJson(std::string_view text, const std::string& name);

/// Refuses a document whose `key` is not the version that this program reads; `what` it would be otherwise.
void requireVersion(JsonFields& fields, const std::string& key, const std::string& what);

/// Reads every field of a scene file and refuses others.
SceneDocument readScene(JsonFields fields);

/// The fields of a scene file; `volume` is stored as given.
nlohmann::ordered_json sceneJson(const Scene& scene, const std::string& volume);

/// JSON as the text of a file, ASCII.
std::string textOf(const nlohmann::ordered_json& json);

} // namespace limn
