// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/regions/Region.h"

#include <QString>

namespace limn {

/// What a segmentation says of a place where a value was read, and how opaque the curve makes it by which
/// that label is shown: "Liver · opacity 0.34". `function` is the scene's, for labels without their own.
/// Empty where no segmentation is open, outside of it and in its background.
QString labelReading(const Region& keep, const TransferFunction& function, const glm::dvec3& index,
                     double value);

/// A reading with what labelReading says behind it: "62 HU · Liver · opacity 0.34".
QString withLabelReading(const QString& reading, const QString& ofLabel);

} // namespace limn
