// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glsl/decisions/Decisions.h"
#include "scene/Scene.h"

#include <vector>

namespace limn {

/// The entries of a format's table: the function at equal distances over the volume's range, both ends
/// included (HARD_CASES H26 and H27). None for the exact format. `stepMm` is the step for which
/// corrected entries hold their opacity.
std::vector<glm::vec4> tableEntries(const TransferFunction& function, const ValueRange& range,
                                    TableFormat format, double stepMm);

/// The function as a table shows it, linear between entries, to tell where something can be seen; the
/// function itself for the exact format.
TransferFunction tabulated(const TransferFunction& function, const ValueRange& range, TableFormat format);

} // namespace limn
