// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/exports/SurfaceText.h"

#include <QLocale>
#include <QObject>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double stlBytesEach = 50.0; // of a triangle

QString millimetres(double mm) {
  return QLocale().toString(mm, 'g', 2);
}

QString counted(std::uint64_t count) {
  return QLocale().toString(static_cast<qulonglong>(count));
}

// To two digits.
QString about(std::uint64_t count) {
  const auto number = static_cast<double>(count);
  if (number >= 1e6)
    return QObject::tr("%1 million").arg(QLocale().toString(number / 1e6, 'f', number < 1e7 ? 1 : 0));
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(number, 1.0))) - 1.0));
  return counted(static_cast<std::uint64_t>(std::llround(number / unit) * std::llround(unit)));
}

} // namespace

FirstValue firstValue(const Scene& scene, std::optional<double> pinned,
                      std::optional<std::size_t> selectedPoint) {
  if (scene.projection == Projection::isosurface || scene.projection == Projection::compositeIsosurface)
    return {scene.isovalue, ValueOrigin::isosurface};
  if (pinned)
    return {*pinned, ValueOrigin::pin};
  if (selectedPoint && *selectedPoint < scene.transferFunction.points.size())
    return {scene.transferFunction.points[*selectedPoint].value, ValueOrigin::point};
  const ValueRange& range = scene.volume->range();
  if (scene.isovalue > range.lowest && scene.isovalue <= range.highest)
    return {scene.isovalue, ValueOrigin::range};
  return {0.5 * (range.lowest + range.highest), ValueOrigin::range};
}

QString textOf(ValueOrigin origin) {
  switch (origin) {
  case ValueOrigin::isosurface:
    return QObject::tr("The isosurface that the picture shows.");
  case ValueOrigin::pin:
    return QObject::tr("The value that is pinned on the curve.");
  case ValueOrigin::point:
    return QObject::tr("The value of the selected point of the curve.");
  case ValueOrigin::range:
    return QObject::tr("Pin a value with a Shift+click in the picture to begin with that.");
  }
  return {};
}

QString textOf(const SurfaceEstimate& estimate, bool willLoseTriangles) {
  const double megabytes = stlBytesEach * static_cast<double>(estimate.triangles) / 1e6;
  const QString size =
      QObject::tr("About %1 triangles, %2 MB as STL; making it takes %3 MB of memory.")
          .arg(about(estimate.triangles), QLocale().toString(megabytes, 'f', megabytes < 10.0 ? 1 : 0),
               QLocale().toString(estimate.bytes / 1e6, 'f', 0));
  const QString fewer = QObject::tr("Those that the distance allows are taken away.");
  const QString axes =
      QObject::tr("Millimetres in the patient's axes: x to the left, y to the back, z to the head (LPS).");
  return willLoseTriangles ? QStringLiteral("%1 %2\n%3").arg(size, fewer, axes)
                           : QStringLiteral("%1\n%2").arg(size, axes);
}

QString textOf(const MadeSurface& made, const QString& file) {
  QString text = QObject::tr("Saved %1: %2 triangles.").arg(file, counted(made.mesh.triangles.size()));
  text +=
      QLatin1Char(' ') +
      (made.edges.isWatertight()
           ? QObject::tr("It is watertight: every edge is used twice.")
           : QObject::tr("It is open: %1 edges lie at the rims of holes.").arg(counted(made.edges.usedOnce)));
  text += QLatin1Char('\n') +
          QObject::tr("It lies at most %1 mm from the isosurface (%2 mm in the mean), measured "
                      "at %3 points each way.")
              .arg(millimetres(made.error.largest()), millimetres(made.error.ofMesh.mean),
                   counted(made.error.ofMesh.points));
  if (made.order.toleranceMm > 0.0 && made.error.largest() > made.order.toleranceMm)
    text += QLatin1Char(' ') +
            QObject::tr(
                "That is more than the %1 mm asked for, because the cells are too coarse in places; choose "
                "more detail.")
                .arg(millimetres(made.order.toleranceMm));
  if (made.dropped.parts + made.dropped.hollows > 0)
    text += QLatin1Char('\n') + QObject::tr("Small parts left out: %1; small hollows filled: %2.")
                                    .arg(made.dropped.parts)
                                    .arg(made.dropped.hollows);
  return text;
}

} // namespace limn
