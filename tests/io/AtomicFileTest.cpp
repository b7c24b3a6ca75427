// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/AtomicFile.h"

#include "scene/Error.h"
#include "support/TestFolder.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

namespace fs = std::filesystem;
using test::bytesOfFile;
using test::TestFolder;

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(AtomicFile, writesANewFileAndReplacesAnOldOne) {
  const TestFolder folder;
  writeFileAtomically(folder / "a.json", "first");
  EXPECT_EQ(bytesOfFile(folder / "a.json"), "first");
  writeFileAtomically(folder / "a.json", "");
  EXPECT_EQ(bytesOfFile(folder / "a.json"), "");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(AtomicFile, aFailingWriterLeavesTheOldFileAndNoOther) {
  const TestFolder folder;
  writeFileAtomically(folder / "a.json", "old");
  const auto failing = [](const fs::path& temporary) {
    test::writeBytes(temporary, "half");
    throw Error(Error::Kind::other, "disk full");
  };
  EXPECT_THROW(replaceAtomically(folder / "a.json", failing), Error);
  EXPECT_EQ(bytesOfFile(folder / "a.json"), "old");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(AtomicFile, aMissingFolderIsAnErrorThatNamesTheFile) {
  const TestFolder folder;
  try {
    writeFileAtomically(folder / "none" / "a.json", "text");
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a.json"), std::string::npos) << error.what();
  }
  EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST(AtomicFile, aFolderIsNeverReplaced) {
  const TestFolder folder;
  fs::create_directory(folder / "sub");
  EXPECT_THROW(writeFileAtomically(folder / "sub", "text"), Error);
  EXPECT_TRUE(fs::is_directory(folder / "sub"));
}

TEST(AtomicFile, theRightsOfTheOldFileStay) {
  const TestFolder folder;
  writeFileAtomically(folder / "a.json", "old");
  const fs::perms rights = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
  fs::permissions(folder / "a.json", rights);
  writeFileAtomically(folder / "a.json", "new");
  EXPECT_EQ(fs::status(folder / "a.json").permissions(), rights);
}

} // namespace
} // namespace limn
