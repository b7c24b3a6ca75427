// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/PictureFigures.h"

#include <QString>

#include <optional>
#include <vector>

namespace limn {

/// How far one picture of the view is.
struct SideState {
  ShadingModel model = ShadingModel::classic;
  double fraction = 0.0;            ///< of the picture at rest, 0..1
  double stepVoxels = 0.0;          ///< of what is shown, in units of the smallest spacing
  std::optional<double> completeMs; ///< drawing time of the last complete picture at rest
  std::optional<double> contrast;   ///< of the picture at rest, RMS
  std::optional<Overflow> overflow; ///< of the light before it is limited; absent where unlit
  bool operator==(const SideState&) const = default;
};

/// What the compare view shows at the moment, from left to right.
struct PictureState {
  std::vector<SideState> sides;
  bool resting = false; ///< every side is complete at full quality
  QString limitation;   ///< one sentence where the driver could not take the whole volume
  bool operator==(const PictureState&) const = default;
};

} // namespace limn
