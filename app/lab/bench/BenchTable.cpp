// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/bench/Bench.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace limn {
namespace {

std::string formatted(const char* format, ...) {
  char text[240];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

// What a row's times are compared with, if it was drawn.
std::vector<const BenchRow*> yardsticksOf(const BenchRow& row, const std::vector<BenchRow>& rows) {
  std::vector<const BenchRow*> yardsticks;
  for (const char* program : {"vtk-gpu", "vtk-fixedpoint", "limn-gl-all"})
    for (const BenchRow& other : rows)
      if (other.program == program && other.missing.empty() && other.scene == row.scene &&
          other.size == row.size && other.stepVoxels == row.stepVoxels && &other != &row)
        yardsticks.push_back(&other);
  return yardsticks;
}

// The median over the views of the quotient of two rows.
double shareOf(const std::vector<double>& times, const std::vector<double>& yardstick) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < times.size(); ++i)
    shares.push_back(times[i] / yardstick[i]);
  return timingOf(shares).median;
}

std::string lineOf(const BenchRow& row, const std::vector<BenchRow>& rows, int sceneWidth) {
  std::string line =
      formatted("%-*s %9s %6.3g %-14s", sceneWidth, row.scene.c_str(),
                formatted("%dx%d", row.size.x, row.size.y).c_str(), row.stepVoxels, row.program.c_str());
  if (!row.missing.empty())
    return line + " no figures: " + row.missing + "\n";
  const Timing ms = timingOf(wallTimes(row.views));
  line += formatted(" %8.1f %19s %8.1f %8.1f %8s %7.1f %6.2f", ms.median,
                    formatted("%.1f .. %.1f", ms.least, ms.most).c_str(),
                    timingOf(processorTimes(row.views)).median, row.firstMs,
                    row.editMs ? formatted("%.1f", *row.editMs).c_str() : "-", row.peakMb, row.meanError);
  const char* separator = "  ";
  for (const BenchRow* yardstick : yardsticksOf(row, rows)) {
    line += formatted(
        "%s%.3f, %.3f of %s", separator, shareOf(wallTimes(row.views), wallTimes(yardstick->views)),
        shareOf(processorTimes(row.views), processorTimes(yardstick->views)), yardstick->program.c_str());
    separator = "; ";
  }
  return line + "\n";
}

} // namespace

std::string benchTable(const std::string& machine, const std::vector<BenchRow>& rows) {
  std::size_t width = 5;
  for (const BenchRow& row : rows)
    width = std::max(width, row.scene.size());
  const int sceneWidth = static_cast<int>(width);
  std::string table = machine + "\n";
  table += formatted("%-*s %9s %6s %-14s %8s %19s %8s %8s %8s %7s %6s  %s\n", sceneWidth, "scene", "size",
                     "step", "program", "ms", "least .. most", "cpu ms", "first", "edit", "MB", "error",
                     "share of ms, cpu ms");
  for (const BenchRow& row : rows)
    table += lineOf(row, rows, sceneWidth);
  table += "\n";
  for (const BenchRow& row : rows)
    if (!row.effects.empty())
      table += row.scene + ", " + row.program + ": " + row.effects + "\n";
  return table;
}

std::string equalErrorTable(const std::vector<EqualErrorRow>& rows) {
  std::size_t width = 5;
  for (const EqualErrorRow& row : rows)
    width = std::max(width, row.scene.size());
  const int sceneWidth = static_cast<int>(width);
  std::string table = formatted("%-*s %6s %-14s %8s  %s\n", sceneWidth, "scene", "error", "program", "cpu ms",
                                "times as fast at equal error");
  for (const EqualErrorRow& row : rows)
    table += formatted("%-*s %6.2f %-14s %8s  %s\n", sceneWidth, row.scene.c_str(), row.meanError,
                       row.program.c_str(), row.cpuMs ? formatted("%.1f", *row.cpuMs).c_str() : "never",
                       row.gain ? formatted("%.1f as %s", *row.gain, row.yardstick.c_str()).c_str() : "-");
  return table;
}

} // namespace limn
