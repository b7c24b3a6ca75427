// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace limn {

struct BrickRow;
struct ScaleRow;

/// A page that shows how costs grow with voxels, what bricks do on several ranks, and what follows, with the
/// arithmetic, for 10¹² voxels on up to 10,000 nodes. `command` and `machine` say how the figures were
/// measured; without bricks the last two parts are missing.
std::string scalePage(const std::string& command, const std::string& machine,
                      const std::vector<ScaleRow>& rows, const std::vector<BrickRow>& bricks);

} // namespace limn
