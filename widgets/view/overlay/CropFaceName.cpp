// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CropFaceName.h"

#include "widgets/properties/AxisNames.h"

namespace limn {

QString cropFaceName(const Volume& volume, CropFace face) {
  const bool isKnown = volume.info().orientationKnown;
  const AxisName name = axisNames(volume.grid(), isKnown)[static_cast<std::size_t>(face.axis)];
  const QString end = face.isUpper ? name.highEnd : name.lowEnd;
  return isKnown ? end : name.axis + QLatin1Char(' ') + end;
}

} // namespace limn
