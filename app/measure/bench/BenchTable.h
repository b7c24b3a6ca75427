// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/BenchRow.h"

#include <string>
#include <vector>

namespace limn {

/// Rows as a table for the terminal, with the effects of each scene. Where VTK's GPU mapper, or else the
/// program with all effects, drew the same views, the share of its time that each took: the median over the
/// views.
std::string benchTable(const std::string& machine, const std::vector<BenchRow>& rows);

} // namespace limn
