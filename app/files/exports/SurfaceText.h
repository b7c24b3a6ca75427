// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/surfaces/SurfaceExport.h"

#include <QString>

namespace limn {

/// Where the value of a surface comes from that nobody typed.
enum class ValueOrigin { isosurface, pin, point, range };

/// A value to begin with.
struct FirstValue {
  double value = 0.0;
  ValueOrigin origin = ValueOrigin::range;
  bool operator==(const FirstValue&) const = default;
};

/// The isovalue of a scene that shows an isosurface, else the pinned value, else that of the selected point
/// of the curve, else the scene's isovalue where the volume reaches it, else the middle of its range.
FirstValue firstValue(const Scene& scene, std::optional<double> pinned,
                      std::optional<std::size_t> selectedPoint);

/// One sentence each.
QString textOf(ValueOrigin origin);
/// How many triangles, how large the file, in which units and axes.
QString textOf(const SurfaceEstimate& estimate, bool willLoseTriangles);
/// What was made: triangles, whether it is watertight, how far it lies from the isosurface.
QString textOf(const MadeSurface& made, const QString& file);

} // namespace limn
