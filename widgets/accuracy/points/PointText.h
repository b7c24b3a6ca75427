// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"

#include <QString>

namespace limn {

/// A time: one decimal below 10 ms.
QString msText(double ms);

/// What a point's error is known to be: "0.66 levels", "less than 0.012 levels", "unknown".
QString pointErrorText(const MeasuredPoint& point, const ReferenceFacts& reference);

/// "step 1/4 voxel" or "exact to half a level", with what else sets the point apart.
QString pointText(const OperatingPoint& point);

/// What a curve of the chart has in common, in a clinician's words: "equal steps, curve averaged"; families
/// that the window does not draw keep the name they have in reports.
QString familyText(const OperatingPoint& point);

/// "Step 1/4 voxel: within 0.66 levels, 48 ms."
QString pointSentence(const MeasuredPoint& point, const ReferenceFacts& reference);

/// All numbers of a point as a small table, rich text.
QString pointToolTip(const MeasuredPoint& point, const AccuracyReport& report);

} // namespace limn
