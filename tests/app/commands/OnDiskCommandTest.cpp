// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes that stay on disk, in every command that draws.
#include "scene/basics/MemoryBudget.h"
#include "support/LargeSeries.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limn {
namespace {

using test::Outcome;

const std::string enough = std::to_string(MemoryBudget::leastMbFor(test::largeBytes));

class OnDisk : public testing::Test {
protected:
  OnDisk() { test::writeLargeVolume(in("large.mha")); }

  std::filesystem::path in(const std::string& name) const { return folder.path() / name; }
  std::string quoted(const std::string& name) const { return "'" + in(name).string() + "'"; }

  /// The command on the volume, in little memory unless more is given.
  Outcome run(const std::string& command, const std::string& arguments, const std::string& memoryMb = "64") {
    return test::runProgram(folder.path(), command + " " + quoted("large.mha") + " --memory " + memoryMb +
                                               " --quiet " + arguments);
  }

  // Floats, row by row: the file itself says when it was written.
  std::vector<float> pixelsOf(const std::string& name) const {
    const auto input = OIIO::ImageInput::open(in(name).string());
    if (!input)
      return {};
    std::vector<float> pixels(input->spec().image_pixels() * 4);
    input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, pixels.data());
    return pixels;
  }

  // One sentence with the way out.
  static void expectRefused(const Outcome& outcome, const std::string& engine) {
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.err,
              "limn: OpenGL would copy the volume of 256 x 256 x 170 voxels, which stays on disk, "
              "into memory; " +
                  engine + "give it memory with --memory " + enough + ".\n");
  }

  test::TemporaryFolder folder;
};

const std::string orCpu = "draw it with --engine cpu, or ";

TEST_F(OnDisk, openGlIsRefusedWithTheMemoryThatWouldDo) {
  for (const std::string engine : {"gl", "slices", "slices-back-to-front"})
    expectRefused(run("render", "--size 32x24 --engine " + engine + " -o " + quoted("a.png")), orCpu);
  expectRefused(run("render", "--size 32x24 --model compare --engine gl -o " + quoted("a.png")), orCpu);
  expectRefused(run("turntable", "--size 32x24 --frames 2 --engine gl -o " + quoted("frames")), orCpu);
  expectRefused(run("figure", "--engine gl -o " + quoted("a.png")), orCpu);
  expectRefused(run("bench", "--size 32x24 --frames 1 --engine gl,slices"), orCpu);
  expectRefused(run("effects", "--shader"), "");
  EXPECT_FALSE(std::filesystem::exists(in("a.png")));
  const Outcome inMemory = run("render", "--size 32x24 --engine gl -o " + quoted("a.png"), enough);
  EXPECT_EQ(inMemory.status, 0) << inMemory.err;
}

TEST_F(OnDisk, leftOpenTheCpuEngineDrawsAndSaysSo) {
  ASSERT_EQ(run("render", "--size 32x24 --engine cpu -o " + quoted("cpu.exr")).status, 0);
  const Outcome open = test::runProgram(
      folder.path(), "render " + quoted("large.mha") + " --memory 64 --size 32x24 -o " + quoted("auto.exr"));
  EXPECT_EQ(open.status, 0) << open.err;
  EXPECT_NE(
      open.err.find("does not lie in memory, from where the graphics driver would copy it. The CPU engine "
                    "drew the picture instead."),
      std::string::npos)
      << open.err;
  const std::vector<float> byCpu = pixelsOf("cpu.exr");
  EXPECT_EQ(byCpu.size(), 32u * 24 * 4);
  EXPECT_TRUE(pixelsOf("auto.exr") == byCpu);
  EXPECT_EQ(run("turntable", "--size 32x24 --frames 2 -o " + quoted("frames")).status, 0);
  // Beside one that lies in memory.
  const Outcome both = test::runProgram(folder.path(), "figure phantom:8 " + quoted("large.mha") +
                                                           " --memory 64 --size 4cm --dpi 72 --quiet -o " +
                                                           quoted("both.png"));
  EXPECT_EQ(both.status, 0) << both.err;
}

TEST_F(OnDisk, measurementsAreOfTheCpuEngine) {
  const Outcome accuracy = run("accuracy", "--quick --size 16x12 -o " + quoted("report"));
  ASSERT_EQ(accuracy.status, 0) << accuracy.err;
  const auto report = nlohmann::json::parse(test::bytesOfFile(in("report/accuracy.json")));
  EXPECT_TRUE(report["renderer"].get<std::string>().starts_with("CPU engine")) << report["renderer"];
  const Outcome effects = run("effects", "--size 16x12 --frames 5 --json");
  ASSERT_EQ(effects.status, 0) << effects.err;
  EXPECT_NE(effects.out.find("CPU engine"), std::string::npos) << effects.out;
  const Outcome bench = run("bench", "--size 16x12 --frames 1 --engine gl,cpu --json");
  ASSERT_EQ(bench.status, 0) << bench.err;
  const auto rows = nlohmann::json::parse(bench.out)["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NE(rows[0]["missing"].get<std::string>().find("--engine cpu"), std::string::npos) << rows[0];
  EXPECT_GT(rows[1]["ms"]["median"], 0.0);
}

TEST_F(OnDisk, slicesMakeThePictureThatTheyMakeInMemory) {
  test::writeLargeSeries(in("series"));
  test::writeLargeSeries(in("sheared"), {.shearMm = 0.5});
  ASSERT_TRUE(test::writeLargeStack(in("stack")));
  for (const std::string source : {"series", "sheared", "stack"}) {
    const auto picture = [&](const std::string& memoryMb) {
      const Outcome outcome = test::runProgram(
          folder.path(), "render " + quoted(source) + " --spacing 1,1,1 --engine cpu --size 96x72 --memory " +
                             memoryMb + " -o " + quoted("picture.exr"));
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(outcome.err.find("kept on disk") != std::string::npos, memoryMb == "64") << outcome.err;
      return pixelsOf("picture.exr");
    };
    const std::vector<float> inMemory = picture("1000");
    EXPECT_EQ(inMemory.size(), 96u * 72 * 4);
    EXPECT_TRUE(picture("64") == inMemory) << source;
  }
}

} // namespace
} // namespace limn
