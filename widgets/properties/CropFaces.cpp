// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/CropFaces.h"

#include "scene/regions/BodyAndLabels.h"
#include "scene/volume/Orientation.h"
#include "widgets/Translated.h"

#include <QObject>

#include <algorithm>
#include <cmath>

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

QString turnedFaceName(const TurnedBox& box, const Volume& volume, CropFace face) {
  if (volume.info().orientationKnown) {
    const AxisName name = axisNames(box.grid, true)[static_cast<std::size_t>(face.axis)];
    return inSentence(face.isUpper ? name.highEnd : name.lowEnd);
  }
  const std::array<std::array<QString, 2>, 3> ends{{{QObject::tr("left-hand"), QObject::tr("right-hand")},
                                                    {QObject::tr("near"), QObject::tr("far")},
                                                    {QObject::tr("lower"), QObject::tr("upper")}}};
  return ends[static_cast<std::size_t>(face.axis)][face.isUpper ? 1 : 0];
}

double cutBy(const TurnedBox& box, CropFace face) {
  const double inwards = placeOf(box.crop, face) - placeOf(box.fit, face);
  return std::max(0.0, face.isUpper ? -inwards : inwards);
}

double placeOf(const CropBox& crop, CropFace face) {
  return (face.isUpper ? crop.upper : crop.lower)[face.axis];
}

CropBox withFaceAt(const CropBox& crop, const Grid& grid, CropFace face, double fraction) {
  const int axis = face.axis;
  const double thinnest = 1.0 / grid.dims[axis];
  CropBox edited = crop;
  if (face.isUpper)
    edited.upper[axis] = std::clamp(fraction, std::min(1.0, crop.lower[axis] + thinnest), 1.0);
  else
    edited.lower[axis] = std::clamp(fraction, 0.0, std::max(0.0, crop.upper[axis] - thinnest));
  return edited;
}

CropBox boxAroundBody(const Scene& scene) {
  if (!scene.volume || !hidesTable(scene.keep))
    return {};
  // Of a body what is kept, of a segmentation beside it all that is not the table; cuts take none of that.
  const LabelMap& map = scene.keep.isCut ? *scene.keep.uncut : *scene.keep.labels;
  const std::size_t own = ownLabels(scene.keep);
  const std::size_t table = tableLabel(scene.keep).value_or(0);
  VoxelBox tight;
  for (std::size_t place = 0; place < own; ++place)
    if (const VoxelBox& box = map.boxAround(place); place != table && box.lower != box.upper)
      tight = tight.lower == tight.upper
                  ? box
                  : VoxelBox{glm::min(tight.lower, box.lower), glm::max(tight.upper, box.upper)};
  if (tight.lower == tight.upper)
    return {};
  const VoxelBox box = widened(tight, scene.volume->grid());
  const glm::dvec3 dims(scene.volume->grid().dims);
  return {glm::dvec3(box.lower) / dims, glm::dvec3(box.upper) / dims};
}

double shareLeft(const CropBox& crop) {
  const glm::dvec3 size = crop.upper - crop.lower;
  return size.x * size.y * size.z;
}

VoxelSpan voxelsInside(const CropBox& crop, const Grid& grid, int axis) {
  // The centre of voxel i lies at the fraction (i + ½)/n; the small term keeps a face on a voxel's border
  // from falling to either side by rounding.
  const double n = grid.dims[axis];
  const double first = std::ceil(crop.lower[axis] * n - 0.5 - 1e-9);
  const double last = std::ceil(crop.upper[axis] * n - 0.5 - 1e-9) - 1.0;
  return {static_cast<int>(first) + 1, static_cast<int>(last) + 1};
}

} // namespace limn
