// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/DicomObjects.h"
#include "io/reading/Progress.h"
#include "scene/basics/Image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// The series that a scene shows, of which `dicom` holds the headers; null: they are read. Throws Error
/// (usage) where it shows none of DICOM's; Cancelled.
SeriesImages shownSeries(const std::string& volumePath, std::shared_ptr<const DicomFolder> dicom,
                         std::optional<int> series, const Progress& progress);

/// Throws the Error that saving into this folder, which is there or is made, would end with; to be asked
/// before the picture is drawn.
void requireDicomFolder(const std::filesystem::path& folder);

/// Writes scene and picture into a folder, which is made, as `look.dcm`, `picture.dcm` and maybe
/// `segments.dcm`; `remark`, which may be empty, tells there how exact the picture is. Returns what other
/// programs do not find in the look, a sentence each. Throws Error.
std::vector<Message> saveToDicom(const std::filesystem::path& folder, const Scene& scene,
                                 const Image& picture, const SeriesImages& series, bool isAnonymous,
                                 const std::string& remark = {});

} // namespace limn
