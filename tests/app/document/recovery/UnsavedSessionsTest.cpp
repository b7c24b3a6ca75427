// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recovery/SessionKeeper.h"

#include "io/AtomicFile.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

namespace fs = std::filesystem;

TEST(UnsavedSessions, aLivePlaceIsNeverTaken) {
  const test::TemporaryFolder folder;
  const UnsavedSessions sessions(folder.path() / "sessions");
  const AutosavePlace mine = sessions.place();
  writeFileAtomically(mine.file(), "mine");
  EXPECT_TRUE(sessions.takeAbandoned().empty());
  EXPECT_EQ(test::bytesOfFile(mine.file()), "mine");
}

TEST(UnsavedSessions, aDeadOneIsGivenToOneCallerUntilThatOneDies) {
  const test::TemporaryFolder folder;
  const UnsavedSessions sessions(folder.path());
  {
    const AutosavePlace dead = sessions.place();
    writeFileAtomically(dead.file(), "left");
  }
  std::vector<AutosavePlace> first = sessions.takeAbandoned();
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(test::bytesOfFile(first.front().file()), "left");
  EXPECT_TRUE(sessions.takeAbandoned().empty());
  first.clear(); // dies without an answer
  const std::vector<AutosavePlace> second = sessions.takeAbandoned();
  ASSERT_EQ(second.size(), 1u);
  second.front().remove();
  EXPECT_TRUE(sessions.takeAbandoned().empty());
}

// A crashed process holds its locks until it has gone, while the next window is open already.
TEST(UnsavedSessions, aWindowThatDiesSlowlyIsOfferedOnceItIsDead) {
  const test::TemporaryFolder folder;
  const UnsavedSessions sessions(folder.path());
  auto dying = std::make_unique<AutosavePlace>(sessions.place());
  writeFileAtomically(dying->file(), "left");
  SessionKeeper keeper(folder.path(), [] { return std::nullopt; });
  int found = 0;
  QObject::connect(&keeper, &SessionKeeper::abandonedFound, &keeper, [&found] { ++found; });
  keeper.lookAgain();
  EXPECT_FALSE(keeper.abandoned());
  dying.reset();
  keeper.lookAgain();
  ASSERT_TRUE(keeper.abandoned());
  EXPECT_EQ(test::bytesOfFile(*keeper.abandoned()), "left");
  keeper.lookAgain();
  EXPECT_EQ(found, 1) << "each is told once";
}

TEST(UnsavedSessions, whatDeadWindowsLeftBesideIsRemoved) {
  const test::TemporaryFolder folder;
  const UnsavedSessions sessions(folder.path());
  {
    const AutosavePlace empty = sessions.place();
    test::writeBytes(empty.file().parent_path() / ".limn-77.json", "half");
  }
  EXPECT_TRUE(sessions.takeAbandoned().empty());
  EXPECT_EQ(test::entriesOf(folder.path() / "windows"), 0u);
}

TEST(UnsavedSessions, theLastTenAreKept) {
  const test::TemporaryFolder folder;
  const UnsavedSessions sessions(folder.path());
  for (int i = 0; i < 13; ++i)
    sessions.keep(std::to_string(i));
  const std::vector<fs::path> kept = sessions.kept();
  ASSERT_EQ(kept.size(), 10u);
  // Names sort by time to the millisecond; within one the order is any.
  int oldest = 13;
  for (const fs::path& file : kept)
    oldest = std::min(oldest, std::stoi(test::bytesOfFile(file)));
  EXPECT_LE(oldest, 3);
  EXPECT_EQ(test::entriesOf(folder.path() / "closed"), 10u);
}

TEST(UnsavedSessions, onlyThisUserMayLook) {
  const test::TemporaryFolder folder;
  const UnsavedSessions sessions(folder.path() / "sessions");
  const AutosavePlace mine = sessions.place();
  constexpr fs::perms others = fs::perms::group_all | fs::perms::others_all;
  EXPECT_EQ(fs::status(folder.path() / "sessions").permissions() & others, fs::perms::none);
}

TEST(UnsavedSessions, aFolderThatCannotBeMadeIsSaid) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / "file", "");
  EXPECT_THROW(UnsavedSessions(folder.path() / "file" / "sessions").place(), Error);
}

} // namespace
} // namespace limn
