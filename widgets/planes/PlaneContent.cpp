// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneContent.h"

#include "planes/PlaneGrid.h"
#include "scene/volume/Orientation.h"
#include "widgets/ValueText.h"
#include "widgets/view/overlay/LabelReading.h"
#include "widgets/view/overlay/OrientationMarks.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// The plane whose slices follow each other along an axis of the patient.
PatientPlane planeAcross(int axis) {
  return axis == 0 ? PatientPlane::sagittal : axis == 1 ? PatientPlane::coronal : PatientPlane::axial;
}

glm::dvec3 withinSlices(const Grid& grid, glm::dvec3 place) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    const ReachMm reach = reachAlong(grid, direction);
    const double half = std::min(sliceStepMm(grid, planeAcross(axis)), reach.last - reach.first) / 2.0;
    place[axis] =
        std::clamp(place[axis], reach.first + half, std::max(reach.first + half, reach.last - half));
  }
  return place;
}

// "45/108" of slices that are the grid's own, counted as files do, from the first; empty of others.
QString sliceCount(const Grid& grid, const PlaneAxes& axes, const glm::dvec3& crosshairMm) {
  constexpr double parallel = 1.0 - 1e-9;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(glm::dot(grid.direction[axis], axes.forward)) > parallel) {
      const double index = worldToIndex(grid, crosshairMm)[axis];
      const int slice = std::clamp(static_cast<int>(std::floor(index + 0.5)), 0, grid.dims[axis] - 1);
      return QStringLiteral("%1/%2").arg(slice + 1).arg(grid.dims[axis]);
    }
  return {};
}

} // namespace

glm::dvec3 crosshairOf(const PlaneContent& content) {
  return content.settings.crosshairMm.value_or(middleVoxelMm(content.volume->grid()));
}

Grid seenGrid(const PlaneContent& content) {
  const Grid& all = content.volume->grid();
  if (content.keep.kind != Region::Kind::body || !content.keep.labels)
    return all;
  const VoxelBox& body = content.keep.labels->boxAround(1);
  return body.lower == body.upper ? all : partOf(all, widened(body, all));
}

GreyWindow windowOf(const PlaneContent& content) {
  return content.settings.window.value_or(content.firstWindow);
}

std::optional<double> valueUnderCrosshair(const PlaneContent& content) {
  if (!content.volume || !isInside(content.volume->grid(), crosshairOf(content)))
    return std::nullopt;
  return valueAt(*content.volume, worldToIndex(content.volume->grid(), crosshairOf(content)));
}

PlaneSettings withCrosshair(const PlaneContent& content, const glm::dvec3& worldMm) {
  PlaneSettings settings = content.settings;
  settings.crosshairMm = withinSlices(content.volume->grid(), worldMm);
  return settings;
}

PlaneSettings withCrosshairMoved(const PlaneContent& content, const glm::dvec3& direction, int slices) {
  const glm::dvec3 size = glm::abs(direction);
  const int axis = size.x > 0.5 ? 0 : size.y > 0.5 ? 1 : 2;
  const double step = sliceStepMm(content.volume->grid(), planeAcross(axis));
  return withCrosshair(content, crosshairOf(content) + slices * step * direction);
}

PlaneSettings withLargeToggled(PlaneSettings settings, PatientPlane plane) {
  const bool isLarge = settings.layout == PlaneLayout::oneLarge && settings.large == plane;
  settings.layout = isLarge ? PlaneLayout::pictureAndThree : PlaneLayout::oneLarge;
  settings.large = plane;
  return settings;
}

QString planeTitle(const Volume& volume, PatientPlane plane) {
  const bool isKnown = volume.info().orientationKnown;
  switch (plane) {
  case PatientPlane::axial:
    return isKnown ? QObject::tr("Axial") : QObject::tr("Columns × rows");
  case PatientPlane::coronal:
    return isKnown ? QObject::tr("Coronal") : QObject::tr("Columns × slices");
  case PatientPlane::sagittal:
    return isKnown ? QObject::tr("Sagittal") : QObject::tr("Rows × slices");
  }
  return {};
}

QString slicePlaceText(const PlaneContent& content, PatientPlane plane) {
  const PlaneAxes axes = axesOf(plane);
  const glm::dvec3 crosshair = crosshairOf(content);
  const double mm = glm::dot(crosshair, axes.forward);
  const bool isKnown = content.volume->info().orientationKnown;
  QString place = valueText(isKnown ? std::abs(mm) : mm, QObject::tr("mm"), 1);
  if (isKnown) // the side first: a length first reads like a thickness
    place.prepend(QString::fromStdString(lettersOf(mm < 0.0 ? -axes.forward : axes.forward)) + QChar(0x00a0));
  const QString count = sliceCount(content.volume->grid(), axes, crosshair);
  return count.isEmpty() ? place : QStringLiteral("%1 · %2").arg(place, count);
}

QString crosshairText(const PlaneContent& content) {
  const std::optional<double> value = valueUnderCrosshair(content);
  if (!value)
    return {};
  const glm::dvec3 index = worldToIndex(content.volume->grid(), crosshairOf(content));
  return withLabelReading(
      valueText(*value, QString::fromStdString(content.volume->info().unit), valueDecimals(*content.volume)),
      labelReading(content.keep, content.function, index, *value));
}

QString windowText(const PlaneContent& content) {
  const GreyWindow window = windowOf(content);
  const auto number = [](double value, double step) { return valueText(value, {}, decimalsFor(step)); };
  const double step = window.width / 500.0;
  QString grey = QObject::tr("W %1 · L %2").arg(number(window.width, step), number(window.centre, step));
  const Slab& slab = content.settings.slab;
  if (slab.thicknessMm <= 0.0)
    return grey;
  const QString thickness = valueText(slab.thicknessMm, QObject::tr("mm"), 1);
  return QStringLiteral("%1 · %2").arg(
      (slab.mode == Slab::Mode::mean ? QObject::tr("mean %1") : QObject::tr("max %1")).arg(thickness), grey);
}

int valueDecimals(const Volume& volume) {
  const double span = volume.range().highest - volume.range().lowest;
  return span > 0.0 ? std::clamp(static_cast<int>(3.0 - std::log10(span)), 0, 6) : 0;
}

} // namespace limn
