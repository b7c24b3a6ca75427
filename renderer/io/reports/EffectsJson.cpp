// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/ReportJson.h"

#include "io/json/JsonText.h"
#include "scene/effects/EffectRows.h"

#include <nlohmann/json.hpp>

namespace limn {

std::string effectsJson(const std::string& renderer, const std::vector<EffectRow>& rows,
                        const std::vector<double>& costsMs) {
  nlohmann::ordered_json effects = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < rows.size(); ++i)
    effects.push_back(
        {{"name", rows[i].name}, {"on", rows[i].isOn}, {"reason", rows[i].reason}, {"cost_ms", costsMs[i]}});
  return textOf({{"renderer", renderer}, {"effects", effects}});
}

} // namespace limn
