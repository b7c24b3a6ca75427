// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/bench/ScaleBench.h"

#include <cstdio>

namespace limn {
namespace {

// The row of the same renderer and half the edge, if it has figures.
const ScaleRow* halfOf(const ScaleRow& row, const std::vector<ScaleRow>& rows) {
  for (const ScaleRow& other : rows)
    if (other.drawn.program == row.drawn.program && 2 * other.edge == row.edge && other.drawn.missing.empty())
      return &other;
  return nullptr;
}

double cpuMsOf(const ScaleRow& row) {
  return timingOf(processorTimes(row.drawn.views)).median;
}

// A figure, and by how much it grew.
template <class Figure>
std::string cell(const ScaleRow& row, const ScaleRow* half, Figure&& figureOf) {
  char text[48];
  const double figure = figureOf(row);
  const double before = half ? figureOf(*half) : 0.0;
  if (before > 0.0)
    std::snprintf(text, sizeof text, " %9.1f (%4.1f)", figure, figure / before);
  else
    std::snprintf(text, sizeof text, " %9.1f       ", figure);
  return text;
}

std::string lineOf(const ScaleRow& row, const std::vector<ScaleRow>& rows) {
  char text[64];
  std::snprintf(text, sizeof text, "%5d %8.1f %-14s", row.edge, row.voxelsMb, row.drawn.program.c_str());
  if (!row.drawn.missing.empty())
    return std::string(text) + " no figures: " + row.drawn.missing + "\n";
  const ScaleRow* half = halfOf(row, rows);
  const auto add = [&](const auto& figureOf) { return cell(row, half, figureOf); };
  return text + add([](const ScaleRow& one) { return one.opened.cpuMs; }) +
         add([](const ScaleRow& one) { return one.openedMb; }) +
         add([](const ScaleRow& one) { return one.drawn.firstCpuMs; }) + add(cpuMsOf) +
         add([](const ScaleRow& one) { return one.drawn.editMs.value_or(0.0); }) +
         add([](const ScaleRow& one) { return one.drawn.peakMb; }) + "\n";
}

} // namespace

std::string brickTable(const std::vector<BrickRow>& rows) {
  char line[160];
  std::snprintf(line, sizeof line, "%5s %6s %14s %18s %12s %12s %14s %10s\n", "edge", "ranks", "10^6 samples",
                "busiest over mean", "all, cpu ms", "slowest", "kept each, MB", "sent, MB");
  std::string table = std::string("\n") + line;
  for (const BrickRow& row : rows) {
    std::snprintf(line, sizeof line, "%5d %6d %14.1f %18.2f %12.1f %12.1f %14.1f %10.1f\n", row.edge,
                  row.bricks, row.samples / 1e6, imbalanceOf(row), row.cpuMs, row.mostCpuMs, row.mostKeptMb,
                  row.reducedMb);
    table += line;
  }
  return table + "Work and bytes are counted: bricks were drawn one after the other.\n";
}

std::string scaleTable(const std::string& machine, const std::vector<ScaleRow>& rows) {
  char head[200];
  std::snprintf(head, sizeof head, "%5s %8s %-14s %16s %16s %16s %16s %16s %16s\n", "edge", "MB", "program",
                "open, cpu ms", "open, MB", "first, cpu ms", "frame, cpu ms", "edit, ms", "drawing, MB");
  std::string table = machine + "\n" + head;
  for (const ScaleRow& row : rows)
    table += lineOf(row, rows);
  return table + "In brackets: how many times the figure of half the edge, an eighth of the voxels.\n";
}

} // namespace limn
