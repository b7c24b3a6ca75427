// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/AtomicFile.h"

#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

namespace fs = std::filesystem;
using test::bytesOfFile;
using test::entriesOf;
using test::TemporaryFolder;

TEST(AtomicFile, writesANewFileAndReplacesAnOldOne) {
  const TemporaryFolder folder;
  writeFileAtomically(folder.path() / "a.json", "first");
  EXPECT_EQ(bytesOfFile(folder.path() / "a.json"), "first");
  writeFileAtomically(folder.path() / "a.json", "");
  EXPECT_EQ(bytesOfFile(folder.path() / "a.json"), "");
  EXPECT_EQ(entriesOf(folder.path()), 1u);
}

TEST(AtomicFile, aFailingWriterLeavesTheOldFileAndNoOther) {
  const TemporaryFolder folder;
  writeFileAtomically(folder.path() / "a.json", "old");
  const auto failing = [](const fs::path& temporary) {
    test::writeBytes(temporary, "half");
    throw Error(Error::Kind::other, "disk full");
  };
  EXPECT_THROW(replaceAtomically(folder.path() / "a.json", failing), Error);
  EXPECT_EQ(bytesOfFile(folder.path() / "a.json"), "old");
  EXPECT_EQ(entriesOf(folder.path()), 1u);
}

TEST(AtomicFile, aMissingFolderIsAnErrorThatNamesTheFile) {
  const TemporaryFolder folder;
  try {
    writeFileAtomically(folder.path() / "none" / "a.json", "text");
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a.json"), std::string::npos) << error.what();
  }
  EXPECT_EQ(entriesOf(folder.path()), 0u);
}

TEST(AtomicFile, aFolderIsNeverReplaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "sub");
  EXPECT_THROW(writeFileAtomically(folder.path() / "sub", "text"), Error);
  EXPECT_TRUE(fs::is_directory(folder.path() / "sub"));
}

TEST(AtomicFile, aPlaceIsRefusedBeforehandWhereWritingWouldFail) {
  const TemporaryFolder folder;
  const auto refusal = [](const fs::path& target) {
    try {
      requireWritable(target);
      return std::string();
    } catch (const Error& error) {
      return std::string(error.what());
    }
  };
  const fs::path file = folder.path() / "a.json";
  EXPECT_EQ(refusal(file), "") << "a new file";
  writeFileAtomically(file, "old");
  EXPECT_EQ(refusal(file), "") << "an old one";
  EXPECT_NE(refusal(folder.path() / "none" / "a.json").find("there is no folder"), std::string::npos);
  EXPECT_NE(refusal(file / "b.json").find("Not a directory"), std::string::npos);
  EXPECT_NE(refusal("/proc/a.json").find("Cannot write /proc/a.json"), std::string::npos)
      << "where nobody can make a file, though root has every right";
  EXPECT_NE(refusal(folder.path()).find("Is a directory; choose another name."), std::string::npos);
  EXPECT_EQ(bytesOfFile(file), "old");
  EXPECT_EQ(entriesOf(folder.path()), 1u) << "nothing is left of the trial";
}

TEST(AtomicFile, theRightsOfTheOldFileStay) {
  const TemporaryFolder folder;
  writeFileAtomically(folder.path() / "a.json", "old");
  const fs::perms rights = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
  fs::permissions(folder.path() / "a.json", rights);
  writeFileAtomically(folder.path() / "a.json", "new");
  EXPECT_EQ(fs::status(folder.path() / "a.json").permissions(), rights);
}

TEST(AtomicFile, whatIsPrivateIsReadByNobodyElse) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "settings.json";
  const fs::perms owners = fs::perms::owner_read | fs::perms::owner_write;
  writeFileAtomically(file, "new", FilePlace::fixedPrivate);
  EXPECT_EQ(fs::status(file).permissions(), owners);
  fs::permissions(file, owners | fs::perms::group_read | fs::perms::others_read); // of an earlier version
  writeFileAtomically(file, "newer", FilePlace::fixedPrivate);
  EXPECT_EQ(fs::status(file).permissions(), owners);
}

std::string writeRefusal(const fs::path& file, FilePlace place) {
  try {
    writeFileAtomically(file, "text", place);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(AtomicFile, adviceIsSuchThatItCanBeTaken) {
  const TemporaryFolder folder;
  const std::string users = writeRefusal(folder.path() / "none" / "a.json", FilePlace::chosen);
  EXPECT_NE(users.find("choose another folder"), std::string::npos) << users;
  EXPECT_EQ(users.find("old file"), std::string::npos) << users; // there is none
  const std::string programs = writeRefusal(folder.path() / "none" / "a.json", FilePlace::fixed);
  EXPECT_NE(programs.find("allow Limn to write there"), std::string::npos) << programs;
  EXPECT_EQ(programs.find("choose"), std::string::npos) << programs;
  const std::string kernels = writeRefusal("/proc/a.json", FilePlace::chosen); // is there, and takes no file
  EXPECT_NE(kernels.find("choose another folder."), std::string::npos) << kernels;
  EXPECT_EQ(kernels.find("there is no folder"), std::string::npos) << kernels;
  EXPECT_EQ(kernels, "Cannot write /proc/a.json: the folder /proc takes no files; choose another folder.");
}

TEST(AtomicFile, foldersAreMadeOrItIsSaidWhyNot) {
  const TemporaryFolder folder;
  EXPECT_TRUE(makeFolders(folder.path() / "a" / "b").empty());
  EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
  EXPECT_TRUE(makeFolders(folder.path() / "a" / "b").empty()) << "it is there";
  EXPECT_TRUE(makeFolders({}).empty()) << "the current folder";
  writeFileAtomically(folder.path() / "file", "no folder");
  EXPECT_EQ(makeFolders(folder.path() / "file" / "b").english(), "Not a directory");
  for (const char* below : {"/proc/a", "/proc/a/b", "/proc/a/"}) // is there, and takes no folder
    EXPECT_EQ(makeFolders(below).english(), "the folder /proc takes no files") << below;
  try {
    const ScratchFolder scratch("/proc");
    FAIL() << "it was made";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the folder /proc takes no files");
  }
}

TEST(AtomicFile, aLinkStaysALink) {
  const TemporaryFolder folder;
  writeFileAtomically(folder.path() / "a.json", "old");
  fs::create_symlink("a.json", folder.path() / "link.json");
  writeFileAtomically(folder.path() / "link.json", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.json"));
  EXPECT_EQ(bytesOfFile(folder.path() / "a.json"), "new");
}

} // namespace
} // namespace limn
