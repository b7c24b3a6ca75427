// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace limn {

/// The file's name without the ending that a volume of labels has (".nii.gz", ".nrrd" …); empty of what is
/// none by its ending.
std::string volumeStem(const std::filesystem::path& file);

/// The structure that the name of such a file tells, as people write it: without the words that only say that
/// it holds labels, at either end, and with spaces ("label_Brain.nii.gz": "Brain", "kidney_left.nii.gz":
/// "kidney left") and without those that may tell whom it shows (withoutPatient). Empty where no letter is
/// left, or of what is no volume by its ending; at most 200 bytes.
std::string structureName(const std::filesystem::path& file, const PatientLabel& patient = {});

/// A file's name without the words that may tell whom it shows: parts of the patient's name and the patient's
/// number, dates, UIDs and other long numbers with the numbers beside them. Errs on the side of taking away;
/// unchanged where there is none.
std::string withoutPatient(std::string_view name, const PatientLabel& patient);

/// Whether a file's name says that it holds labels rather than an image: "liver.seg.nrrd",
/// "label_Brain.nrrd".
bool isNamedLikeLabels(const std::filesystem::path& file);

} // namespace limn
