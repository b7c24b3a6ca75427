// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"

#include <QString>

namespace limn {

/// "Axial"; where the file says nothing of sides, what is stacked in the plane: "Columns × rows".
QString planeTitle(const Volume& volume, PatientPlane plane);

/// Where the slice lies: "12.3 mm S · 45/108". The number of slices stands only where the grid's axes are the
/// patient's, the letter only where sides are known.
QString slicePlaceText(const PlaneContent& content, PatientPlane plane);

/// The value under the crosshair, "38 HU"; empty where it lies outside.
QString crosshairText(const PlaneContent& content);

/// "W 400 · L 40"; of a slab "max 20 mm · W 400 · L 40".
QString windowText(const PlaneContent& content);

/// "12.3 mm".
QString distanceText(const MeasuredDistance& distance);

/// The decimals that values of a volume are worth showing with.
int valueDecimals(const Volume& volume);

} // namespace limn
