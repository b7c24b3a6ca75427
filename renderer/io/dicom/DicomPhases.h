// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/DicomSeries.h"

namespace limn {

/// Leaves one slice at each position of a placed, sorted series: copies of an image are dropped, of several
/// phases (temporal position, trigger time, echo …) one is kept, all with a warning. Returns them sorted.
DicomSeries onePhase(const DicomSeries& series, std::vector<std::string>& warnings);

} // namespace limn
