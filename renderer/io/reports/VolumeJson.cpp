// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/ReportJson.h"

#include "io/json/JsonText.h"
#include "scene/volume/Volume.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const glm::dvec3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json toJson(const SeriesSummary& series) {
  return {{"number", series.number},
          {"description", series.description},
          {"modality", series.modality},
          {"dims", {series.dims.x, series.dims.y, series.dims.z}}};
}

} // namespace

std::string volumeJson(const VolumeFacts& facts) {
  const Volume& volume = *facts.volume;
  const Grid& grid = volume.grid();
  Json direction = Json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      direction.push_back(grid.direction[column][row]);
  Json series = Json::array();
  for (const SeriesSummary& one : facts.series)
    series.push_back(toJson(one));
  return textOf({{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
                 {"spacing_mm", toJson(grid.spacingMm)},
                 {"origin_mm", toJson(grid.originMm)},
                 {"direction", direction},
                 {"type", voxelTypeName(volume.stored())},
                 {"range", {volume.range().lowest, volume.range().highest}},
                 {"invalid_voxels", volume.invalidVoxels()},
                 {"gradient", {{"max", facts.gradientMax}, {"p99_5", facts.gradientPercentile}}},
                 {"series", series},
                 {"warnings", volume.info().warnings}});
}

} // namespace limn
