// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/nrrd/NrrdHeader.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace limn {

/// The axes of a NRRD file sorted by what they mean, and where they put the volume (LPS, mm).
struct NrrdAxes {
  int components = 1;        ///< length of a colour axis before the spatial axes
  glm::ivec3 dims{1};        ///< the spatial axes
  std::uint64_t volumes = 1; ///< product of the axes after them
  glm::dmat3 stepsMm{1.0};
  glm::dvec3 originMm{0.0};
  bool orientationKnown = true;
  bool spacingKnown = true;
};

/// Sorts and places the axes. Throws Error where they are not those of one scalar or colour volume.
NrrdAxes nrrdAxes(const std::filesystem::path& file, const NrrdHeader& header);

} // namespace limn
