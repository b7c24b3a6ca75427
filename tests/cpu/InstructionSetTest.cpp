// SPDX-License-Identifier: GPL-3.0-or-later
// The built program with each instruction set that this processor has: the choice is made once in a process.
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace limn {
namespace {

const std::string render = "render phantom:4 --model robust --size 96x80 --engine cpu -o ";

std::vector<float> pixelsOf(const std::filesystem::path& file) {
  const auto input = OIIO::ImageInput::open(file.string());
  EXPECT_TRUE(input) << file;
  const OIIO::ImageSpec& spec = input->spec();
  std::vector<float> pixels(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
  EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
  return pixels;
}

TEST(InstructionSet, everyLevelDrawsTheSamePictureWithinATwentiethOfALevel) {
  const test::TemporaryFolder home;
  std::vector<float> first;
  int levels = 0;
  for (const auto& [word, target] : {std::pair("sse4", HWY_SSE4), std::pair("avx2", HWY_AVX2),
                                     std::pair("avx512", HWY_AVX3), std::pair("neon", HWY_NEON)}) {
    if ((hwy::SupportedTargets() & target) == 0) {
      std::cout << "this processor has no " << word << "\n";
      continue;
    }
    const std::filesystem::path out = home.path() / (std::string(word) + ".exr");
    const test::Outcome run = test::runProgram(home.path(), render + "'" + out.string() + "'",
                                               std::string("LIMN_CPU_TARGET=") + word);
    ASSERT_EQ(run.status, 0) << run.err;
    const std::vector<float> pixels = pixelsOf(out);
    if (first.empty())
      first = pixels;
    ASSERT_EQ(pixels.size(), first.size());
    float largest = 0.0f;
    for (std::size_t i = 0; i < pixels.size(); ++i)
      largest = std::max(largest, 255.0f * std::abs(pixels[i] - first[i]));
    std::cout << word << ": at most " << largest << " levels from the first\n";
    EXPECT_LE(largest, 0.05f) << word;
    ++levels;
  }
  EXPECT_GE(levels, 1);
}

TEST(InstructionSet, anUnknownLevelIsRefusedInASentence) {
  const test::TemporaryFolder home;
  const test::Outcome run = test::runProgram(
      home.path(), render + "'" + (home.path() / "a.png").string() + "'", "LIMN_CPU_TARGET=mmx");
  EXPECT_NE(run.status, 0);
  const std::string words = HWY_ARCH_X86 ? "avx512, avx2, sse4" : "neon";
  EXPECT_NE(run.err.find("LIMN_CPU_TARGET is \"mmx\"; use one of " + words + ", or unset it"),
            std::string::npos)
      << run.err;
}

} // namespace
} // namespace limn
