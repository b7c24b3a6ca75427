// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/FunctionTable.h"

#include "scene/basics/StableMath.h"

#include <cmath>

namespace limn {
namespace {

int entryCount(TableFormat format) {
  switch (format) {
  case TableFormat::exact:
    return 0;
  case TableFormat::floats1024:
    return 1024;
  case TableFormat::floats256:
  case TableFormat::bytes256:
  case TableFormat::correctedFloats:
    return 256;
  }
  return 0;
}

double valueOf(int entry, int count, const ValueRange& range) {
  return std::lerp(range.lowest, range.highest, static_cast<double>(entry) / (count - 1));
}

glm::vec4 inBytes(const glm::vec4& entry) {
  return glm::floor(entry * 255.0f + 0.5f) / 255.0f;
}

} // namespace

std::vector<glm::vec4> tableEntries(const TransferFunction& function, const ValueRange& range,
                                    TableFormat format, double stepMm) {
  const int count = entryCount(format);
  std::vector<glm::vec4> entries;
  entries.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Classified at = classify(function, valueOf(i, count, range));
    double opacity = at.opacity;
    if (format == TableFormat::correctedFloats)
      opacity = oneMinusExpNeg(extinctionPerMm(opacity, function.unitDistanceMm) * stepMm);
    const glm::vec4 entry(glm::dvec4(at.color, opacity));
    entries.push_back(format == TableFormat::bytes256 ? inBytes(entry) : entry);
  }
  return entries;
}

TransferFunction tabulated(const TransferFunction& function, const ValueRange& range, TableFormat format) {
  if (format == TableFormat::exact || !(range.highest > range.lowest))
    return function;
  // A corrected opacity is 0 where the opacity is.
  const TableFormat shown = format == TableFormat::correctedFloats ? TableFormat::floats256 : format;
  const std::vector<glm::vec4> entries = tableEntries(function, range, shown, 0.0);
  TransferFunction table{function.unitDistanceMm, {}};
  for (std::size_t i = 0; i < entries.size(); ++i)
    table.points.push_back({valueOf(static_cast<int>(i), static_cast<int>(entries.size()), range),
                            glm::dvec3(entries[i]), entries[i].a});
  return table;
}

} // namespace limn
