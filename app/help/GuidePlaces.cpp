// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help/GuidePlaces.h"

#include <QWidget>

namespace limn {
namespace {

struct PanelPlace {
  const char* panel; ///< its object name, or its class
  const char* place;
};

constexpr PanelPlace panelPlaces[] = {
    {"presetDock", "panels.presets"},          {"historyDock", "panels.history"},
    {"shadingDock", "panels.properties"},      {"effectsDock", "panels.effects"},
    {"accuracyDock", "panels.accuracy"},       {"rayDock", "panels.ray"},
    {"curveDock", "panels.transfer-function"}, {"limn::EmptyPanel", "start"},
    {"limn::CompareView", "panels.picture"},   {"limn::PlaneDeck", "panels.slices"},
};

} // namespace

QString guidePlaceOf(const QWidget* focused) {
  for (const QWidget* part = focused; part; part = part->parentWidget())
    for (const PanelPlace& one : panelPlaces)
      if (part->objectName() == QLatin1String(one.panel) || part->inherits(one.panel))
        return QLatin1String(one.place);
  return QStringLiteral("start");
}

} // namespace limn
