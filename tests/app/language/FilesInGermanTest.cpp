// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"
#include "app/language/InGerman.h"
#include "app/presets/PresetStore.h"
#include "io/reports/ReportJson.h"
#include "io/scenefile/SessionFile.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"
#include "support/Waiting.h"
#include "widgets/accuracy/AccuracySamples.h"
#include "widgets/view/CompareView.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>

namespace limn::test {
namespace {

// What the window writes of one state.
struct Written {
  std::string session, preset, settings, table;
};

/// Where the system is a German one, as long as it lives: in C's functions the decimal point is a comma.
class InGermany {
public:
  explicit InGermany(const std::filesystem::path& locales) {
    const std::string command = "localedef -i de_DE -f UTF-8 " + (locales / "de_DE.UTF-8").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    setenv("LOCPATH", locales.c_str(), 1);
    std::setlocale(LC_ALL, "de_DE.UTF-8");
  }
  ~InGermany() {
    std::setlocale(LC_ALL, "C.UTF-8");
    unsetenv("LOCPATH");
  }
  InGermany(const InGermany&) = delete;
  InGermany& operator=(const InGermany&) = delete;
};

Written writtenByAWindow() {
  const TemporaryFolder folder;
  UserFolders folders = UserFolders::below(folder.path());
  Settings(folders.settings).setMovingMs(33.5);
  const std::string settings = bytesOfFile(folders.settings);
  MainWindow window(folders);
  window.openSource(QStringLiteral("phantom:8"));
  EXPECT_TRUE(waitUntil([&] { return !window.loader().isLoading() && window.view().scene().volume; }));
  Preset own = builtInPresets().front();
  own.name = "My own";
  const PresetStore store(folders.presets);
  store.save(own);
  std::vector<OperatingPoint> points(3);
  points[1].stepVoxels = 0.25;
  points[2].earlyTermination = 0.95;
  Written written{sessionToJson(window.sessionDocument()), {}, settings, accuracyCsv(sampleReport(points))};
  for (const auto& entry : std::filesystem::directory_iterator(folders.presets))
    written.preset += bytesOfFile(entry.path());
  return written;
}

TEST(FilesInGerman, areThoseOfAnEnglishWindowByteForByte) {
  const Written english = writtenByAWindow();
  ASSERT_NE(english.session.find("0."), std::string::npos) << "it has decimals";
  ASSERT_NE(english.table.find("0.25"), std::string::npos) << english.table;
  ASSERT_NE(english.preset.find("My own"), std::string::npos);
  const TemporaryFolder locales;
  const InGermany germany(locales.path());
  ASSERT_STREQ(std::localeconv()->decimal_point, ",") << "made by localedef, of Debian's package locales";
  const InGerman german;
  EXPECT_STREQ(std::localeconv()->decimal_point, ".");
  const Written inGerman = writtenByAWindow();
  EXPECT_EQ(inGerman.session, english.session);
  EXPECT_EQ(inGerman.preset, english.preset);
  EXPECT_EQ(inGerman.settings, english.settings);
  EXPECT_EQ(inGerman.table, english.table);
}

} // namespace
} // namespace limn::test
