// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/volume/Histogram.h"

namespace limn {

/// Three values by which a look moves between data without a common scale, ascending.
struct Landmarks {
  double background = 0.0; ///< of air, the 0.5 % quantile
  double object = 0.0;     ///< between background and object (objectThreshold)
  double brightest = 0.0;  ///< the 99.8 % quantile
  bool operator==(const Landmarks&) const = default;
};

/// Air, the limit of tissue, dense bone: the landmarks of Hounsfield units.
inline constexpr Landmarks hounsfieldLandmarks{-1000.0, -300.0, 1500.0};

/// Of a volume's values; always ascending, by a bin at least.
Landmarks landmarksOf(const Histogram& histogram);

/// The value that lies between the landmarks `to` as `value` lies between `from`: linear from each landmark
/// to the next and beyond the outermost.
double moved(double value, const Landmarks& from, const Landmarks& to);

/// Every point moved so.
TransferFunction moved(const TransferFunction& function, const Landmarks& from, const Landmarks& to);

/// The threshold that best separates background from object (N. Otsu, IEEE Trans. SMC 9 (1979) 62), scalar
/// units.
double objectThreshold(const Histogram& histogram);

} // namespace limn
