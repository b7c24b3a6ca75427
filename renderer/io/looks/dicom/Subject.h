// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/Items.h"

// Whom an object shows, and when: what it has from the images it was made of.

namespace limn::dicom {

/// What is copied of patient and study.
enum class SubjectCopy {
  whole,    ///< everything, with the character set that it is written in
  anonymous ///< the UIDs alone, by which a look finds its images
};

/// Writes the modules Patient, General Study, Patient Study and Frame of Reference from an image of the
/// series, which has the UIDs of study and frame.
void putSubject(DcmItem& object, DcmItem& image, SubjectCopy copy);

} // namespace limn::dicom
