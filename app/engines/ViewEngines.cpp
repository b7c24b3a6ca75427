// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engines/ViewEngines.h"

#include "raycaster/RayCasterEngine.h"
#include "reference/ReferenceEngine.h"

namespace limn {

DrawingEngines viewEngines() {
  return {makeRayCasterEngine, [] { return makeReferenceEngine(); }};
}

} // namespace limn
