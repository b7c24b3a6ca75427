// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/privacy/Marks.h"
#include "support/FileBytes.h"
#include "support/Places.h"
#include "widgets/presets/PresetBrowser.h"

#include <QInputDialog>
#include <QMenu>

#include <sys/wait.h>
#include <zlib.h>

#include <cstdlib>
#include <functional>

// Every byte that the program writes while it shows a marked patient is searched for the marks.

namespace limn {
namespace {

namespace fs = std::filesystem;

const char* const seriesVariable = "LIMN_TEST_MARKED_SERIES";
const char* const outVariable = "LIMN_TEST_MARKED_OUT";

using MarkedWindow = test::WindowHarness;

// The window's part, in a process of its own whose home and temporary folders are searched afterwards.
TEST_F(MarkedWindow, DISABLED_writesAllItCan) {
  const auto out = [](const char* name) {
    return QString::fromStdString((fs::path(std::getenv(outVariable)) / name).string());
  };
  window = std::make_unique<MainWindow>(); // on the folders of the user that the variables say
  window->resize(900, 640);
  window->show();
  ASSERT_TRUE(test::waitUntilExposed(*window));
  window->keepSessions();
  ASSERT_TRUE(open(QString::fromLocal8Bit(std::getenv(seriesVariable))));
  ASSERT_NE(scene().volume, nullptr) << messages().sentence().toStdString();
  std::size_t ignored = 0;
  EXPECT_TRUE(test::marksIn(window->windowTitle().toStdString(), ignored).empty()) << "nobody was asked yet";
  action(QStringLiteral("Show the patient's &name in the title bar"))->trigger();
  EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("ZEBEDEE"))); // it does know
  action(QStringLiteral("Show the patient's &name in the title bar"))->trigger();
  EXPECT_TRUE(test::marksIn(window->windowTitle().toStdString(), ignored).empty())
      << window->windowTitle().toStdString();
  ASSERT_TRUE(rest());
  emit window->findChild<PresetBrowser*>()->saveRequested();
  auto* dialog = window->findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  dialog->setTextValue(QStringLiteral("Marked"));
  dialog->accept();
  saving().writeScene(out("scene.json"));
  saving().writeSession(out("session.json"));
  for (const char* picture : {"window.png", "window.tif", "window.exr", "window.jpg"})
    saving().writePicture(out(picture));
  window->grab().save(out("grabbed.png"));
  dragAPoint();
  // The session that a dead window leaves, and one that is closed with changes.
  window->openSource(QStringLiteral("phantom:8"));
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  ASSERT_TRUE(open(out("session.json")));
  ASSERT_NE(scene().volume, nullptr) << messages().sentence().toStdString();
  EXPECT_EQ(scene().volume->info().patient.id, "PID774411"); // the session found its volume
  dragAPoint();
  ASSERT_TRUE(open(out("window.png")));
  EXPECT_EQ(scene().volume->info().patient.id, "PID774411") << messages().sentence().toStdString();
  dragAPoint();
  for (QAction* recent : window->findChild<QMenu*>(QStringLiteral("recentSources"))->actions())
    EXPECT_TRUE(
        test::marksIn(recent->text().toStdString() + recent->toolTip().toStdString(), ignored).empty())
        << recent->text().toStdString();
  std::_Exit(HasFailure() ? 1 : 0); // dies without closing
}

class Privacy : public testing::Test {
protected:
  fs::path root() const { return folder.path() / "written"; }

  // What Mesa keeps of shaders, which takes long to compile: searched as well, and kept for the next patient.
  static const fs::path& shaders() {
    static const test::TemporaryFolder kept;
    return kept.path();
  }

  // Runs a program with home, temporary files, output and errors below root(); returns its exit status.
  int run(const std::string& program, const std::string& arguments) {
    for (const char* name : {"home", "config", "data", "cache", "state", "tmp", "out", "log"})
      fs::create_directories(root() / name);
    const std::string at = root().string();
    const std::string log = at + "/log/" + std::to_string(m_runs++);
    const std::string command =
        "cd '" + at + "/out' && env HOME='" + at + "/home' XDG_CONFIG_HOME='" + at +
        "/config' XDG_DATA_HOME='" + at + "/data' XDG_CACHE_HOME='" + at + "/cache' XDG_STATE_HOME='" + at +
        "/state' TMPDIR='" + at + "/tmp' MESA_SHADER_CACHE_DIR='" + shaders().string() + "' " +
        seriesVariable + "='" + series.string() + "' " + outVariable + "='" + at + "/out' '" + program +
        "' " + arguments + " >'" + log + ".out' 2>'" + log + ".err' </dev/null";
    const int raw = std::system(command.c_str());
    return WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
  }

  int limn(const std::string& arguments) { return run(test::programPath(), arguments); }

  std::string lastWords() const {
    return test::bytesOfFile(root() / "log" / (std::to_string(m_runs - 1) + ".err")) +
           test::bytesOfFile(root() / "log" / (std::to_string(m_runs - 1) + ".out"));
  }

  // Everything that there is to do with the series.
  void doEverything() {
    const std::string at = std::string("'").append(series.string()).append("'");
    for (const char* command :
         {"info", "info --json", "info --system", "effects --size 64x64", "effects --json --size 64x64"})
      EXPECT_EQ(limn(command + (" " + at)), 0) << command << ": " << lastWords();
    for (const char* output : {"a.png", "a.tif", "a.exr", "a.jpg", "c.png --model compare",
                               "r.png --engine reference", "s.png --samples-spent samples.png"})
      EXPECT_EQ(limn("render " + at + " --size 64x48 -o " + output), 0) << output << ": " << lastWords();
    for (const char* output : {"f.png", "f.tif", "f.exr", "f.pdf"})
      EXPECT_EQ(limn("figure " + at + " " + at + " --size 200 --dpi 72 --text 4 -o " + output), 0)
          << output << ": " << lastWords();
    EXPECT_EQ(limn("dicom " + at + " --size 32x32 -o objects"), 0) << lastWords();
    EXPECT_EQ(limn("dicom " + at + " --size 32x32 --anonymous -o nobodys"), 0) << lastWords();
    EXPECT_EQ(limn("render objects/look.dcm --volume " + at + " --size 64x48 -o looked.png"), 0)
        << lastWords();
    EXPECT_EQ(limn("turntable " + at + " --frames 2 --size 32x32 -o turn"), 0) << lastWords();
    for (const char* output : {"s.stl", "s.ply", "s.obj"})
      EXPECT_EQ(limn("surface " + at + " --value 100 -o " + output), 0) << output << ": " << lastWords();
    EXPECT_EQ(limn("accuracy " + at + " --quick --size 32x32 -o report"), 0) << lastWords();
    EXPECT_EQ(limn("render " + at + " -o no/such/folder.png"), 1) << lastWords();
    EXPECT_EQ(limn("render " + at + " --preset none -o a.png"), 2) << lastWords();
    EXPECT_EQ(limn(at + " --screenshot shown.png"), 0) << lastWords();
    const std::string self = fs::read_symlink("/proc/self/exe").string();
    EXPECT_EQ(run(self, "--gtest_also_run_disabled_tests --gtest_filter='MarkedWindow.*'"), 0) << lastWords();
    EXPECT_EQ(limn("render session.json --volume " + at + " --size 64x48 -o t.png"), 0) << lastWords();
  }

  // An archive files these two by their patient; without, the UIDs stay by which the look finds its images.
  bool mayCarry(const fs::path& file, const std::string& mark) const {
    if (file == root() / "out/objects/look.dcm" || file == root() / "out/objects/picture.dcm")
      return true;
    const bool isAnonymous =
        file == root() / "out/nobodys/look.dcm" || file == root() / "out/nobodys/picture.dcm";
    return isAnonymous && mark == "1.2.826.99";
  }

  // Searches every file below root() but those that `isExempt`, and all that is kept of shaders.
  void expectNoMarks(const std::function<bool(const fs::path&)>& isExempt) {
    std::size_t files = 0;
    std::size_t bytes = 0;
    std::size_t searched = 0;
    for (const fs::path& place : {root(), shaders()})
      for (const auto& entry : fs::recursive_directory_iterator(place)) {
        for (const std::string& mark : test::marksIn(entry.path().filename().string(), searched))
          ADD_FAILURE() << mark << " in the name of " << entry.path();
        if (!entry.is_regular_file() || isExempt(entry.path()))
          continue;
        ++files;
        bytes += entry.file_size();
        for (const std::string& mark : test::marksIn(test::bytesOfFile(entry.path()), searched))
          if (!mayCarry(entry.path(), mark))
            ADD_FAILURE() << mark << " in " << entry.path();
      }
    for (const char* written :
         {"config/limn/settings.json", "data/limn/limn/presets/Marked.json", "out/session.json",
          "out/scene.json", "out/window.exr", "out/report/accuracy.html", "out/shown.png", "out/f.pdf",
          "out/turn/frame-0002.png", "out/objects/look.dcm", "out/nobodys/picture.dcm", "out/looked.png"})
      EXPECT_TRUE(fs::exists(root() / written)) << written;
    EXPECT_TRUE(fs::exists(root() / "data/limn/limn/sessions/windows"));
    EXPECT_FALSE(fs::is_empty(root() / "data/limn/limn/sessions/closed"));
    std::printf("%zu marks searched in %zu files, %zu bytes, %zu with what is packed in them\n",
                test::patientMarks().size(), files, bytes, searched);
  }

  test::TemporaryFolder folder;
  fs::path series;

private:
  int m_runs = 0;
};

TEST_F(Privacy, nothingThatIsWrittenNamesThePatient) {
  series = folder.path() / "data" / "head";
  test::writeMarkedSeries(series);
  doEverything();
  expectNoMarks([](const fs::path&) { return false; });
}

// Where the data lie has to be remembered, or nothing could be opened again. It is in two places that only
// this user can read, and there in nothing but the path.
TEST_F(Privacy, aFolderNamedAfterThePatientIsNamedOnlyWhereItIsFoundAgain) {
  series = folder.path() / "ZEBEDEE QUILLON" / "19870615";
  test::writeMarkedSeries(series);
  doEverything();
  const fs::path settings = root() / "config/limn/settings.json";
  const fs::path sessions = root() / "data/limn/limn/sessions";
  const auto isAutosave = [&](const fs::path& file) {
    return file.string().starts_with(sessions.string()) && file.extension() == ".json";
  };
  expectNoMarks([&](const fs::path& file) { return file == settings || isAutosave(file); });
  std::size_t ignored = 0;
  for (const auto& [key, value] : parseSettings(test::bytesOfFile(settings), "settings"))
    EXPECT_TRUE(key.ends_with("/path") || test::marksIn(key + value, ignored).empty())
        << key << ": " << value;
  for (const auto& entry : fs::recursive_directory_iterator(sessions))
    if (isAutosave(entry.path())) {
      SessionDocument session = readSessionFile(entry.path());
      session.scene.volume.clear();
      EXPECT_TRUE(test::marksIn(sessionToJson(session), ignored).empty()) << entry.path();
    }
  constexpr fs::perms others = fs::perms::group_all | fs::perms::others_all;
  for (const fs::path& folderOfUser : {settings.parent_path(), sessions})
    EXPECT_EQ(fs::status(folderOfUser).permissions() & others, fs::perms::none) << folderOfUser;
}

std::string compressed(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
           text.size());
  packed.resize(size);
  return packed;
}

// A search that finds nothing anywhere would pass.
TEST(PrivacySearch, findsMarksHoweverTheyAreWritten) {
  std::size_t searched = 0;
  const std::string text = "before Zebedee^Q after, at some length so that it is worth a stream";
  std::string wide;
  for (const char c : text)
    wide += {c, '\0'};
  const std::string base64 = QByteArray::fromStdString("junk" + compressed(text)).toBase64().toStdString();
  for (const std::string& hidden :
       {text, wide, "\0" + wide, "zTXt" + compressed(text) + "tail", "data:," + base64, compressed(base64)})
    EXPECT_EQ(test::marksIn(hidden, searched), std::set<std::string>{"ZEBEDEE"});
  EXPECT_TRUE(test::marksIn("nobody " + compressed("nobody at all, at some length"), searched).empty());
}

} // namespace
} // namespace limn
