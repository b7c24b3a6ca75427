// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

class QWidget;

namespace limn {

class ActionList;

/// What one gesture or key does, in the words of the window's language.
struct HelpRow {
  QString gesture; ///< empty: `effect` is a heading
  QString effect;
};

/// Every gesture and key, by where it is made.
struct HelpRows {
  QList<HelpRow> picture;
  QList<HelpRow> slices;
  QList<HelpRow> curve;
  QList<HelpRow> menus; ///< as the menus have them, so that both always say the same
};

/// Those of the menus are read from the actions, shortcuts as they are set.
HelpRows helpRows(const ActionList& actions);

/// Lists what mouse and keys do, and the keys of the menus' actions, in a box that blocks nothing.
void showShortcuts(const ActionList& actions, QWidget* parent);

} // namespace limn
