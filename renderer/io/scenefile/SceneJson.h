// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/json/JsonFields.h"
#include "io/scenefile/SceneFile.h"
#include "scene/view/PlaneSettings.h"

// What the files that contain a scene share; for this folder only.

namespace limn {

inline constexpr Words<GradientCurve::Type, 3> gradientCurveWords{{"linear", "gamma", "log"}};
inline constexpr Words<SpecularColor, 2> specularColorWords{{"material", "light"}};
inline constexpr Words<Reflection, 2> reflectionWords{{"blinn", "phong"}};
inline constexpr Words<Fog::Mode, 4> fogWords{{"none", "linear", "exp", "exp2"}};
inline constexpr Words<Preintegration, 3> preintegrationWords{{"auto", "always", "never"}};

// Of places, mm: a kilometre from the origin lies no patient.
inline constexpr Limits placeLimits{-1e6, 1e6};

/// The name of an item of a list in errors, counted from 0 as other readers of JSON count.
std::string placeIn(const char* list, std::size_t index);

/// A camera, where fields are absent the default's; refuses others.
Camera readCamera(JsonFields fields);

/// The fields of a camera, as readCamera reads them.
nlohmann::ordered_json cameraJson(const Camera& camera);

/// The field `views` of a scene, which is there: cameras by name.
std::vector<NamedView> readViews(JsonFields& scene);

/// The field `views`, as readViews reads it.
nlohmann::ordered_json viewsJson(const std::vector<NamedView>& views);

/// Reads every field of a scene file and refuses others.
SceneDocument readScene(JsonFields fields);

/// The field `accuracy` of a scene: what a saved picture says of itself; it decides nothing.
PictureAccuracy readAccuracy(JsonFields fields);

/// The field `accuracy`, as readAccuracy reads it; what is not known is left out.
nlohmann::ordered_json accuracyJson(const PictureAccuracy& accuracy);

/// The field `keep` of a scene, which is there.
KeptPart readKeptPart(JsonFields& scene);

/// Reads every field of a preset beside its version, and refuses others.
Preset readPreset(JsonFields& fields);

/// The fields of a preset beside its version.
nlohmann::ordered_json presetJson(const Preset& preset);

/// A transfer function; `where` names it in errors. Refuses other fields. Throws Error (input).
TransferFunction readTransferFunction(JsonFields fields, const std::string& where);

/// The fields of a transfer function, as readTransferFunction reads them.
nlohmann::ordered_json functionJson(const TransferFunction& function);

/// The field `keep`, as readKeptPart reads it.
nlohmann::ordered_json keptPartJson(const KeptPart& part);

/// The fields of a scene file; the volume is stored as given, and `keep` in place of the scene's own.
nlohmann::ordered_json sceneJson(const SceneDocument& document);

/// What a session file says of the slices beside its picture. The one distance that older files have there is
/// added to `measurements`. Throws Error (input).
PlaneSettings readPlanes(JsonFields fields, std::vector<Measurement>& measurements);

/// The same as it is written.
nlohmann::ordered_json planesJson(const PlaneSettings& settings);

/// The field `measurements` of a scene; none where there is no such field. Throws Error (input).
std::vector<Measurement> readMeasurements(JsonFields& scene);

/// The same as it is written.
nlohmann::ordered_json measurementsJson(const std::vector<Measurement>& measurements);

/// The distance that older files have among what slices show. Throws Error (input).
Measurement readOldDistance(JsonFields fields);

} // namespace limn
