// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/view/PictureState.h"

#include <QString>

namespace limn {

/// How close the pictures on screen come to the exact ones, in parts of one line; parts that are not known
/// are empty. Of several pictures the worst is told.
struct AccuracyText {
  QString estimate; ///< "within 0.7 of 255 levels"
  QString step;     ///< "refined, step 1/16 voxel"
  QString time;     ///< "23 ms"
  QString engine;   ///< "GLSL"
  QString toolTip;  ///< the same for who wants to know exactly, several lines
  bool operator==(const AccuracyText&) const = default;

  /// The parts in one line.
  QString line() const;
};

AccuracyText accuracyText(const PictureState& state, const Scene& scene);

/// A step in units of the smallest voxel spacing: "1/16 voxel", "0.3 voxel", "2 voxels".
QString stepText(double stepVoxels);

/// The widest texts that commonly stand in each part: what is next to one need not move when it changes.
AccuracyText widestAccuracyText();

} // namespace limn
