// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/rays/PictureTerms.h"

namespace limn::cpu {

FewSegments fewSegments(const PiecewiseTable& table) {
  FewSegments few;
  if (table.segmentCount > FewSegments::most)
    return few;
  few.count = table.segmentCount;
  for (int i = 0; i < few.count; ++i) {
    const glm::vec4* texels = &table.segments[4 * static_cast<std::size_t>(i)];
    few.starts[i] = texels[2].x;
    few.ends[i] = texels[2].y;
    for (int channel = 0; channel < 4; ++channel) {
      few.values[channel][i] = texels[0][channel];
      few.slopes[channel][i] = texels[1][channel];
    }
  }
  return few;
}

} // namespace limn::cpu
