// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Settings.h"

#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

struct Settled : testing::Test {
  std::filesystem::path file() const { return folder.path() / "config" / "settings.json"; }
  test::TemporaryFolder folder;
};

QStringList pathsOf(Settings& settings) {
  QStringList paths;
  for (const RecentSource& source : settings.recentSources())
    paths << source.path;
  return paths;
}

TEST_F(Settled, whatIsSetIsThereAtTheNextStart) {
  {
    Settings settings(file());
    EXPECT_EQ(settings.theme(), "system");
    EXPECT_TRUE(settings.refinesAtRest());
    EXPECT_FALSE(settings.patientIsShown().has_value()) << "nobody was asked";
    settings.setTheme("dark");
    settings.setRefinesAtRest(false);
    settings.setPatientIsShown(false);
    settings.setMovingMs(16.5);
    EXPECT_EQ(settings.histogramView(), HistogramView{});
    settings.setHistogramView({HistogramScale::percentile, HistogramPart::visible});
    EXPECT_FALSE(settings.presetsAreGallery());
    settings.setPresetsAreGallery(true);
    EXPECT_TRUE(settings.lookEnding().isEmpty());
    settings.setLookEnding(".itf");
    settings.setWindow(QByteArray("\0\xff", 2), "state");
  }
  const Settings settings(file());
  EXPECT_EQ(settings.theme(), "dark");
  EXPECT_FALSE(settings.refinesAtRest());
  EXPECT_EQ(settings.patientIsShown(), false);
  EXPECT_EQ(settings.movingMs(), 16.5);
  EXPECT_EQ(settings.lookEnding(), ".itf");
  EXPECT_EQ(settings.histogramView(), (HistogramView{HistogramScale::percentile, HistogramPart::visible}));
  EXPECT_TRUE(settings.presetsAreGallery());
  EXPECT_EQ(settings.windowGeometry(), QByteArray("\0\xff", 2));
  EXPECT_EQ(settings.windowState(), "state");
}

TEST_F(Settled, favouritesAreThoseOfEveryWindow) {
  Settings one(file());
  Settings other(file());
  one.setFavourite("CT bone", true);
  other.setFavourite("Kopf · \"MR\"/2", true);
  EXPECT_EQ(one.favourites(), (std::set<std::string>{"CT bone", "Kopf · \"MR\"/2"}));
  other.setFavourite("CT bone", false);
  EXPECT_EQ(one.favourites(), std::set<std::string>{"Kopf · \"MR\"/2"});
}

TEST_F(Settled, twoWindowsLoseNothingOfEachOther) {
  Settings one(file());
  Settings other(file());
  one.setTheme("dark");
  other.setMovingMs(100);
  one.addRecentSource("/a", "A");
  other.addRecentSource("/b", "B");
  one.addRecentSource("/c", "C");
  EXPECT_EQ(pathsOf(other), QStringList({"/c", "/b", "/a"}));
  Settings later(file());
  EXPECT_EQ(later.theme(), "dark");
  EXPECT_EQ(later.movingMs(), 100);
  // Of one item the last writer wins.
  other.setTheme("light");
  EXPECT_EQ(Settings(file()).theme(), "light");
}

TEST_F(Settled, theTenLastOpenedAreRemembered) {
  Settings settings(file());
  for (int i = 0; i < 12; ++i)
    settings.addRecentSource("/" + QString::number(i), "label");
  settings.addRecentSource("/5", "again");
  const QList<RecentSource> recent = settings.recentSources();
  ASSERT_EQ(recent.size(), 10);
  EXPECT_EQ(recent.front().path, "/5");
  EXPECT_EQ(recent.front().label, "again");
  EXPECT_EQ(pathsOf(settings).count("/5"), 1);
  EXPECT_FALSE(pathsOf(settings).contains("/1"));
  EXPECT_EQ(recent.front().series, 0);
  settings.addRecentSource("/5", "again", 2);
  EXPECT_EQ(settings.recentSources().front().series, 2);
  settings.addRecentSource("/5", "again");
  EXPECT_EQ(settings.recentSources().front().series, 0) << "none was chosen this time";
  settings.removeRecentSource("/5");
  EXPECT_FALSE(pathsOf(settings).contains("/5"));
  settings.clearRecentSources();
  EXPECT_TRUE(pathsOf(settings).isEmpty());
  EXPECT_EQ(test::bytesOfFile(file()).find("recent"), std::string::npos);
}

TEST_F(Settled, whereVolumesLieIsRememberedLongerThanTheListAndForgottenWithIt) {
  Settings settings(file());
  for (int i = 0; i < 102; ++i)
    settings.addKnownVolume("/" + std::to_string(i));
  settings.addKnownVolume("/50");
  const std::vector<std::filesystem::path> known = Settings(file()).knownVolumes();
  ASSERT_EQ(known.size(), 100u);
  EXPECT_EQ(known.front(), "/50");
  EXPECT_EQ(std::count(known.begin(), known.end(), "/1"), 0);
  EXPECT_TRUE(settings.recentSources().isEmpty());
  settings.setDialogFolder(QString::fromStdString(folder.path().string()));
  EXPECT_FALSE(Settings(file()).dialogFolder().isEmpty());
  settings.clearRecentSources();
  EXPECT_TRUE(Settings(file()).knownVolumes().empty());
  EXPECT_TRUE(Settings(file()).dialogFolder().isEmpty());
}

TEST_F(Settled, whatWasDismissedIsRememberedOfAHundredAndForgottenWithTheRecentFiles) {
  Settings settings(file());
  for (int i = 0; i < 102; ++i)
    settings.setDismissed("/" + std::to_string(i), "No spacing.");
  EXPECT_FALSE(settings.isDismissed("/0", "No spacing."));
  EXPECT_FALSE(settings.isDismissed("/1", "No spacing."));
  EXPECT_TRUE(settings.isDismissed("/2", "No spacing."));
  EXPECT_TRUE(Settings(file()).isDismissed("/101", "No spacing."));
  EXPECT_FALSE(settings.isDismissed("/101", "Another sentence."));
  // One file that is taken off the list takes its own with it.
  settings.addRecentSource("/10", "label");
  settings.setDismissed("/10", "No orientation.");
  settings.removeRecentSource("/10");
  EXPECT_FALSE(settings.isDismissed("/10", "No spacing."));
  EXPECT_FALSE(settings.isDismissed("/10", "No orientation."));
  EXPECT_TRUE(settings.isDismissed("/101", "No spacing."));
  settings.clearRecentSources();
  EXPECT_FALSE(settings.isDismissed("/101", "No spacing."));
  EXPECT_EQ(test::bytesOfFile(file()).find("dismissed"), std::string::npos);
}

TEST_F(Settled, aPathHasOneNameThatStandsForIt) {
  Settings settings(file());
  const std::string name = settings.referenceTo("/data/A", "ct-1x2x3");
  EXPECT_TRUE(name.starts_with("ct-1x2x3-"));
  EXPECT_EQ(Settings(file()).referenceTo("/data/A", "other"), name);
  EXPECT_NE(settings.referenceTo("/data/B", "ct-1x2x3"), name);
  EXPECT_EQ(settings.references().at(name), "/data/A");
}

TEST_F(Settled, aDamagedFileIsPutAsideAndSettingsWork) {
  std::filesystem::create_directories(file().parent_path());
  test::writeBytes(file(), "{\"limn_settings\": 1, ");
  Settings settings(file());
  EXPECT_EQ(settings.theme(), "system");
  settings.setTheme("dark");
  EXPECT_EQ(Settings(file()).theme(), "dark");
  EXPECT_EQ(test::bytesOfFile(file().string() + ".damaged"), "{\"limn_settings\": 1, ");
}

TEST_F(Settled, whereNothingCanBeWrittenItIsSaidOnceAndHoldsForThisRun) {
  test::writeBytes(folder.path() / "config", "a file where the folder should be");
  Settings settings(file());
  QStringList said;
  settings.setOnProblem([&](const QString& sentence) { said << sentence; });
  settings.setTheme("dark");
  settings.setMovingMs(16);
  EXPECT_EQ(settings.theme(), "dark");
  EXPECT_EQ(settings.movingMs(), 16);
  ASSERT_EQ(said.size(), 1);
  EXPECT_TRUE(said.front().contains("Not a directory")) << said.front().toStdString();
}

} // namespace
} // namespace limn
