// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"

#include <QString>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace limn {

/// From what follows where presets stand in their list.
struct PresetStanding {
  std::set<std::string> favourites; ///< by name
  /// Of the volume that is open; none at first.
  struct Fit {
    std::string modality;     ///< empty where it is unknown
    std::string firstLook;    ///< the preset that it opens with; empty: none
    bool isHounsfield = true; ///< whether its values are
    bool operator==(const Fit&) const = default;
  };
  std::optional<Fit> fit;

  bool operator==(const PresetStanding&) const = default;
};

/// A preset of the list, and what its row tells of it.
struct ListedPreset {
  Preset preset;
  bool isOwn = false;
  bool isFavourite = false;
};

/// Presets under one heading.
struct PresetGroup {
  QString title;
  std::vector<ListedPreset> presets;
};

/// The presets as they are listed: favourites, the user's own by folder, then the built-in ones by modality.
/// What fits the open volume best stands first: its modality, and the preset it opens with before the others;
/// what means another unit than it has stands last.
std::vector<PresetGroup> groupedPresets(const std::vector<Preset>& builtIn, const std::vector<Preset>& own,
                                        const PresetStanding& standing);

/// The folders of presets, in alphabetical order.
std::vector<std::string> foldersOf(const std::vector<Preset>& own);

} // namespace limn
