// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <array>
#include <memory>
#include <string>
#include <string_view>

namespace limn {

/// What a reader says of a volume whose file tells no directions.
inline const Message orientationUnknown =
    Message::tr("Orientation unknown: the file does not say which side is left.");

/// The axis of the patient (0 left, 1 back, 2 head) that each grid axis follows, of all ways to hand them out
/// the best; each occurs once. `direction` is orthonormal.
std::array<int, 3> patientAxes(const glm::dmat3& direction);

/// Whether these are three letters that say where columns, rows and slices run to: one of L and R, one of P
/// and A (the back, the front), one of S and I (the head, the feet), in any order.
bool areAxisLetters(std::string_view letters);

/// The letters that the axes of a grid follow best: "LPS" where columns run to the left, rows to the back and
/// slices to the head.
std::string axisLettersOf(const Grid& grid);

/// The grid turned or mirrored about its centre so that its axes run where the letters say (areAxisLetters).
Grid withAxisLetters(Grid grid, const std::string& letters);

/// The same voxels, shared, where a person says how they lie: the orientation is known then, and the file's
/// silence about it no longer told.
std::shared_ptr<const Volume> orientedByHand(const Volume& volume, const std::string& letters);

/// Where the voxels lie for those who have nothing but the file, a label map that was made of it among them:
/// no answer of a person's changes that.
const Grid& gridOfFile(const Volume& volume);

} // namespace limn
