// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/view/pictures/PictureState.h"

#include <QString>

#include <vector>

namespace limn {

/// How close the pictures on screen come to the exact ones, in parts of one line; parts that are not known
/// are empty. Of several pictures the worst is told.
struct PictureStatusText {
  QString badge;    ///< "preview", "refining", "exact to the screen" or that it is not
  QString estimate; ///< "within 0.7 of 255 levels"
  QString step;     ///< "refined, step 1/16 voxel"
  QString time;     ///< "23 ms"
  QString engine;   ///< "OpenGL" or "processor"
  QString toolTip;  ///< the same for who wants to know exactly, several lines
  bool operator==(const PictureStatusText&) const = default;

  /// The parts in one line, but for the badge.
  QString line() const;
};

/// Of pictures in that state, of a scene.
PictureStatusText pictureStatusText(const PictureState& told, const Scene& scene);

/// A step in units of the smallest voxel spacing: "1/16 voxel", "0.3 voxel", "2 voxels".
QString stepText(double stepVoxels);

/// "23 ms", from a second on "1.9 s".
QString timeText(double ms);

/// An error in 8-bit levels; never "0".
QString levelsText(double levels);

/// Texts as wide as those that commonly stand in each part while a picture moves and refines: with room for
/// them, what is next to a part need not move when it changes.
std::vector<PictureStatusText> commonStatusTexts();

} // namespace limn
