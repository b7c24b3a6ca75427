// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace limn {

/// How high a histogram stands: by the count itself, by its logarithm, or by how many of all voxels lie at or
/// below a value.
enum class HistogramScale { linear, logarithmic, percentile };

/// Of which voxels: all, those that neither crop nor kept region hides, or of these the ones to whose value
/// the curve gives opacity.
enum class HistogramPart { whole, kept, visible };

/// What somebody chose to see behind the curve.
struct HistogramView {
  HistogramScale scale = HistogramScale::logarithmic;
  HistogramPart part = HistogramPart::whole;
  bool operator==(const HistogramView&) const = default;
};

/// The words for them in settings and object names.
inline const char* nameOf(HistogramScale scale) {
  constexpr std::array names{"linear", "logarithmic", "percentile"};
  return names[static_cast<std::size_t>(scale)];
}
inline const char* nameOf(HistogramPart part) {
  constexpr std::array names{"whole", "kept", "visible"};
  return names[static_cast<std::size_t>(part)];
}

} // namespace limn
