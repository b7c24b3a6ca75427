// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/ReportJson.h"

#include "accuracy/times/BenchRow.h"
#include "io/json/JsonText.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const BenchRow& row) {
  const Timing ms = timingOf(wallTimes(row.views));
  return {{"program", row.program},
          {"scene", row.scene},
          {"size", {row.size.x, row.size.y}},
          {"step_voxels", row.stepVoxels},
          {"ms", {{"median", ms.median}, {"min", ms.least}, {"max", ms.most}}},
          {"cpu_ms", timingOf(processorTimes(row.views)).median},
          {"first_ms", row.firstMs},
          {"edit_ms", row.editMs ? Json(*row.editMs) : Json()},
          {"peak_mb", row.peakMb},
          {"mean_error", Json()}};
}

} // namespace

std::string benchJson(const std::string& machine, const std::vector<BenchRow>& rows) {
  Json list = Json::array();
  for (const BenchRow& row : rows)
    list.push_back(toJson(row));
  return textOf({{"machine", machine}, {"rows", list}});
}

} // namespace limn
