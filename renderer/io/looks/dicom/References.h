// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/DicomFolder.h"
#include "io/looks/dicom/Items.h"

// What an object refers to: the images of a look (PS3.3 C.11.23, C.12.2), the image of a picture.

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

/// Writes the relationship of one volume: the input set of all images, and input 1, whose item is returned.
DcmItem& putInput(DcmItem& object, const std::string& inputSet, const std::vector<DicomReference>& images);

/// Lists the images by their series once more.
void putCommonReferences(DcmItem& object, const std::string& series,
                         const std::vector<DicomReference>& images);

/// Writes a sequence with one item, class and instance, for each of the images.
void putReferences(DcmItem& item, const DcmTagKey& sequence, const std::vector<DicomReference>& images);

/// The item of the input sequence. Throws Error (input) for what Limn cannot draw: several inputs, one that
/// is no volume, registered images.
DcmItem& inputIn(DcmItem& object, const std::string& name);

/// The images of that input. Throws Error (input) where there are none.
std::vector<DicomReference> imagesIn(DcmItem& object, DcmItem& input, const std::string& name);

} // namespace limn::dicom
