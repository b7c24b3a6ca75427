// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ImageFile.h"
#include "io/dicom/DicomFolder.h"
#include "scene/Scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limn {

/// What the two objects need beside the scene.
struct DicomWriting {
  SeriesImages series;      ///< that the scene shows
  BytePicture picture;      ///< of the scene, RGB, without annotation
  std::string version;      ///< of Limn
  std::string remark{};     ///< how exact the picture is, one sentence; may be empty
  bool isAnonymous = false; ///< leave out what the series says of its patient and study, but for UIDs
};

/// A scene and its picture as objects for an archive.
struct DicomObjects {
  std::string look;     ///< a file: Volume Rendering Volumetric Presentation State
  std::string picture;  ///< a file: Secondary Capture
  std::string segments; ///< a file: Segmentation, of what is kept and cut away; empty where all is kept
  std::vector<Message> losses; ///< what programs other than Limn do not find in the look, a sentence each
};

/// Whether segments.dcm goes with the other two: something is kept by label, cut away or told apart.
bool hasSegments(const Scene& scene);

/// Makes the objects, in the study and frame of reference of the series, each in a series of its own with new
/// UIDs. They hold no path and no name of a file. Throws Error.
DicomObjects dicomObjectsOf(const Scene& scene, const DicomWriting& writing);

/// The look alone, without a picture that goes with it. Throws Error.
std::string dicomLookOf(const Scene& scene, const SeriesImages& series, const std::string& version);

/// Writes them as `look.dcm`, `picture.dcm` and, where there are segments, `segments.dcm` into a folder that
/// is there. Throws Error.
void writeDicomObjects(const std::filesystem::path& folder, const DicomObjects& objects);

} // namespace limn
