// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Error.h"
#include "scene/basics/Message.h"
#include "scene/steps/RayFrame.h"
#include "scene/volume/Volume.h"

namespace limn {

/// An engine of a driver cannot draw a scene. The driver is well: it may draw others, and another engine this
/// one.
class BeyondDriver : public Error {
public:
  explicit BeyondDriver(const Message& sentence) : Error(Kind::openGl, sentence) {}
};

/// An engine has no room for the whole volume, and was told not to draw less.
class VolumeTooLarge : public BeyondDriver {
public:
  explicit VolumeTooLarge(const Message& sentence) : BeyondDriver(sentence) {}
};

/// Throws BeyondDriver where no shader finds a scene's light: light that travels (hasTravellingLight) for
/// each sample, where shaders look it up on a grid; and physical light (isPhysical).
void requireLightOfShaders(const Scene& scene);

/// Throws VolumeTooLarge where the volume does not lie in memory: a graphics driver would copy all of it.
void requireInMemory(const Volume& volume);

/// A sentence where the longest ray of a scene would need more than `most` samples, empty where not.
inline Message stepLimitation(const Scene& scene, int most) {
  if (longestRaySamples(scene) <= most)
    return {};
  return Message::tr(
             "The step is so small that long rays would need more than %1 samples; they are drawn with that "
             "number.")
      .arg(most);
}

} // namespace limn
