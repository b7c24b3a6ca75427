// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/PresetStore.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <set>

#include <fstream>

namespace limn {
namespace {

Preset named(const std::string& name) {
  Preset preset = builtInPresets().front();
  preset.name = name;
  return preset;
}

TEST(BuiltInPresets, areTwentyAtLeastAndEachCanBeReadAndHasANameOfItsOwn) {
  const std::vector<Preset> presets = builtInPresets();
  ASSERT_GE(presets.size(), 20u);
  std::set<std::string> names;
  for (const Preset& preset : presets) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_EQ(isForHounsfield(preset), preset.modality == "CT") << preset.name;
    EXPECT_FALSE(preset.note.empty()) << preset.name;
    EXPECT_LE(preset.note.substr(0, preset.note.find(';')).size(), 34u) << "two lines: " << preset.name;
    EXPECT_GE(preset.transferFunction.points.size(), 3u) << preset.name;
    EXPECT_EQ(preset.transferFunction.points.front().opacity, 0.0) << preset.name;
  }
}

// What faces light and viewer has the ambient and the diffuse part in full: together no more than its colour.
TEST(BuiltInPresets, lightColoursWithoutClippingThem) {
  for (const Preset& preset : builtInPresets()) {
    const Shading shading = preset.shading.value_or(Shading{});
    EXPECT_LE(shading.ambient * shading.ambientIntensity + shading.diffuse * shading.lightIntensity,
              1.0 + 1e-12)
        << preset.name;
  }
}

// The paper's numbers are there to compare in one preset; in all others that are lit they gave way to better
// ones.
TEST(BuiltInPresets, haveNumbersOfTheEnhancedModelOfTheirOwn) {
  for (const Preset& preset : builtInPresets()) {
    const Projection projection = preset.projection.value_or(Projection::composite);
    if (projection == Projection::mip || projection == Projection::xray)
      continue;
    ASSERT_TRUE(preset.shading) << preset.name;
    const Shading literal;
    const bool isLiteral = preset.shading->exponentRange == literal.exponentRange &&
                           preset.shading->opacityRange == literal.opacityRange &&
                           preset.shading->gradientReference == literal.gradientReference &&
                           preset.shading->gradientCurve == literal.gradientCurve;
    EXPECT_EQ(isLiteral, preset.name == "CT skin and bone") << preset.name;
  }
}

// As the window's list calls them below their modality.
TEST(BuiltInPresets, areFoundWithoutTheirModalityWhereOneAloneIsCalledSo) {
  const std::vector<Preset> presets = builtInPresets();
  EXPECT_EQ(presetNamed(presets, "bone").name, "CT bone");
  EXPECT_EQ(presetNamed(presets, "Glass").name, "MR glass");
  EXPECT_THROW(presetNamed(presets, "maximum (MIP)"), Error) << "of CT or of MR";
}

// Nothing that is opaque becomes less so between boundaries.
TEST(BuiltInPresets, skinIsClosedInBothModels) {
  const std::vector<Preset> presets = builtInPresets();
  EXPECT_GE(presetNamed(presets, "CT skin").shading->opacityRange.atFlat, 1.0);
}

// A curve over the value cannot tell a brain from the skin and muscle around it: over the heads of CT and MR
// the one that shows a brain shows the scalp, and its name says what it is for.
TEST(BuiltInPresets, nonePromisesABrainButWhereItWasStripped) {
  const std::vector<Preset> presets = builtInPresets();
  const auto says = [](const Preset& preset, const char* word) {
    return preset.name.find(word) != std::string::npos;
  };
  for (const Preset& preset : presets)
    EXPECT_TRUE(says(preset, "stripped") || !(says(preset, "brain") || says(preset, "Brain"))) << preset.name;
  const std::string note = presetNamed(presets, "MR skull-stripped brain").note;
  EXPECT_TRUE(note.starts_with("Of a whole head it shows the scalp;")) << note << ": rows cut what follows";
}

TEST(BuiltInPresets, holdEveryFirstLook) {
  std::set<std::string> names;
  for (const Preset& preset : builtInPresets())
    names.insert(preset.name);
  for (const char* look :
       {"CT bone and veil", "CT chest", "CT angiography", "Vessels", "MR head", "MR T2 head", "MR PD head",
        "MR skull-stripped brain", "PET hot spots", "Ultrasound surface"})
    EXPECT_TRUE(names.contains(look)) << look;
}

TEST(PresetStore, keepsPresetsUnderAnyName) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path() / "presets");
  for (const char* name : {"Bone", "bone/../../x", "Kopf · MR", "a%2fb"})
    store.save(named(name));
  const PresetStore::Contents contents = store.read();
  ASSERT_EQ(contents.presets.size(), 4u);
  EXPECT_TRUE(contents.problems.empty());
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    EXPECT_TRUE(entry.path() == folder.path() / "presets" ||
                entry.path().parent_path() == folder.path() / "presets");
}

// A user's file system: what is in it may have been copied, renamed and edited by hand.
TEST(PresetStore, filesThatAreNamedByHandAreFoundReplacedAndRemoved) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save(named("Mine"));
  std::filesystem::rename(folder.path() / "Mine.json", folder.path() / "for anna.json");
  ASSERT_TRUE(store.find("Mine"));
  EXPECT_EQ(store.find("Mine"), named("Mine"));
  Preset changed = named("Mine");
  changed.note = "changed";
  store.save(changed);
  EXPECT_EQ(store.read().presets, std::vector{changed}) << "not twice";
  std::filesystem::rename(folder.path() / "Mine.json", folder.path() / "for anna.json");
  store.remove("Mine");
  EXPECT_TRUE(store.read().presets.empty());
  EXPECT_FALSE(store.find("Mine"));
}

TEST(PresetStore, aNameThatIsTakenOrAFileThatIsBrokenIsSaidAndLeftOut) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save(named("Mine"));
  std::filesystem::copy_file(folder.path() / "Mine.json", folder.path() / "copy.json");
  store.save(named("CT bone")); // a built-in one
  std::ofstream(folder.path() / "broken.json") << "{\"limn_preset\": 1, \"name\": ";
  const PresetStore::Contents contents = store.read();
  ASSERT_EQ(contents.presets.size(), 1u);
  EXPECT_EQ(contents.presets.front().name, "Mine");
  ASSERT_EQ(contents.problems.size(), 3u);
  const char* const files[] = {"CT bone.json", "broken.json", "copy.json"};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NE(contents.problems[i].english().find(files[i]), std::string::npos)
        << contents.problems[i].english();
}

TEST(PresetStore, keepsNoteAndFolder) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path());
  Preset preset = named("Mine");
  preset.note = "for the \"petrous\" bone";
  preset.folder = "Schläfe";
  store.save(preset);
  EXPECT_EQ(store.read().presets, std::vector{preset});
}

// A byte beside letters and digits takes three in the file's name: 83 of them and ".json" are 254.
TEST(PresetStore, aNameThatIsTooLongIsSaid) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save(named(std::string(83, '.')));
  try {
    store.save(named(std::string(84, '.')));
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("too long"), std::string::npos) << error.what();
  }
  EXPECT_EQ(store.read().presets.size(), 1u);
}

TEST(PresetStore, aHalfWrittenFileIsNoPreset) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save(named("Good"));
  std::ofstream(folder.path() / ".limn-123.json") << "{\"limn_preset\": 1, ";
  const PresetStore::Contents contents = store.read();
  EXPECT_EQ(contents.presets.size(), 1u);
  EXPECT_TRUE(contents.problems.empty());
}

TEST(PresetStore, replacesAPresetOfTheSameNameAndRemovesIt) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path());
  Preset preset = named("Mine");
  store.save(preset);
  preset.note = "changed";
  store.save(preset);
  ASSERT_EQ(store.read().presets.size(), 1u);
  EXPECT_EQ(store.read().presets.front().note, "changed");
  store.remove("Mine");
  EXPECT_TRUE(store.read().presets.empty());
}

TEST(PresetStore, namesAFileItCannotReadAndReadsTheOthers) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save(named("Good"));
  std::ofstream(folder.path() / "bad.json") << "{\"limn_preset\": 1, ";
  const PresetStore::Contents contents = store.read();
  EXPECT_EQ(contents.presets.size(), 1u);
  ASSERT_EQ(contents.problems.size(), 1u);
  EXPECT_NE(contents.problems.front().english().find("bad.json"), std::string::npos);
}

} // namespace
} // namespace limn
