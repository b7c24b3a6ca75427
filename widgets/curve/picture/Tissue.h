// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <QString>

#include <optional>
#include <vector>

namespace limn {

/// What a CT number usually is, and the range that shares the name.
struct Tissue {
  QString name;
  ValueRange range; ///< HU; open ends reach ±1e6
};

/// The usual tissue of a CT number in HU, or nothing between the ranges, where only mixtures lie. Ranges
/// overlap in patients; these follow the tables of Buzug, "Computed Tomography" (Springer 2008), p. 475, and
/// Prokop and Galanski, "Spiral and Multislice Computed Tomography of the Body" (Thieme 2003), with the gaps
/// left open.
std::optional<Tissue> tissueAt(double hounsfield);

/// All of them, the lowest values first.
std::vector<Tissue> allTissues();

} // namespace limn
