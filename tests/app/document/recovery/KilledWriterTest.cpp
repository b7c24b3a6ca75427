// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Settings.h"
#include "app/document/recovery/SessionKeeper.h"
#include "app/presets/PresetStore.h"
#include "io/AtomicFile.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <functional>
#include <optional>
#include <random>
#include <thread>

// kill -9 at random moments: a process that does nothing but save is killed, and what it saved is read.

namespace limn {
namespace {

namespace fs = std::filesystem;

/// Saves the state with this number.
using Save = std::function<void(int)>;
/// Makes what saves into a folder, in the process that will be killed.
using Saver = std::function<Save(const fs::path& folder)>;
/// The number of the state that a folder holds; throws or fails where it cannot be read.
using Read = std::function<std::optional<int>(const fs::path& folder)>;

struct Deaths {
  int kills = 0;
  int inTheMiddle = 0; ///< a temporary file was left behind
  int newest = 0;      ///< the state begun last was found, otherwise the one before
};

std::size_t temporariesBelow(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    count += isTemporary(entry.path());
  return count;
}

// Saves first, first + 1, … until killed; returns the number of the last one completed. It dies after `share`
// (0 to 1) of some milliseconds, which is what a write takes, so that each of its parts is met; where making
// the text takes longer, of as much time as two take.
int saveUntilKilled(const Save& save, int first, double share) {
  using std::chrono::steady_clock;
  int completed[2];
  EXPECT_EQ(::pipe(completed), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    for (int number = first;; ++number) {
      save(number);
      if (::write(completed[1], &number, sizeof number) != sizeof number)
        std::_Exit(1);
    }
  }
  ::close(completed[1]);
  // The time of death is what the test is about; it counts from the second completed state.
  int last = first - 1;
  EXPECT_EQ(::read(completed[0], &last, sizeof last), static_cast<ssize_t>(sizeof last));
  const steady_clock::time_point before = steady_clock::now();
  EXPECT_EQ(::read(completed[0], &last, sizeof last), static_cast<ssize_t>(sizeof last));
  const steady_clock::duration two = 2 * (steady_clock::now() - before);
  std::this_thread::sleep_for(share * std::max<steady_clock::duration>(two, std::chrono::milliseconds(12)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  while (::read(completed[0], &last, sizeof last) == sizeof last) {
  }
  ::close(completed[0]);
  return last;
}

Deaths killOften(int kills, unsigned seed, const Saver& saver, const Read& read) {
  const test::TemporaryFolder folder;
  std::mt19937 random(seed);
  Deaths deaths;
  for (int number = 1; deaths.kills < kills && !testing::Test::HasFatalFailure(); ++deaths.kills) {
    const double share = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    const int completed = saveUntilKilled(saver(folder.path()), number, share);
    deaths.inTheMiddle += temporariesBelow(folder.path()) > 0;
    const std::optional<int> found = read(folder.path());
    EXPECT_TRUE(found) << "after kill " << deaths.kills;
    EXPECT_GE(found.value_or(0), completed);
    EXPECT_LE(found.value_or(0), completed + 1);
    deaths.newest += found == completed + 1;
    number = completed + 2;
  }
  // The next writing removes what the dead left.
  saver(folder.path())(1000000);
  EXPECT_EQ(temporariesBelow(folder.path()), 0u);
  std::printf("%d kills, %d in the middle of writing, %d with the newer state\n", deaths.kills,
              deaths.inTheMiddle, deaths.newest);
  return deaths;
}

SessionDocument sessionNumbered(int number) {
  SessionDocument session;
  session.scene.volume = "/data/head";
  session.scene.hasCamera = session.scene.hasTransferFunction = true;
  session.scene.scene.isovalue = number;
  // Of a size that takes several blocks.
  for (int i = 0; i < 300; ++i)
    session.scene.scene.transferFunction.points.push_back({static_cast<double>(i), {0.1, 0.2, 0.3}, 0.5});
  return session;
}

TEST(Killed, presetsSurvive) {
  const Deaths deaths = killOften(
      90, 1,
      [](const fs::path& folder) -> Save {
        return [store = PresetStore(folder / "presets")](int number) {
          Preset preset = builtInPresets().front();
          preset.name = "Mine";
          preset.isovalue = number;
          store.save(preset);
        };
      },
      [](const fs::path& folder) -> std::optional<int> {
        const PresetStore::Contents contents = PresetStore(folder / "presets").read();
        EXPECT_TRUE(contents.problems.empty()) << contents.problems.front().english();
        EXPECT_EQ(contents.presets.size(), 1u); // no temporary file among them
        return contents.presets.empty() ? std::nullopt
                                        : std::optional(static_cast<int>(*contents.presets.front().isovalue));
      });
  EXPECT_GT(deaths.inTheMiddle, 0);
}

TEST(Killed, sessionsSurvive) {
  const Deaths deaths = killOften(
      90, 2,
      [](const fs::path& folder) -> Save {
        return [file = folder / "session.json"](int number) {
          writeFileAtomically(file, sessionToJson(sessionNumbered(number)));
        };
      },
      [](const fs::path& folder) -> std::optional<int> {
        return static_cast<int>(readSessionFile(folder / "session.json").scene.scene.isovalue);
      });
  EXPECT_GT(deaths.inTheMiddle, 0);
}

TEST(Killed, settingsSurviveAndNobodyWaitsForTheDead) {
  const Deaths deaths = killOften(
      90, 3,
      [](const fs::path& folder) -> Save {
        return [file = folder / "config" / "settings.json"](int number) {
          Settings settings(file);
          settings.setMovingMs(number);
          settings.addRecentSource(QStringLiteral("/data/head"), QStringLiteral("head"));
        };
      },
      [](const fs::path& folder) -> std::optional<int> {
        Settings settings(folder / "config" / "settings.json");
        EXPECT_EQ(settings.recentSources().size(), 1);
        settings.setTheme(QStringLiteral("dark")); // takes the lock
        return static_cast<int>(settings.movingMs());
      });
  EXPECT_GT(deaths.inTheMiddle, 0);
}

TEST(Killed, autosavesSurviveAndAreFoundAbandoned) {
  const Deaths deaths = killOften(
      90, 4,
      [](const fs::path& folder) -> Save {
        struct Window {
          std::vector<AutosavePlace> earlier;
          AutosavePlace place;
        };
        // Made in the process that dies: the lock is its own.
        auto made = std::make_shared<std::optional<Window>>();
        return [folder, made](int number) {
          if (!*made) {
            const UnsavedSessions sessions(folder);
            std::vector<AutosavePlace> earlier = sessions.takeAbandoned();
            made->emplace(Window{std::move(earlier), sessions.place()});
          }
          const Window& window = **made;
          writeFileAtomically(window.place.file(), sessionToJson(sessionNumbered(number)));
          for (const AutosavePlace& dead : window.earlier)
            dead.remove();
        };
      },
      [](const fs::path& folder) -> std::optional<int> {
        // Until the new session is on the disk the one before is there as well; the latest counts.
        const std::vector<AutosavePlace> found = UnsavedSessions(folder).takeAbandoned();
        std::optional<int> latest;
        for (const AutosavePlace& place : found)
          latest = std::max(latest.value_or(0),
                            static_cast<int>(readSessionFile(place.file()).scene.scene.isovalue));
        return latest;
      });
  EXPECT_GT(deaths.inTheMiddle, 0);
}

// Two processes that save at once.
void inTwoProcesses(const std::function<void(int process)>& work) {
  pid_t children[2];
  for (int process = 0; process < 2; ++process) {
    children[process] = ::fork();
    if (children[process] == 0) {
      work(process);
      std::_Exit(0);
    }
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
}

TEST(TwoWindows, loseNoSettingOfEachOther) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "config" / "settings.json";
  inTwoProcesses([&](int process) {
    Settings settings(file);
    for (int i = 0; i < 40; ++i) {
      settings.referenceTo("/data/" + std::to_string(process) + "/" + std::to_string(i), "ct");
      process == 0 ? settings.setMovingMs(i) : settings.setTheme(QString::number(i));
      settings.addRecentSource(QString::number(process * 5 + i % 5), QStringLiteral("label"));
    }
  });
  Settings settings(file);
  EXPECT_EQ(settings.references().size(), 80u);
  EXPECT_EQ(settings.movingMs(), 39);
  EXPECT_EQ(settings.theme(), QStringLiteral("39"));
  EXPECT_EQ(settings.recentSources().size(), 10);
}

TEST(TwoWindows, loseNoPresetOfEachOtherAndOfOneNameTheLastWins) {
  const test::TemporaryFolder folder;
  const PresetStore store(folder.path() / "presets");
  inTwoProcesses([&](int process) {
    for (int i = 0; i < 30; ++i) {
      Preset preset = builtInPresets().front();
      preset.name = "Own " + std::to_string(process) + " " + std::to_string(i);
      store.save(preset);
      preset.name = "Shared";
      preset.note = std::to_string(i);
      store.save(preset);
    }
  });
  const PresetStore::Contents contents = store.read();
  EXPECT_EQ(contents.presets.size(), 61u);
  EXPECT_TRUE(contents.problems.empty());
  EXPECT_EQ(temporariesBelow(folder.path()), 0u);
  EXPECT_EQ(presetNamed(contents.presets, "Shared").note, "29");
}

} // namespace
} // namespace limn
