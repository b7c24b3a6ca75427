// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/series/DicomSeries.h"

namespace limn {

/// Drops images found more than once (one SOP instance UID), with a warning.
DicomSeries withoutCopies(DicomSeries series, std::vector<std::string>& warnings);

/// Leaves one slice at each position of a placed, sorted series: of several phases (temporal position,
/// trigger time, echo …) one is kept, with a warning. Returns them sorted.
DicomSeries onePhase(const DicomSeries& series, std::vector<std::string>& warnings);

} // namespace limn
