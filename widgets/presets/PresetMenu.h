// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <string>
#include <vector>

class QMenu;
class QWidget;

namespace limn {

/// A preset that a menu is about.
struct PresetInHand {
  QString name;
  bool isOwn = false;
  bool isFavourite = false;
  bool isModified = false; ///< it is shown, changed
  std::string folder;      ///< it lies in, of an own one
  std::vector<std::string> allFolders;
};

/// What can be done with it. Those of own presets are offered for these alone.
struct PresetDeeds {
  std::function<void()> use, compare, toggleFavourite, duplicate, exportIt;
  std::function<void()> rename, editNote, remove, moveToNewFolder;
  std::function<void(const QString& folder)> moveTo; ///< empty: in none
};

/// A menu of a preset, a child of `parent`; the caller opens it.
QMenu* makePresetMenu(const PresetInHand& preset, const PresetDeeds& deeds, QWidget* parent);

} // namespace limn
