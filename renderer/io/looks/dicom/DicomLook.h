// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/DicomFolder.h"
#include "io/scenefile/SceneFile.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

/// A Volume Rendering Volumetric Presentation State (PS3.3 A.80.2) as read: what it shows, and of which
/// images.
struct DicomLook {
  std::string study;
  std::vector<DicomReference> images;
  Camera camera;
  double aspect = 1.0;              ///< width over height of the picture
  double nearMm = 0.0, farMm = 0.0; ///< what lies outside these depths is cut away
  TransferFunction transferFunction;
  Shading shading; ///< unlit or classic
  Projection projection = Projection::composite;
  std::optional<double> stepMm;                   ///< of sampling
  std::vector<std::array<glm::dvec3, 2>> cropsMm; ///< opposite corners of boxes along the volume's axes
  std::optional<SceneDocument> own;               ///< the scene as Limn wrote it, where Limn did
  std::vector<Message> changes;                   ///< what is read otherwise than it says, a sentence each
};

/// Whether the bytes begin as a volumetric presentation state of any kind. Never throws.
bool isDicomLook(std::string_view bytes);

/// The same of a file. Never throws.
bool isDicomLookFile(const std::filesystem::path& file);

/// Reads a look. Throws Error (input): damaged, contradictory, or one that Limn cannot draw, said by name.
DicomLook parseDicomLook(std::string_view bytes, const std::string& name);

/// Reads a look from disk. Throws Error (input).
DicomLook readDicomLook(const std::filesystem::path& file);

/// The scene that a look asks for on the grid of its volume, without the volume; what cannot be so is added
/// to `changes`.
SceneDocument sceneOf(const DicomLook& look, const Grid& grid, std::vector<Message>& changes);

/// The series that a look belongs to. Throws Error (input) where none holds its images, or one not all of
/// them; `name` is how the sentence calls the look, `folder` where the series are.
const SeriesImages& seriesOf(const DicomLook& look, const std::vector<SeriesImages>& all,
                             const std::string& name, const std::filesystem::path& folder);

/// Whether one of the series holds all images of a look.
bool belongsToOne(const DicomLook& look, const std::vector<SeriesImages>& all);

} // namespace limn
