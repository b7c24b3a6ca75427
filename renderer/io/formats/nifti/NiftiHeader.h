// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

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

} // namespace limn
