// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/Histogram.h"

#include <algorithm>
#include <cassert>

namespace limn {

Histogram histogramOf(const Volume& volume, int bins) {
  assert(bins > 0);
  Histogram histogram{volume.range(), std::vector<std::uint64_t>(static_cast<std::size_t>(bins), 0)};
  const double width = histogram.range.highest - histogram.range.lowest;
  const double binsPerValue = width > 0.0 ? bins / width : 0.0;
  const Rescale rescale = volume.rescale();
  const std::vector<bool>& invalid = volume.invalidMask();
  visitVoxels(volume, [&](const auto& stored) {
    for (std::size_t i = 0; i < stored.size(); ++i) {
      if (!invalid.empty() && invalid[i])
        continue;
      const double value = rescale.slope * static_cast<double>(stored[i]) + rescale.intercept;
      const int bin = static_cast<int>((value - histogram.range.lowest) * binsPerValue);
      ++histogram.counts[static_cast<std::size_t>(std::clamp(bin, 0, bins - 1))];
    }
  });
  return histogram;
}

} // namespace limn
