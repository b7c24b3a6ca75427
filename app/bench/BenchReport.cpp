// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/BenchReport.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

std::string formatted(const char* format, ...) {
  char text[240];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

Json toJson(const BenchRow& row) {
  return {{"program", row.program},
          {"scene", row.scene},
          {"size", {row.size.x, row.size.y}},
          {"step_voxels", row.stepVoxels},
          {"ms", {{"median", row.ms.median}, {"min", row.ms.least}, {"max", row.ms.most}}},
          {"cpu_ms", row.cpuMs},
          {"first_ms", row.firstMs},
          {"edit_ms", row.editMs ? Json(*row.editMs) : Json()},
          {"peak_mb", row.peakMb},
          {"mean_error", Json()}};
}

const BenchRow* yardstickOf(const BenchRow& row, const std::vector<BenchRow>& rows) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&row](const BenchRow& other) {
    return other.program == "vtk-gpu" && other.scene == row.scene && other.size == row.size &&
           other.stepVoxels == row.stepVoxels;
  });
  return found == rows.end() ? nullptr : &*found;
}

} // namespace

std::string benchJson(const std::string& machine, const std::vector<BenchRow>& rows) {
  Json list = Json::array();
  for (const BenchRow& row : rows)
    list.push_back(toJson(row));
  return Json{{"machine", machine}, {"rows", list}}.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::string benchTable(const std::string& machine, const std::vector<BenchRow>& rows) {
  std::string table = machine + "\n";
  std::size_t width = 5;
  for (const BenchRow& row : rows)
    width = std::max(width, row.scene.size());
  const int w = static_cast<int>(width);
  table +=
      formatted("%-*s %9s %6s %-14s %8s %19s %8s %8s %8s %7s  %s\n", w, "scene", "size", "step", "program",
                "ms", "least .. most", "cpu ms", "first", "edit", "MB", "of vtk-gpu: ms, cpu ms");
  for (const BenchRow& row : rows) {
    table +=
        formatted("%-*s %9s %6.3g %-14s %8.1f %19s %8.1f %8.1f %8s %7.1f", w, row.scene.c_str(),
                  formatted("%dx%d", row.size.x, row.size.y).c_str(), row.stepVoxels, row.program.c_str(),
                  row.ms.median, formatted("%.1f .. %.1f", row.ms.least, row.ms.most).c_str(), row.cpuMs,
                  row.firstMs, row.editMs ? formatted("%.1f", *row.editMs).c_str() : "-", row.peakMb);
    if (const BenchRow* yardstick = yardstickOf(row, rows))
      table += formatted("  %.3f, %.3f", row.ms.median / yardstick->ms.median, row.cpuMs / yardstick->cpuMs);
    table += "\n";
  }
  return table;
}

} // namespace limn
