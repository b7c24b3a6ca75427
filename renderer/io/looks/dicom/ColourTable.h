// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/volume/Volume.h"

#include <array>
#include <cstdint>
#include <vector>

namespace limn {

/// A transfer function as DICOM keeps it: entries at equal distances of the value, linear between them,
/// constant outside. Red, green, blue, alpha are whole numbers from 0 to `largest`.
struct ColourTable {
  double first = 0.0; ///< the value of the first entry
  double last = 1.0;  ///< that of the last, > first
  int largest = 65535;
  std::vector<std::array<std::uint16_t, 4>> entries; ///< two or more

  double valueOf(std::size_t entry) const {
    return first + (last - first) * static_cast<double>(entry) / static_cast<double>(entries.size() - 1);
  }
};

/// How many entries a table over such a range gets: at least 4096, and where it can be so that whole values
/// fall on entries.
int entriesFor(const ValueRange& range);

/// A function as a table of 16 bits over `range`, lowest < highest; its alpha is the opacity over `stepMm`.
ColourTable tableOf(const TransferFunction& function, const ValueRange& range, double stepMm);

/// The function of a table; its unit distance is `stepMm`. It has few points (found greedily): lines between
/// them miss no entry by more than half a level of the table, or a sixteenth of 255 in a colour, or 0.2 % of
/// an alpha.
TransferFunction functionOf(const ColourTable& table, double stepMm);

} // namespace limn
