// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/regions/Region.h"

#include <limits>
#include <optional>

namespace limn {

/// Of the label that stands behind those of a segmentation for what is not the body. No file has it.
inline constexpr int tableLabelValue = std::numeric_limits<int>::min();

/// A segmentation and a body together (DEFINITION section 10: they multiply): what is not the body is one
/// label more, the last of its own, and weighs 0. `labels` is of kind labels, `body` of kind body, neither is
/// cut, both are of one grid. `room` is where its voxels lie. Throws Cancelled, and Error (input) where the
/// segmentation leaves no number free.
Region withBody(const Region& labels, const Region& body, const std::shared_ptr<Room>& room = {},
                const Effort& effort = {});

/// The place of that label; nothing of a region that has none.
std::optional<std::size_t> tableLabel(const Region& region);

/// Whether what is not the body is hidden: by a body alone, or beside a segmentation.
bool hidesTable(const Region& region);

/// How many labels of a segmentation a person may edit: its file's.
std::size_t listedLabels(const Region& region);

} // namespace limn
