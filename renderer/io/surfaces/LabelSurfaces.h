// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/surfaces/SurfaceExport.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limn {

/// A label whose surface is wanted, and its file.
struct LabelSurface {
  std::size_t place = 0; ///< in the list of labels
  std::string name;
  std::filesystem::path file;
};

/// A file beside `path` for each label of a region that voxels have, but for the background:
/// "organs_liver.stl" for "organs.stl" and the label "liver". What file names cannot hold becomes "_"; of two
/// of one name the second has the label's value behind it.
std::vector<LabelSurface> labelSurfaces(const Region& region, const std::filesystem::path& path);

/// The scene of which makeSurface makes the surface of a label: its volume is 1 in the label's voxels and 0
/// in others, around them alone, so that at the isovalue 0.5 lies where the label's weight is ½ (DEFINITION
/// section 10). `grid` is the labels'.
Scene sceneOfLabel(const Region& labels, std::size_t place, const Grid& grid);

/// Makes the surface of each of them and writes it; one file after the other, so that those before stay where
/// one fails. The isovalue of the order does not matter. Throws as exportSurfaces.
std::vector<WrittenSurface> exportLabelSurfaces(const Region& labels, const Grid& grid,
                                                const std::vector<LabelSurface>& surfaces, SurfaceOrder order,
                                                const Progress& progress = {});

} // namespace limn
