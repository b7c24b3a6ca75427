// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorMap.h"
#include "accuracy/sweep/OperatingPoint.h"

namespace limn {

/// A picture compared with the exact one, pixel by pixel.
struct ComparedPicture {
  OperatingPoint point; ///< of the picture
  ReferenceFacts reference;
  ImageError error;
  ErrorMap map; ///< empty where the exact picture has not converged
};

} // namespace limn
