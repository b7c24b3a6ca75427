// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Measurement.h"
#include "scene/volume/Volume.h"
#include "widgets/Gesture.h"

#include <QString>

#include <optional>
#include <vector>

namespace limn {

/// What the list of measurements shall be from now on, and which of them is in hand. A gesture without a text
/// is named by whoever knows what was measured.
struct MeasurementsEdited {
  std::vector<Measurement> measurements;
  std::optional<std::size_t> inHand;
  Gesture gesture;
  std::optional<std::size_t> next{}; ///< which place of the one in hand is still to come, while it is drawn
};

/// Whether pictures show it: all but ellipses, which lie in what a slice shows.
bool isSeenInPicture(const Measurement& measurement);

/// "Distance", "Angle", "Ellipse", "Mark".
QString measureKindText(Measurement::Kind kind);

/// What neighbouring values of a volume differ by at least, scalar units: of integers the slope with which
/// they were stored, of others four digits of their range.
double valueStep(const Volume& volume);

/// "38.2 ± 0.7 HU": mean and standard deviation of the values of so many voxels, at least one, with the
/// digits that these carry (decimalsOfMean).
QString meanText(double mean, double deviation, std::size_t voxels, const Volume& volume);

/// What was measured: "23.2 mm", "45.0°", "38 ± 12 HU · 123 mm²"; of a mark nothing. Where no distance
/// between voxels is known, lengths are voxels. An ellipse of no voxel and an angle without legs say so.
QString measureValueText(const Measured& measured, const Volume& volume);

/// What stands beside it in pictures: what was measured, which is never cut, and its name. Of an angle
/// without legs and a distance of nothing its name alone: it may be one that is being drawn.
QString measureNoteText(const Measured& measured, const Volume& volume);

/// What undo and lists call it: "Distance 23.2 mm", "Mark 1". A long name is cut.
QString measureTitle(const Measured& measured, const Volume& volume);

/// What takes one of them away; it names itself.
MeasurementsEdited withoutMeasure(const std::vector<Measured>& measured, std::size_t number,
                                  const Volume& volume);

/// All that is known of it, for a tool tip: of an ellipse also range and number of voxels.
QString measureDetails(const Measured& measured, const Volume& volume);

} // namespace limn
