// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/nifti/NiftiHeader.h"
#include "io/formats/voxels/VolumeParts.h"
#include "io/reading/Progress.h"
#include "scene/basics/MemoryBudget.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

/// Where a NIfTI header places its voxels, in LPS and mm.
struct NiftiPlacement {
  glm::dmat3 stepsMm{1.0}; ///< columns: one voxel along each axis
  glm::dvec3 originMm{0.0};
  bool orientationKnown = true;
  bool spacingKnown = true;
  std::vector<Message> warnings;
};

/// Decides the placement from the header alone: a valid sform (code > 0), else the qform (code > 0), else
/// only the spacing. Units become millimetres.
NiftiPlacement placementOf(const NiftiHeader& header);

/// Whether the bytes start as a NIfTI header does, or as one of Analyze, its ancestor, whose refusal says
/// more.
bool isNifti(std::string_view bytes);

/// Reads a NIfTI-1 or NIfTI-2 volume from its header file (.nii, .nii.gz, .hdr, .hdr.gz) or voxel file
/// (.img, .img.gz). Of several volumes the first is read, with a warning.
VolumeParts readNifti(const std::filesystem::path& path, const MemoryBudget& budget,
                      const Progress& progress);

} // namespace limn
