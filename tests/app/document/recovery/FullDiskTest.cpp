// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/naming/UserFolders.h"
#include "app/document/Settings.h"
#include "app/document/recovery/SessionKeeper.h"
#include "app/presets/PresetStore.h"
#include "io/AtomicFile.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <QCoreApplication>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

// A disk with room for 64 bytes (a limit on the size of files: it needs no rights of an administrator), and
// folders that cannot be written.

namespace limn {
namespace {

namespace fs = std::filesystem;

class FullDisk {
public:
  FullDisk() {
    ::getrlimit(RLIMIT_FSIZE, &m_before);
    rlimit small = m_before;
    small.rlim_cur = 64;
    m_handler = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &m_before);
    std::signal(SIGXFSZ, m_handler);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

private:
  rlimit m_before{};
  void (*m_handler)(int) = SIG_DFL;
};

Preset mine(const std::string& note) {
  Preset preset = builtInPresets().front();
  preset.name = "Mine";
  preset.note = note;
  return preset;
}

void expectOneSentence(const std::string& text) {
  EXPECT_TRUE(text.ends_with(".")) << text;
  EXPECT_EQ(text.find(". "), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

template <class Work>
std::string sentenceOf(Work&& work) {
  try {
    work();
    ADD_FAILURE() << "nothing was thrown";
    return {};
  } catch (const Error& error) {
    expectOneSentence(error.what());
    return error.what();
  }
}

TEST(FullDisk, theOldPresetStaysAndTheReasonIsSaid) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path());
  store.save(mine("old"));
  {
    const FullDisk full;
    EXPECT_NE(sentenceOf([&] { store.save(mine("new")); }).find("File too large"), std::string::npos);
  }
  const PresetStore::Contents contents = store.read();
  ASSERT_EQ(contents.presets.size(), 1u);
  EXPECT_EQ(contents.presets.front().note, "old");
  EXPECT_EQ(test::entriesOf(folder.path()), 1u);
}

TEST(FullDisk, theOldSettingsStayAndTheNewOnesHoldForThisRun) {
  const test::TemporaryFolder folder;
  Settings settings(folder.path() / "settings.json");
  settings.setTheme("dark");
  QStringList said;
  settings.setOnProblem([&](const QString& sentence) { said << sentence; });
  {
    const FullDisk full;
    settings.setTheme("light");
    settings.setMovingMs(16);
  }
  EXPECT_EQ(settings.theme(), "light");
  EXPECT_EQ(Settings(folder.path() / "settings.json").theme(), "dark");
  ASSERT_EQ(said.size(), 1);
  expectOneSentence(said.front().toStdString());
}

TEST(FullDisk, theOldAutosaveStaysUntilThereIsRoomAgain) {
  const test::TemporaryFolder folder;
  int argc = 1;
  char name[] = "test";
  char* argv[] = {name, nullptr};
  const QCoreApplication application(argc, argv);
  SessionDocument session;
  session.scene.volume = "phantom";
  Autosave autosave(folder.path() / "session.json", [&] { return std::optional(session); });
  QStringList said;
  QObject::connect(&autosave, &Autosave::failed, [&](const QString& sentence) { said << sentence; });
  EXPECT_TRUE(autosave.savingOfNow()());
  const std::string first = test::bytesOfFile(folder.path() / "session.json");
  session.wipe = 0.75;
  {
    const FullDisk full;
    EXPECT_FALSE(autosave.savingOfNow()());
    EXPECT_FALSE(autosave.savingOfNow()());
  }
  QCoreApplication::processEvents();
  ASSERT_EQ(said.size(), 1); // once, not every two seconds
  expectOneSentence(said.front().toStdString());
  EXPECT_EQ(test::bytesOfFile(folder.path() / "session.json"), first);
  int recoveries = 0;
  QObject::connect(&autosave, &Autosave::recovered, [&] { ++recoveries; });
  EXPECT_TRUE(autosave.savingOfNow()());
  QCoreApplication::processEvents();
  EXPECT_EQ(recoveries, 1);
  EXPECT_EQ(readSessionFile(folder.path() / "session.json").wipe, 0.75);
}

TEST(FullDisk, theOldSessionStays) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "session.json";
  SessionDocument session;
  session.scene.volume = "phantom";
  writeFileAtomically(file, sessionToJson(session));
  const std::string old = test::bytesOfFile(file);
  session.wipe = 0.75;
  {
    const FullDisk full;
    sentenceOf([&] { writeFileAtomically(file, sessionToJson(session)); });
  }
  EXPECT_EQ(test::bytesOfFile(file), old);
}

// A file in the place of the folder refuses everybody, an administrator too.
TEST(NoFolder, presetsAndSessionsSaySo) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / "presets", "a file");
  const PresetStore store(folder.path() / "presets");
  EXPECT_NE(sentenceOf([&] { store.save(mine("")); }).find("Not a directory"), std::string::npos);
  EXPECT_TRUE(store.read().presets.empty());
  sentenceOf([&] { writeFileAtomically(folder.path() / "presets" / "s.json", "{}"); });
  EXPECT_EQ(test::bytesOfFile(folder.path() / "presets"), "a file");
}

// Rights do not bind an administrator, so one becomes an ordinary user for a while.
class Ordinary {
public:
  Ordinary() : m_before(::geteuid()) {
    if (m_before == 0 && ::seteuid(65534) != 0)
      throw std::runtime_error("cannot become an ordinary user");
  }
  ~Ordinary() {
    if (m_before == 0 && ::seteuid(m_before) != 0)
      std::abort();
  }
  Ordinary(const Ordinary&) = delete;
  Ordinary& operator=(const Ordinary&) = delete;

private:
  uid_t m_before;
};

TEST(ReadOnlyFolder, theOldPresetStaysAndTheReasonIsSaid) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path() / "presets");
  store.save(mine("old"));
  // Everybody may look, only the owner may write; then nobody may.
  const fs::perms look = fs::perms(0555);
  fs::permissions(folder.path(), look | fs::perms::owner_write);
  fs::permissions(folder.path() / "presets", look);
  const Ordinary user;
  EXPECT_NE(sentenceOf([&] { store.save(mine("new")); }).find("Permission denied"), std::string::npos);
  const PresetStore::Contents contents = store.read();
  ASSERT_EQ(contents.presets.size(), 1u);
  EXPECT_EQ(contents.presets.front().note, "old");
}

// The folder could not be made: that is the cause, not that the file is not there.
TEST(ReadOnlyFolder, aFolderThatCannotBeMadeIsNamedAsTheCause) {
  const test::TemporaryFolder home;
  fs::permissions(home.path(), fs::perms(0555));
  const UserFolders folders = UserFolders::below(home.path());
  const Ordinary user;
  QStringList said;
  Settings settings(folders.settings);
  settings.setOnProblem([&](const QString& sentence) { said << sentence; });
  settings.setTheme("dark");
  ASSERT_EQ(said.size(), 1);
  for (const std::string& sentence :
       {said.front().toStdString(), sentenceOf([&] { PresetStore(folders.presets).save(mine("")); }),
        sentenceOf([&] { UnsavedSessions(folders.sessions).place(); })}) {
    expectOneSentence(sentence);
    EXPECT_NE(sentence.find("Permission denied"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("choose another folder"), std::string::npos) << sentence;
  }
}

} // namespace
} // namespace limn
