// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "support/FileBytes.h"

#include <sys/wait.h>
#include <zlib.h>

#include <csignal>
#include <cstdlib>

// A real window in a process of its own is killed, or crashes inside a decoder, in the middle of reading a
// volume; the next window brings back what was edited.

namespace limn {
namespace {

namespace fs = std::filesystem;

// Where the process that will die finds and leaves its files.
const char* const folderVariable = "LIMN_TEST_VICTIM_FOLDER";
const char* const killVariable = "LIMN_TEST_VICTIM_KILLS_ITSELF";

// An NRRD header and 16 MiB of values that do not compress into a few blocks.
void writeCompressedVolume(const fs::path& folder) {
  test::writeBytes(folder / "volume.nhdr", "NRRD0004\ntype: short\ndimension: 3\nsizes: 256 256 128\n"
                                           "spacings: 1 1 1\nendian: little\nencoding: gzip\n"
                                           "data file: values.gz\n");
  std::string bytes;
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < std::size_t{256} * 256 * 128; ++i) {
    state = state * 1664525u + 1013904223u; // Numerical Recipes
    bytes += static_cast<char>(state >> 24);
    bytes += '\0';
  }
  gzFile file = gzopen((folder / "values.gz").c_str(), "wb1");
  ASSERT_EQ(gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size())), static_cast<int>(bytes.size()));
  gzclose(file);
}

using CrashVictim = test::WindowHarness;

// Run by the tests below in a process of its own.
TEST_F(CrashVictim, DISABLED_editsAndReadsUntilItDies) {
  const fs::path own = std::getenv(folderVariable);
  window = std::make_unique<MainWindow>(UserFolders::below(own));
  window->resize(900, 640);
  window->show();
  ASSERT_TRUE(test::waitUntilExposed(*window));
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  clickTool(QStringLiteral("Wipe"));
  QTest::keyClick(&view(), Qt::Key_L);
  ASSERT_TRUE(undo().canUndo());
  test::writeBytes(own / "expected", sessionToJson(window->sessionDocument()));
  if (std::getenv(killVariable))
    QObject::connect(&window->loader(), &VolumeLoader::progressed, window.get(),
                     [](double fraction, const QString&) {
                       if (fraction > 0.2)
                         ::kill(::getpid(), SIGKILL);
                     });
  window->openSource(QString::fromStdString((own / "volume.nhdr").string()));
  EXPECT_FALSE(test::waitUntil([this] { return !window->loader().isLoading(); })) << "the volume was read";
}

class Crash : public test::WindowHarness {
protected:
  // How the process ends that runs the test above with these variables set.
  int statusOfVictim(std::vector<std::pair<std::string, std::string>> variables) {
    // A sanitizer must neither turn the signal into an exit nor mind what is preloaded.
    variables.push_back({"ASAN_OPTIONS", "handle_segv=0:verify_asan_link_order=0"});
    variables.push_back({"TSAN_OPTIONS", "handle_segv=0"});
    const pid_t child = ::fork();
    if (child == 0) {
      for (const auto& [name, value] : variables)
        ::setenv(name.c_str(), value.c_str(), 1);
      ::execl("/proc/self/exe", "victim", "--gtest_also_run_disabled_tests", "--gtest_filter=CrashVictim.*",
              nullptr);
      std::_Exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
  }

  void restoreAndCompare() {
    ASSERT_TRUE(fs::exists(folder.path() / "expected")) << "the process died before it had worked";
    window = std::make_unique<MainWindow>(UserFolders::below(folder.path()));
    window->resize(900, 640);
    window->show();
    window->keepSessions();
    QToolButton* restore = nullptr;
    for (QToolButton* button : window->findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == QStringLiteral("Restore"))
        restore = button;
    ASSERT_NE(restore, nullptr);
    QTest::mouseClick(restore, Qt::LeftButton);
    ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
    EXPECT_EQ(sessionToJson(window->sessionDocument()), test::bytesOfFile(folder.path() / "expected"));
    EXPECT_TRUE(window->isWindowModified());
  }
};

TEST_F(Crash, aDecoderThatCrashesTakesNoUnsavedWorkAlong) {
  writeCompressedVolume(folder.path());
  const int status =
      statusOfVictim({{folderVariable, folder.path().string()}, {"LD_PRELOAD", LIMN_CRASHING_INFLATE}});
  ASSERT_TRUE(WIFSIGNALED(status)) << "exit status " << WEXITSTATUS(status);
  EXPECT_EQ(WTERMSIG(status), SIGSEGV);
  restoreAndCompare();
}

TEST_F(Crash, aProcessKilledWhileItReadsLosesNothing) {
  writeCompressedVolume(folder.path());
  const int status = statusOfVictim({{folderVariable, folder.path().string()}, {killVariable, "1"}});
  ASSERT_TRUE(WIFSIGNALED(status)) << "exit status " << WEXITSTATUS(status);
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
  restoreAndCompare();
}

} // namespace
} // namespace limn
