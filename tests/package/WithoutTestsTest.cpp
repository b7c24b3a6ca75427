// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/Places.h"
#include "support/Shell.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

// A build for people who want the program alone.
namespace limn {
namespace {

TEST(BuildWithoutTests, looksForNoLibraryOfTestsAndForNoNetwork) {
  const test::TemporaryFolder folder;
  // Without any network where the system lets us have a namespace of our own.
  const std::string alone = test::said(folder.path(), "unshare --map-root-user --net true").status == 0
                                ? "unshare --map-root-user --net "
                                : "";
  const test::Said said =
      test::said(folder.path(), alone + "cmake -G Ninja -S '" + test::sourceFolder().string() +
                                    "' -B build -D BUILD_TESTING=OFF");
  ASSERT_EQ(said.status, 0) << said.text;
  const std::string cache = test::bytesOfFile(folder.path() / "build/CMakeCache.txt");
  EXPECT_NE(cache.find("Qt6Widgets_DIR"), std::string::npos);
  for (const char* unwanted : {"GTest", "Qt6Test", "XVFB"})
    EXPECT_EQ(cache.find(unwanted), std::string::npos) << unwanted;
  const test::Said targets = test::said(folder.path(), "ninja -C build -t targets all");
  EXPECT_NE(targets.text.find("limn_app"), std::string::npos);
  EXPECT_EQ(targets.text.find("_tests"), std::string::npos);
}

} // namespace
} // namespace limn
