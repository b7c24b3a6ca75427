// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"
#include "widgets/theme/Theme.h"

#include <QCoreApplication>
#include <QImage>
#include <QString>

#include <optional>
#include <set>
#include <string>
#include <vector>

class QSize;
class QStandardItemModel;

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
  int standing =
      0; ///< how well it suits the volume that is open: 0 its modality, 1 any, 2 another, 3 other units
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

/// A built-in preset's name or note in the window's language (app/translations/PresetWords.cpp); what users
/// have written stays. Presets are known by their English names everywhere but on the screen.
inline QString presetWords(const QString& english) {
  return QCoreApplication::translate("limn::Preset", english.toUtf8().constData());
}

/// What a preset is called whose curve was moved onto the values of the volume that is open.
QString fittedWords(const QString& english);

/// How a preset of the list is used at present.
enum class PresetUse { none, shown, modified };

/// What a preset makes of the volume that is open.
struct PresetPicture {
  QImage image;
  bool showsNothing = false; ///< then there is nothing to see in it
};

/// Roles of the preset list beside Qt::DisplayRole, the preset's name or the group's title.
namespace presetRole {
enum {
  isGroup = Qt::UserRole + 1,
  isOwn,
  note,
  curve,
  picture,
  searchText,
  use,
  showsNothing,
  isFavourite,
  standing,
  isBestHit
};
}

/// Fills `model` with groups of presets, each with a picture of its curve in the colours of a look.
void fillPresetModel(QStandardItemModel& model, const std::vector<PresetGroup>& groups, Look look);

/// Marks the preset of this name, and no other, as used this way; an unknown or empty name marks none.
void markPresetUse(QStandardItemModel& model, const QString& name, PresetUse use);

/// Shows a preset by what it makes of the volume that is open, instead of by its curve; by that still where
/// it shows nothing.
void showPresetPicture(QStandardItemModel& model, const QString& name, const PresetPicture& picture);

/// A small picture of a transfer function: its coloured curve over a strip of its colours.
QImage curveThumbnail(const TransferFunction& function, const QSize& size, double devicePixelRatio,
                      Look look);

/// Of the pictures in the list, logical pixels.
inline constexpr int thumbnailWidth = 56;
inline constexpr int thumbnailHeight = 42;
/// Of the same shape, where the list has room; pictures are made in this size.
inline constexpr int largeThumbnailWidth = 96;
inline constexpr int largeThumbnailHeight = 72;

} // namespace limn
