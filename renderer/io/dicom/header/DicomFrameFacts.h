// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomHeader.h"

namespace limn {

/// The facts of each of `count` frames: from the per-frame functional groups, else from the shared ones, else
/// from the data set itself (a single image; a dose grid with its frame offsets).
std::vector<DicomFrame> framesOf(const DicomDataset& dataset, int count);

} // namespace limn
