// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/AxisNames.h"

#include "scene/volume/Orientation.h"

#include <QObject>

namespace limn {
namespace {

AxisName between(const QString& lowEnd, const QString& highEnd) {
  return {lowEnd + QChar(0x2013) + highEnd, lowEnd, highEnd};
}

AxisName alongPatient(int direction, bool isForward) {
  // LPS: +x is the patient's left, +y the back, +z the head.
  const std::array<std::array<QString, 2>, 3> ends{{{QObject::tr("Right"), QObject::tr("Left")},
                                                    {QObject::tr("Front"), QObject::tr("Back")},
                                                    {QObject::tr("Feet"), QObject::tr("Head")}}};
  const auto& [low, high] = ends[static_cast<std::size_t>(direction)];
  return isForward ? between(low, high) : between(high, low);
}

} // namespace

std::array<AxisName, 3> axisNames(const Grid& grid, bool orientationKnown) {
  std::array<AxisName, 3> names;
  if (!orientationKnown) {
    const QString first = QObject::tr("first");
    const QString last = QObject::tr("last");
    names[0] = {QObject::tr("Columns"), first, last};
    names[1] = {QObject::tr("Rows"), first, last};
    names[2] = {QObject::tr("Slices"), first, last};
    return names;
  }
  const std::array<int, 3> directions = patientAxes(grid.direction);
  for (int axis = 0; axis < 3; ++axis) {
    const int direction = directions[static_cast<std::size_t>(axis)];
    names[static_cast<std::size_t>(axis)] = alongPatient(direction, grid.direction[axis][direction] > 0.0);
  }
  return names;
}

QString cropFaceName(const Volume& volume, CropFace face) {
  const bool isKnown = volume.info().orientationKnown;
  const AxisName name = axisNames(volume.grid(), isKnown)[static_cast<std::size_t>(face.axis)];
  const QString end = face.isUpper ? name.highEnd : name.lowEnd;
  return isKnown ? end : name.axis + QLatin1Char(' ') + end;
}

} // namespace limn
