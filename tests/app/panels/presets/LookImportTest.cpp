// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/LookController.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace limn {
namespace {

// Two colour maps of ParaView, the second with its colours in Lab. Neither says per which length it is.
TEST(LookImport, aRemarkOnOneOfAFilesLooksNamesItAndOneOnAllIsMadeOnceAndSaysSo) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "maps.json";
  std::ofstream(file) << R"([
    {"Name": "Plain", "RGBPoints": [100, 0, 0, 0, 300, 1, 1, 1], "Points": [100, 0, 0.5, 0, 300, 1, 0.5, 0]},
    {"Name": "Bent", "ColorSpace": "Lab", "RGBPoints": [100, 1, 0, 0, 300, 0, 0, 1],
     "Points": [100, 0, 0.5, 0, 300, 1, 0.5, 0]}])";
  const LookImport import =
      importLooks({QString::fromStdString(file.string())}, std::nullopt, PresetStore(folder.path() / "own"));
  EXPECT_EQ(import.presets, QStringList({"Plain", "Bent"}));
  ASSERT_EQ(import.files.size(), 1u);
  const QStringList& told = import.files.front().sentences;
  EXPECT_EQ(told,
            QStringList({
                "All of them: The file does not say over which length its opacities hold; 1 mm was taken.",
                "Bent: Colours between points in the colour space Lab became points in RGB.",
                "Bent: Curved segments became straight ones that differ from them by at most 0.01.",
            }));
}

} // namespace
} // namespace limn
