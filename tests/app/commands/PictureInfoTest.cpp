// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ImageFile.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"
#include "support/TestData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

// What `limn info` tells of a picture that Limn saved.
namespace limn {
namespace {

using test::Outcome;

class PictureInfo : public testing::Test {
protected:
  Outcome run(const std::string& arguments) { return test::runProgram(folder.path(), arguments); }

  std::filesystem::path file(const std::string& name) const { return folder.path() / name; }

  test::TemporaryFolder folder;
};

// The volume may be elsewhere.
TEST_F(PictureInfo, tellsWhatAPictureCarriesWithoutItsVolume) {
  const std::string picture = file("a.png").string();
  const std::string render =
      "render phantom:8 --size 32x24 --preset \"CT bone\" --light headlight --view left ";
  ASSERT_EQ(run(render + "--model robust --tolerance 4 -o " + picture).status, 0);
  nlohmann::json carried = nlohmann::json::parse(readImageDescription(picture));
  const std::string statement = carried["accuracy"]["statement"].get<std::string>();
  carried["volume"] = "elsewhere.nii.gz";
  writeBytes(picture, readBytes(picture), carried.dump());
  const Outcome told = run("info " + picture);
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(told.out, "picture     32 x 24 pixels\n"
                      "curve       preset \"CT bone\"\n"
                      "model       robust\n"
                      "light       headlight\n"
                      "view        from left\n"
                      "accuracy    " +
                          statement + "\nvolume      elsewhere.nii.gz\n");
  EXPECT_NE(told.err.find("The volume elsewhere.nii.gz of this picture is not where"), std::string::npos)
      << told.err;
  EXPECT_EQ(std::count(told.err.begin(), told.err.end(), '\n'), 1) << told.err;
  EXPECT_EQ(run("info --quiet " + picture).err, "");
  const nlohmann::json alone = nlohmann::json::parse(run("info --json " + picture).out);
  EXPECT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone["picture"]["size"], nlohmann::json::array({32, 24}));
  EXPECT_EQ(alone["picture"]["models"], nlohmann::json::array({"robust"}));
  EXPECT_EQ(alone["picture"]["volumes"], nlohmann::json::array({"elsewhere.nii.gz"}));
  EXPECT_EQ(
      alone["picture"]["accuracy"],
      nlohmann::json({{"statement", statement}, {"within_levels", carried["accuracy"]["within_levels"]}}));
  const Outcome both = run("info --volume phantom:8 " + picture);
  EXPECT_TRUE(both.out.starts_with(told.out)) << both.out << both.err;
  EXPECT_NE(both.out.find("dimensions  24 x 29 x 34 voxels"), std::string::npos) << both.out;
  EXPECT_EQ(nlohmann::json::parse(run("info --json --volume phantom:8 " + picture).out)["picture"],
            alone["picture"]);
  ASSERT_EQ(run(render + "--model compare --step 1 -o " + picture).status, 0);
  EXPECT_EQ(nlohmann::json::parse(run("info --json " + picture).out)["picture"]["models"].size(), 2u);
}

TEST_F(PictureInfo, tellsWhatAPictureHides) {
  const std::string picture = file("a.png").string();
  ASSERT_EQ(run("render phantom:8 --size 32x24 --step 1 -o " + picture).status, 0);
  EXPECT_EQ(run("info --quiet " + picture).out.find("hidden "), std::string::npos);
  nlohmann::json carried = nlohmann::json::parse(readImageDescription(picture));
  const nlohmann::json piece = {{"seed_mm", {0.0, 0.0, 0.0}}, {"range", {0.0, 100.0}}};
  carried["keep"] = {"body", {{"piece", piece}}};
  carried["crop"] = {{"lower", {0.0, 0.0, 0.0}}, {"upper", {1.0, 1.0, 0.5}}};
  writeBytes(picture, readBytes(picture), carried.dump());
  const std::string told = run("info --quiet " + picture).out;
  EXPECT_NE(
      told.find("\nhidden      the table (body only), what 1 cut takes away, what lies outside the crop\n"),
      std::string::npos)
      << told;
  EXPECT_EQ(nlohmann::json::parse(run("info --json " + picture).out)["picture"]["hidden"].size(), 3u);
}

// As if --volume said where, and without its labels, which may be elsewhere.
TEST_F(PictureInfo, tellsOfTheVolumeThatAPictureNamesWhereItIsFound) {
  const std::string picture = file("a.png").string();
  ASSERT_EQ(run("render phantom:8 --size 32x24 --step 1 -o " + picture).status, 0);
  const Outcome told = run("info " + picture);
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(told.out, run("info --volume phantom:8 " + picture).out);
  EXPECT_NE(told.out.find("dimensions  24 x 29 x 34 voxels"), std::string::npos) << told.out;
  const nlohmann::json facts = nlohmann::json::parse(run("info --json " + picture).out);
  EXPECT_EQ(facts, nlohmann::json::parse(run("info --json --volume phantom:8 " + picture).out));
  EXPECT_GT(facts.size(), 1u);
  nlohmann::json carried = nlohmann::json::parse(readImageDescription(picture));
  carried["keep"] = {{"labels", "elsewhere.nrrd"}};
  writeBytes(picture, readBytes(picture), carried.dump());
  EXPECT_EQ(run("info " + picture).out, told.out);
}

TEST_F(PictureInfo, aPictureOfTheSampleHeadIsToldAsOne) {
  const std::filesystem::path head = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  if (!std::filesystem::exists(head))
    GTEST_SKIP() << "the head of invesalius-examples is not installed";
  const std::string picture = file("a.png").string();
  ASSERT_EQ(run("render phantom:8 --size 32x24 --step 1 -o " + picture).status, 0);
  nlohmann::json carried = nlohmann::json::parse(readImageDescription(picture));
  carried["volume"] = head.filename().string();
  writeBytes(picture, readBytes(picture), carried.dump());
  EXPECT_NE(run("info --quiet " + picture).out.find("volume      Cranium.inv3 (the sample head)\n"),
            std::string::npos);
}

} // namespace
} // namespace limn
