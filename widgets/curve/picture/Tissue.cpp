// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/picture/Tissue.h"

#include <QCoreApplication>

#include <array>

namespace limn {
namespace {

struct Row {
  ValueRange range;
  const char* name;
};

// Half-open intervals [lowest, highest) in HU.
constexpr std::array<Row, 9> tissueRows{
    {{{-1e6, -950.0}, QT_TRANSLATE_NOOP("Tissue", "air")},
     {{-950.0, -500.0}, QT_TRANSLATE_NOOP("Tissue", "lung")},
     {{-150.0, -30.0}, QT_TRANSLATE_NOOP("Tissue", "fat")},
     {{-10.0, 15.0}, QT_TRANSLATE_NOOP("Tissue", "water")},
     {{15.0, 90.0}, QT_TRANSLATE_NOOP("Tissue", "soft tissue, blood")},
     {{100.0, 300.0}, QT_TRANSLATE_NOOP("Tissue", "contrast agent, spongy bone")},
     {{300.0, 700.0}, QT_TRANSLATE_NOOP("Tissue", "bone, dense contrast agent")},
     {{700.0, 2200.0}, QT_TRANSLATE_NOOP("Tissue", "compact bone, dentine")},
     {{2200.0, 1e6}, QT_TRANSLATE_NOOP("Tissue", "enamel, metal")}}};

} // namespace

std::optional<Tissue> tissueAt(double hounsfield) {
  for (const Row& row : tissueRows)
    if (hounsfield >= row.range.lowest && hounsfield < row.range.highest)
      return Tissue{QCoreApplication::translate("Tissue", row.name), row.range};
  return std::nullopt;
}

std::vector<Tissue> allTissues() {
  std::vector<Tissue> tissues;
  for (const Row& row : tissueRows)
    tissues.push_back({QCoreApplication::translate("Tissue", row.name), row.range});
  return tissues;
}

} // namespace limn
