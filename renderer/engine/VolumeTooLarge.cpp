// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/VolumeTooLarge.h"

#include "scene/effects/EffectPlan.h"

namespace limn {

void requireLightOfShaders(const Scene& scene) {
  const Quality& quality = scene.quality;
  if ((quality.toleranceLevels || quality.light == LightDetail::sampled) && hasTravellingLight(scene))
    throw BeyondDriver(Message::tr("The processor alone keeps a tolerance where shadows or occlusion show."));
  if (isPhysical(scene))
    throw BeyondDriver(Message::tr("Physical light is drawn by the processor, not with OpenGL."));
}

void requireInMemory(const Volume& volume) {
  if (!volume.room())
    return;
  const glm::ivec3& dims = volume.grid().dims;
  throw VolumeTooLarge(
      Message::tr("The volume of %1 voxels does not lie in memory, from where the graphics "
                  "driver would copy it.")
          .arg(std::to_string(dims.x) + "×" + std::to_string(dims.y) + "×" + std::to_string(dims.z)));
}

} // namespace limn
