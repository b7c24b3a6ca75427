// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/CpuRenderer.h"
#include "engine/PathFigures.h"
#include "io/scenefile/SceneFile.h"
#include "scene/Scene.h"
#include "scene/basics/Effort.h"
#include "scene/basics/Image.h"
#include "scene/basics/Message.h"

#include <vector>

namespace limn {

/// What following paths takes of the time of a picture whose noise is filtered, about.
inline constexpr double shareOfPaths = 0.8;

/// A picture of physical light, its linear radiance times alpha as paths found it, and what it came to.
struct DrawnByPaths {
  Image image;
  Image radiance;
  PathFigures figures;
  double seconds = 0.0;
};

/// Draws a scene of physical light until its paths, levels or seconds are reached (DEFINITION section 12), or
/// as many paths as its quality says: in
/// passes that grow, each of which goes on from the last. A picture that takes longer for its first pass than
/// it has seconds has that pass; of seconds it is told all the time how many went. Where the scene
/// asks for it, noise that remains is filtered (cpu/paths/NoiseFilter). Throws Error, also where
/// the memory that is free does not hold what paths find (72 bytes a pixel, where noise is filtered 224);
/// Cancelled.
DrawnByPaths drawnByPaths(CpuRenderer& renderer, const Scene& scene, const glm::ivec2& size,
                          const Effort& effort);

/// How many paths a picture has that takes its next pass, given those it has, the error and time of them; the
/// same number where it is complete.
int nextPaths(const Until& until, const PathFigures& figures, double seconds);

/// Throws Error where the memory that is free does not hold what the paths of so many pixels find, and what a
/// filter of their noise takes, beside the picture itself.
void requireMemoryForPaths(const glm::ivec2& size, bool filtersNoise = false);

/// How many paths a picture has and its standard error, one sentence.
Message sentenceOf(const PathFigures& figures);

/// What the file of such a picture keeps of it.
PictureAccuracy accuracyOf(const PathFigures& figures);

/// The same of pictures that stand in one file: of the one that lies farthest off. There is one at least.
PictureAccuracy accuracyOf(const std::vector<PathFigures>& pictures);

/// What whoever asked is told of it, a sentence each: paths and error, and what of the scene was left out.
std::vector<Message> notesOf(const PathFigures& figures, const Scene& scene);

} // namespace limn
