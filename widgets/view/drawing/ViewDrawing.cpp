// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/ViewDrawing.h"

namespace limn {

RestingPicture restingPicture(const SidePicture& side) {
  return {side.picture().image, side.picture().bytes, side.finishedQuality()};
}

} // namespace limn
