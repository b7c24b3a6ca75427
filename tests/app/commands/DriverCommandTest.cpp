// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/ProgramRun.h"
#include "support/Sanitizers.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

// The shipped binary with drivers that fail. Mesa can be told to be older than it is, and a process to have
// less memory; other drivers pass by.
namespace limn {
namespace {

using test::Outcome;

class DriverCommands : public testing::Test {
protected:
  void SetUp() override {
    static const bool isMesa = run("", "info --system").out.find("Mesa") != std::string::npos;
    if (!isMesa)
      GTEST_SKIP() << "only Mesa can be told to refuse shaders";
  }

  Outcome run(const std::string& before, const std::string& arguments) {
    return test::runProgram(folder.path(), arguments, before);
  }

  std::filesystem::path file(const std::string& name) const { return folder.path() / name; }
  std::string picture() const { return file("picture.png").string(); }

  // Puts other times in the place of those of the one trial that there was.
  void rememberTrial(const std::string& times) const {
    const std::filesystem::path settings = file(".config") / "limn" / "settings.json";
    std::string text = test::bytesOfFile(settings);
    ASSERT_NE(text.find("\"trial/"), std::string::npos) << text;
    const std::size_t key = text.find("\"trial/");
    const std::size_t from = text.find("\": \"", key) + 4;
    text.replace(from, text.find('"', from) - from, times);
    test::writeBytes(settings, text);
  }

  test::TemporaryFolder folder;
};

constexpr const char* oldShaders = "MESA_GL_VERSION_OVERRIDE=3.0 MESA_GLSL_VERSION_OVERRIDE=120";
const std::string scene = "render phantom:8 --size 32x32 --quiet ";

TEST_F(DriverCommands, aDriverThatRefusesTheShadersEndsWithOneSentenceAndStatus4) {
  const Outcome outcome = run(oldShaders, scene + "--engine gl -o " + picture());
  EXPECT_EQ(outcome.status, 4) << outcome.err;
  EXPECT_NE(outcome.err.find("refused a shader"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(picture()));
}

TEST_F(DriverCommands, theCpuEngineDrawsWhereTheEngineIsLeftOpen) {
  const Outcome outcome = run(oldShaders, scene + "-o " + picture());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(run("", scene + "--engine cpu -o " + file("expected.png").string()).status, 0);
  EXPECT_EQ(test::bytesOfFile(picture()), test::bytesOfFile(file("expected.png")));
}

TEST_F(DriverCommands, whatTheDriverWroteStandsInTheSystemReport) {
  const Outcome healthy = run("", "info --system");
  EXPECT_EQ(healthy.status, 0);
  EXPECT_NE(healthy.out.find("works in all four models"), std::string::npos) << healthy.out;
  const Outcome broken = run(oldShaders, "info --system");
  EXPECT_EQ(broken.status, 0);
  EXPECT_NE(broken.out.find("GLSL 1.30"), std::string::npos) << broken.out;
}

TEST_F(DriverCommands, aVolumeThatMayTakeLessIsShownWithFewerVoxelsAndSaysSo) {
  const Outcome outcome = run("", "render phantom:2 --size 32x32 --engine gl --texture-mb 1 -o " + picture());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("too large for the graphics memory that it may take"), std::string::npos)
      << outcome.err;
}

TEST_F(DriverCommands, whatATrialHasShownIsRememberedAndTaken) {
  const Outcome first = run("", "render phantom:8 --size 32x32 -o " + picture());
  EXPECT_EQ(first.status, 0) << first.err;
  rememberTrial("50.00 1.00");
  EXPECT_NE(run("", "render phantom:8 --size 32x32 -o " + picture()).err.find("CPU engine"),
            std::string::npos);
  EXPECT_NE(run("", "info --system").out.find("draws       processor: In a trial"), std::string::npos);
  rememberTrial("1.00 50.00");
  EXPECT_EQ(run("", "render phantom:8 --size 32x32 -o " + picture()).err.find("CPU engine"),
            std::string::npos);
  EXPECT_NE(run("", "info --system").out.find("draws       OpenGL: In a trial"), std::string::npos);
}

TEST_F(DriverCommands, aVolumeThatMayTakeLessGoesToTheProcessorWhereTheEngineIsLeftOpen) {
  ASSERT_EQ(run("", scene + "-o " + picture()).status, 0);
  rememberTrial("1.00 50.00");
  const Outcome outcome = run("", "render phantom:2 --size 32x32 --texture-mb 1 -o " + picture());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("too large for the graphics memory that it may take. The CPU engine drew"),
            std::string::npos)
      << outcome.err;
  ASSERT_EQ(run("", "render phantom:2 --size 32x32 --engine cpu -o " + file("cpu.png").string()).status, 0);
  EXPECT_EQ(test::bytesOfFile(picture()), test::bytesOfFile(file("cpu.png")));
}

TEST_F(DriverCommands, withoutOpenGlEverythingThatIsAskedForIsThere) {
  const Outcome outcome = run("__EGL_VENDOR_LIBRARY_DIRS=/nonexistent",
                              "render phantom:8 --size 32x32 --figures --samples-spent " +
                                  file("samples.png").string() + " -o " + picture());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("contrast"), std::string::npos) << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(file("samples.png")));
  const Outcome info = run("__EGL_VENDOR_LIBRARY_DIRS=/nonexistent", "info --system");
  EXPECT_EQ(info.status, 0);
  EXPECT_NE(info.out.find("draws       processor: There is no OpenGL."), std::string::npos) << info.out;
}

TEST_F(DriverCommands, withoutOpenGlTheBenchMeasuresTheProcessorAndSaysWhatIsMissing) {
  const Outcome outcome = run("__EGL_VENDOR_LIBRARY_DIRS=/nonexistent",
                              "bench phantom:8 --size 24x16 --frames 1 --engine gl,slices --json --quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json rows = nlohmann::json::parse(outcome.out)["rows"];
  ASSERT_EQ(rows.size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(rows[i]["program"], i == 0 ? "limn-gl" : "limn-slices");
    EXPECT_NE(rows[i]["missing"].get<std::string>().find("No OpenGL"), std::string::npos) << rows[i];
    EXPECT_FALSE(rows[i].contains("ms")) << rows[i];
  }
  EXPECT_EQ(rows[2]["program"], "limn-cpu");
  EXPECT_GT(rows[2]["ms"]["median"], 0.0);
}

TEST_F(DriverCommands, withoutOpenGlStabilityJudgesTheProcessorAndSaysWhatIsMissing) {
  const Outcome outcome = run("__EGL_VENDOR_LIBRARY_DIRS=/nonexistent",
                              "stability --fuzz 8 --quiet -o '" + file("report").string() + "'");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json report = nlohmann::json::parse(test::bytesOfFile(file("report/stability.json")));
  EXPECT_NE(report["renderer"].get<std::string>().find("CPU engine"), std::string::npos);
  EXPECT_NE(report["driver"].get<std::string>().find("No OpenGL"), std::string::npos);
  int byProcessor = 0;
  for (const nlohmann::json& row : report["cases"]) {
    const std::string engine = row["engine"];
    if (engine == "gl" || engine == "glsl" || engine == "slices") {
      EXPECT_EQ(row["verdict"], "n/a") << row;
    }
    byProcessor += engine == "cpu" && row["verdict"] == "pass" ? 1 : 0;
  }
  EXPECT_GT(byProcessor, 100);
  EXPECT_EQ(report["fuzz"]["seeds"], 8);
}

TEST_F(DriverCommands, aLimitThatAnEngineDoesNotKnowIsRefused) {
  const Outcome outcome =
      run("", "render phantom:8 --size 32x32 --engine slices --texture-mb 1 -o " + picture());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--texture-mb"), std::string::npos) << outcome.err;
}

// A picture of 8000 x 8000 floats takes 1 GB; the process may have as much in all.
TEST_F(DriverCommands, aDriverWithoutMemoryEndsInASentence) {
  if (test::isSanitised)
    GTEST_SKIP() << "a sanitizer maps terabytes of its own, so that no limit of addresses can be set";
  const Outcome outcome =
      run("ulimit -v 1000000;", "render phantom:8 --size 8000x8000 --quiet --engine gl -o " + picture());
  EXPECT_TRUE(outcome.status == 4 || outcome.status == 1) << outcome.status << ": " << outcome.err;
  EXPECT_NE(outcome.err.find("limn: "), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

// Below the least of these limits the program's own libraries find no room, above the largest all goes well.
TEST(RefusedMemory, endsInASentenceWhereverItRunsOut) {
  if (test::isSanitised)
    GTEST_SKIP() << "a sanitizer maps terabytes of its own, so that no limit of addresses can be set";
  const test::TemporaryFolder folder;
  const std::string picture = (folder.path() / "picture.tif").string(); // by libraries that take the most
  const std::filesystem::path volume = folder.path() / "volume.nrrd";
  std::ofstream(volume, std::ios::binary) << "NRRD0004\ntype: short\ndimension: 3\nsizes: 256 256 400\n"
                                             "endian: little\nencoding: raw\n\n~~";
  std::filesystem::resize_file(volume,
                               2 * 256 * 256 * 400 + 100); // and zeros, which take no room on the disk
  int refused = 0;
  for (int mb = 200; mb <= 760; mb += 40) {
    const std::string limit = "ulimit -v " + std::to_string(1000 * mb) + ";";
    for (const std::string& command :
         {"info --quiet " + volume.string(),
          "render " + volume.string() + " --size 64x64 --quiet --engine cpu -o " + picture}) {
      const Outcome outcome = test::runProgram(folder.path(), command, limit);
      if (outcome.status == 0)
        continue;
      ++refused;
      EXPECT_TRUE(outcome.status == 1 || outcome.status == 3) << mb << ": " << outcome.status;
      EXPECT_NE(outcome.err.find("not enough memory"), std::string::npos) << mb << ": " << outcome.err;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << mb << ": " << outcome.err;
    }
  }
  EXPECT_GT(refused, 3);
}

} // namespace
} // namespace limn
