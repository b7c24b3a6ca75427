// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"

#include <array>
#include <optional>

namespace limn {

struct Camera;

/// Lights that are chosen in one go.
enum class LightPreset { headlight, studio, softStudio, overcast, physical };
inline constexpr std::array lightPresets{LightPreset::headlight, LightPreset::studio, LightPreset::softStudio,
                                         LightPreset::overcast, LightPreset::physical};

/// Ia and Id, as a headlight has them.
struct LightStrengths {
  double ambient = Shading().ambientIntensity;
  double lamp = Shading().lightIntensity;
};

/// A shading with a preset's light: where it comes from, shadow and occlusion; how tissue answers it stays.
/// The strengths Ia and Id are those of a headlight, raised or lowered so that pictures keep their
/// brightness: of the one that was there where that is known, so that it comes back whatever was changed in
/// between, else of the one that the shading's own preset would give; of a light of one's own they are set
/// anew. Over the shared volumes the mean of what shows changes by at most 11 % of heads, bone and brain, 21
/// % of an engine block and 42 % of a bonsai, which shines through. `physical` is the studio's lamp and a sky
/// in physical light, which it makes the model; its exposure keeps the brightness of heads. Any other makes
/// it the first model again.
Shading withLight(Shading shading, LightPreset preset,
                  const std::optional<LightStrengths>& ofHeadlight = std::nullopt);

/// The preset whose light a shading has, however strong and however exposed; absent where it is a light of
/// one's own.
std::optional<LightPreset> lightPresetOf(const Shading& shading);

/// The word for a preset on the command line.
const char* nameOf(LightPreset preset);

/// Where a light stands that turns with the camera, as seen from the viewer: unit vector to the right,
/// upwards, and towards the viewer.
glm::dvec3 seenFromViewer(const Shading& shading, const Camera& camera);

/// The same light seen there: told in the axes that the shading's is told in. A headlight becomes one that
/// turns with the camera.
Shading withLightSeenAt(Shading shading, const glm::dvec3& place, const Camera& camera);

} // namespace limn
