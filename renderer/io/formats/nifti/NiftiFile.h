// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "scene/basics/MemoryBudget.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

/// Bytes that hold either version's header.
inline constexpr std::size_t niftiHeaderBytes = 540;

/// The fields of a NIfTI-1 or NIfTI-2 header that place and decode its voxels, as stored (RAS, file units).
/// Source: nifti1.h and nifti2.h of the NIfTI Data Format Working Group.
struct NiftiHeader {
  int version = 1;
  bool bigEndian = false;
  bool singleFile = true; ///< voxels in this file, else in an .img file
  std::array<double, 8> dim{};
  std::array<double, 8> pixdim{};
  int bitsPerVoxel = 0; ///< 0 where the writer left it out
  int datatype = 0;
  double voxelOffset = 0.0;
  double slope = 0.0;
  double intercept = 0.0;
  int units = 0;
  int qformCode = 0;
  int sformCode = 0;
  glm::dvec3 quaternion{0.0}; ///< b, c, d
  glm::dvec3 quaternionOffset{0.0};
  std::array<glm::dvec4, 3> sformRows{};
};

/// Reads a header of either version and byte order; nothing where the bytes are no NIfTI header.
std::optional<NiftiHeader> parseNiftiHeader(std::string_view bytes);

/// Whether the bytes are an Analyze 7.5 header: NIfTI-1's size without its magic word.
bool isAnalyzeHeader(std::string_view bytes);

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
