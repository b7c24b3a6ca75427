// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/SeriesSummary.h"
#include "scene/Volume.h"

#include <memory>
#include <string>
#include <vector>

namespace limn {

/// What is told of a volume.
struct VolumeFacts {
  std::shared_ptr<const Volume> volume;
  std::vector<SeriesSummary> series;
  double gradientMax = 0.0;        ///< value/mm
  double gradientPercentile = 0.0; ///< the 99.5th, value/mm
};

/// One JSON object, keys as the command line documents them; nothing of the patient.
std::string volumeJson(const VolumeFacts& facts);

} // namespace limn
