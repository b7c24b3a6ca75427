// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/FileLock.h"

#include "io/AtomicFile.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <csignal>

namespace limn {
namespace {

namespace fs = std::filesystem;

TEST(FileLock, isHeldByOneAtATime) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "lock";
  std::optional<FileLock> first = FileLock::tryFor(file);
  ASSERT_TRUE(first);
  EXPECT_FALSE(FileLock::tryFor(file));
  first.reset();
  EXPECT_TRUE(FileLock::tryFor(file));
}

TEST(FileLock, endsWithItsProcessHoweverThatEnds) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "lock";
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const FileLock held = FileLock::waitFor(file);
    [[maybe_unused]] const auto told = ::write(ready[1], "x", 1);
    for (;;)
      ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_FALSE(FileLock::tryFor(file));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(FileLock::tryFor(file));
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST(FileLock, aFolderThatIsAFileIsSaidInOneSentence) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / "file", "");
  try {
    FileLock::waitFor(folder.path() / "file" / "lock");
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Not a directory"), std::string::npos) << error.what();
  }
}

TEST(AtomicFileTemporaries, thoseOfTheDeadAreRemovedAtTheNextWriting) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / ".limn-1234.json", "half");
  test::writeBytes(folder.path() / ".limn-mine.json", "not of this kind");
  test::writeBytes(folder.path() / ".limn-", "nor this");
  EXPECT_TRUE(isTemporary(folder.path() / ".limn-1234.json"));
  EXPECT_FALSE(isTemporary(folder.path() / ".limn-mine.json"));
  writeFileAtomically(folder.path() / "a.json", "text");
  EXPECT_FALSE(fs::exists(folder.path() / ".limn-1234.json"));
  EXPECT_EQ(test::entriesOf(folder.path()), 3u);
}

TEST(AtomicFileTemporaries, oneThatIsBeingWrittenStays) {
  const test::TemporaryFolder folder;
  replaceAtomically(folder.path() / "slow.json", [&](const fs::path& temporary) {
    writeFileAtomically(folder.path() / "quick.json", "2");
    EXPECT_TRUE(fs::exists(temporary));
    test::writeBytes(temporary, "1");
  });
  EXPECT_EQ(test::bytesOfFile(folder.path() / "slow.json"), "1");
  EXPECT_EQ(test::bytesOfFile(folder.path() / "quick.json"), "2");
}

} // namespace
} // namespace limn
