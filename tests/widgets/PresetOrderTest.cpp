// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetModel.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

Preset presetWith(const char* name, const char* modality, const char* folder = "") {
  Preset preset;
  preset.name = name;
  preset.modality = modality;
  preset.folder = folder;
  return preset;
}

const std::vector<Preset> builtInOnes{presetWith("CT bone", "CT"), presetWith("CT lung", "CT"),
                                      presetWith("MR head", "MR"), presetWith("Surface", "")};
const std::vector<Preset> ownPresets{presetWith("A", "CT", "Spine"), presetWith("B", "MR"),
                                     presetWith("C", "CT", "Heart")};

// "Title: name, name" for each group.
QStringList listed(const PresetStanding& standing) {
  QStringList groups;
  for (const PresetGroup& group : groupedPresets(builtInOnes, ownPresets, standing)) {
    QStringList names;
    for (const ListedPreset& one : group.presets)
      names << QString::fromStdString(one.preset.name);
    groups << group.title + ": " + names.join(", ");
  }
  return groups;
}

TEST(PresetOrder, isByFolderAndModalityWithoutAVolume) {
  EXPECT_EQ(listed({}), (QStringList{"My presets: B", "Heart: C", "Spine: A", "CT: CT bone, CT lung",
                                     "MR: MR head", "Any data: Surface"}));
  EXPECT_EQ(foldersOf(ownPresets), (std::vector<std::string>{"Heart", "Spine"}));
}

TEST(PresetOrder, beginsWithWhatFitsTheVolumeBest) {
  PresetStanding standing;
  standing.fit = {"CT", "CT lung", true};
  EXPECT_EQ(listed(standing).mid(3),
            (QStringList{"CT: CT lung, CT bone", "Any data: Surface", "MR: MR head"}));
  standing.fit = {"MR", "", false};
  EXPECT_EQ(listed(standing).mid(3),
            (QStringList{"MR: MR head", "Any data: Surface", "CT, for Hounsfield units: CT bone, CT lung"}));
}

TEST(PresetOrder, takesTheModalityOfThePresetThatAVolumeOpensWithWhereItsFileHasNone) {
  PresetStanding standing;
  standing.fit = {"", "MR head", false};
  EXPECT_EQ(listed(standing).mid(3),
            (QStringList{"MR: MR head", "Any data: Surface", "CT, for Hounsfield units: CT bone, CT lung"}));
}

TEST(PresetOrder, hasFavouritesFirstAndOnce) {
  PresetStanding standing;
  standing.favourites = {"CT lung", "C", "gone"};
  EXPECT_EQ(listed(standing), (QStringList{"Favourites: C, CT lung", "My presets: B", "Spine: A",
                                           "CT: CT bone", "MR: MR head", "Any data: Surface"}));
}

} // namespace
} // namespace limn
