// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ImageFile.h"
#include "io/dicom/SyntheticSeries.h"
#include "support/EffectNames.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"
#include "support/TestData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

// The shipped binary, called as a user calls it.
namespace limn {
namespace {

using test::Outcome;

class CommandLine : public testing::Test {
protected:
  Outcome run(const std::string& arguments) { return test::runProgram(folder.path(), arguments); }

  std::filesystem::path file(const std::string& name) const { return folder.path() / name; }

  test::TemporaryFolder folder;
};

TEST_F(CommandLine, helpOfEveryCommandShowsAnExample) {
  for (const char* command : {"", "info", "render", "dicom", "jobs", "effects", "presets", "presets show",
                              "presets convert", "bench", "accuracy"}) {
    const Outcome outcome = run(std::string(command) + " --help");
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_NE(outcome.out.find("Example: limn"), std::string::npos) << outcome.out;
  }
}

TEST_F(CommandLine, infoPrintsTheGridOfThePhantomAsOneJsonObject) {
  const Outcome outcome = run("info phantom:8 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  // 192 × 232 × 272 mm at 8 mm; the origin is the centre of the first voxel of a centred box.
  EXPECT_EQ(json["dims"], nlohmann::json::array({24, 29, 34}));
  EXPECT_EQ(json["spacing_mm"], nlohmann::json::array({8.0, 8.0, 8.0}));
  EXPECT_EQ(json["origin_mm"], nlohmann::json::array({-92.0, -112.0, -132.0}));
  EXPECT_EQ(json["direction"], nlohmann::json::array({1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(json["type"], "int16");
  EXPECT_EQ(json["range"][0], -1000.0);
  EXPECT_GT(json["gradient"]["max"].get<double>(), json["gradient"]["p99_5"].get<double>());
}

TEST_F(CommandLine, aToleranceIsKeptToldAndReproducedByItsPicture) {
  const std::string first = file("within.png").string();
  const std::string second = file("again.png").string();
  const std::string samples = file("samples.png").string();
  const Outcome outcome =
      run("render phantom:6 --size 48x48 --tolerance 1 --json --samples-spent " + samples + " -o " + first);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("estimated within"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("Samples spent"), std::string::npos) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(samples));
  const nlohmann::json told = nlohmann::json::parse(outcome.out);
  EXPECT_LE(told["accuracy"]["within_levels"].get<double>(), 2.0) << "of 2995 pixels the farthest off";
  EXPECT_EQ(told["notes"].dump().find("farther off than the tolerance of 1 level") != std::string::npos,
            told["accuracy"]["within_levels"].get<double>() > 1.0)
      << outcome.out;
  const std::string statement = told["accuracy"]["statement"].get<std::string>();
  EXPECT_NE(outcome.err.find(statement), std::string::npos) << outcome.err;
  EXPECT_NE(readImageDescription(first).find(statement), std::string::npos);
  ASSERT_EQ(run("render " + first + " -o " + second).status, 0);
  EXPECT_EQ(test::bytesOfFile(first), test::bytesOfFile(second));
  EXPECT_EQ(run("render phantom:6 --tolerance 1 --step 0.5 -o x.png").status, 2);
}

TEST_F(CommandLine, accuracyMeasuresTheToleranceThatIsAskedFor) {
  const std::string quick = "accuracy phantom:16 --quick --size 16x12 --quiet -o " + file("report").string();
  const Outcome outcome = run(quick + " --tolerance 3");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("error-controlled, within 3 levels"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("error-controlled, within 2 levels"), std::string::npos) << outcome.out;
  const Outcome refused = run(quick + " --model physical --tolerance 3");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("leave out --tolerance"), std::string::npos) << refused.err;
}

TEST_F(CommandLine, renderWritesThePictureAndThePictureOpensAsItsScene) {
  const std::string first = file("a.png").string();
  const std::string second = file("b.png").string();
  Outcome outcome = run("render phantom:6 --size 64x48 --model robust --step 1 -o " + first);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(readImageDescription(first).find("\"robust\""), std::string::npos);
  outcome = run("render " + first + " -o " + second);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(test::bytesOfFile(first), test::bytesOfFile(second));
}

TEST_F(CommandLine, infoSaysThatTheSlicesOfATiltedGantryWereResampled) {
  std::filesystem::create_directory(file("tilted"));
  for (int number = 1; number <= 3; ++number)
    test::slantingSlice(number).write(file("tilted") / std::to_string(number));
  const Outcome told = run("info " + file("tilted").string());
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_NE(told.out.find("warning     The slices slant by 20.6°, as of a tilted gantry, and were resampled "
                          "upright.\n"),
            std::string::npos)
      << told.out;
}

// So that the window opens as many of them.
TEST_F(CommandLine, aPictureTellsWhetherItIsOfOneModelOrOfTwo) {
  const std::string picture = file("models.png").string();
  for (const auto& [model, layout] : {std::pair("robust", "single"), std::pair("compare", "side_by_side")}) {
    const Outcome outcome =
        run(std::string("render phantom:8 --size 32x16 --step 1 --model ") + model + " -o " + picture);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(readImageDescription(picture))["shown"]["layout"], layout);
  }
}

// Each side in its size, unless something is asked for that is of one model.
TEST_F(CommandLine, aPictureOfTwoModelsIsDrawnAnewAsItWas) {
  const std::string first = file("two.png").string();
  const std::string second = file("again.png").string();
  ASSERT_EQ(run("render phantom:8 --size 48x20 --step 1 --model compare -o " + first).status, 0);
  Outcome outcome = run("render " + first + " -o " + second);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("48 x 20 pixels"), std::string::npos) << outcome.err;
  EXPECT_EQ(test::bytesOfFile(first), test::bytesOfFile(second));
  outcome = run("render " + first + " --model compare -o " + second);
  EXPECT_EQ(test::bytesOfFile(first), test::bytesOfFile(second)) << outcome.err;

  for (const char* ofOne : {" --model robust", " --light physical --size 24x20", " --figures"}) {
    outcome = run("render " + first + ofOne + " -o " + second);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("24 x 20 pixels"), std::string::npos) << ofOne << outcome.err;
    EXPECT_NE(outcome.err.find("shows two models, classic and enhanced; one was asked for"),
              std::string::npos)
        << ofOne << outcome.err;
  }

  nlohmann::json wiped = nlohmann::json::parse(readImageDescription(first));
  wiped["shown"]["layout"] = "wipe";
  wiped["shown"]["right"] = "robust";
  std::ofstream(file("wiped.limn.json")) << wiped;
  outcome = run("render " + file("wiped.limn.json").string() + " -o " + second);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("24 x 20 pixels"), std::string::npos) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(readImageDescription(second))["shown"], wiped["shown"]);
}

TEST_F(CommandLine, aPictureOfTwoLooksIsDrawnAnewWithBoth) {
  const std::string one = file("one.png").string(), both = file("both.png").string();
  const std::string again = file("again.png").string(), scene = file("both.limn.json").string();
  const std::string draw = "render phantom:8 --size 24x20 --step 1 --model classic --preset ";
  ASSERT_EQ(run(draw + "\"CT skin\" -o " + one).status, 0);
  const nlohmann::json left = nlohmann::json::parse(readImageDescription(one));
  ASSERT_EQ(run(draw + "\"CT bone\" -o " + one).status, 0);
  nlohmann::json right = nlohmann::json::parse(readImageDescription(one));
  right["shown"] = {{"layout", "side_by_side"}, {"left", "none"}, {"right", "classic"}};
  right["shown"]["look"] = {{"name", "CT skin"}, {"transfer_function", left["transfer_function"]}};
  std::ofstream(scene) << right;
  ASSERT_EQ(run("render " + scene + " --size 48x20 -o " + both).status, 0);
  Outcome outcome = run("render " + both + " -o " + again);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("48 x 20 pixels"), std::string::npos) << outcome.err;
  EXPECT_EQ(test::bytesOfFile(both), test::bytesOfFile(again));
  const std::string told = run("info " + both).out;
  EXPECT_NE(told.find("\ncurve       preset \"CT skin\", preset \"CT bone\"\n"), std::string::npos) << told;
  EXPECT_NE(told.find("\nmodel       none, classic\n"), std::string::npos) << told;

  for (const char* ofOne : {" --preset \"CT bone\"", " --light headlight", " --model robust"}) {
    outcome = run("render " + both + ofOne + " -o " + again);
    EXPECT_NE(outcome.err.find("24 x 20 pixels"), std::string::npos) << ofOne << outcome.err;
    EXPECT_NE(outcome.err.find("shows two looks; one was asked for"), std::string::npos)
        << ofOne << outcome.err;
  }
  // As pictures were saved before they told their sides.
  right.erase("shown");
  writeBytes(again, readBytes(both), right.dump());
  outcome = run("render " + again + " -o " + one);
  EXPECT_NE(outcome.err.find("two side by side, of which its file holds one"), std::string::npos)
      << outcome.err;
}

TEST_F(CommandLine, theBodyAloneIsKeptWhereThatIsAskedFor) {
  // The scene in the picture tells.
  const auto kept = [&](const std::string& arguments) {
    const std::string picture = file("kept.png").string();
    const Outcome outcome = run("render " + arguments + " --size 16x16 -o " + picture);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(readImageDescription(picture))["keep"].get<std::string>();
  };
  EXPECT_EQ(kept("phantom:8"), "all");
  EXPECT_EQ(kept("phantom:8 --keep body"), "body");
  std::filesystem::copy(file("kept.png"), file("first.png"));
  EXPECT_EQ(kept(file("first.png").string()), "body");
  EXPECT_EQ(kept(file("first.png").string() + " --keep all"), "all");
  const Outcome outcome = run("effects phantom:8 --keep table");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--keep cannot be \"table\"; choose one of all, body."), std::string::npos)
      << outcome.err;
}

TEST_F(CommandLine, effectsPrintsEveryRowWithItsReasonAndCostAsOneJsonObject) {
  const Outcome outcome = run("effects phantom:8 --model enhanced --size 48x48 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_FALSE(json["renderer"].get<std::string>().empty());
  const std::vector<std::string>& names = test::documentedEffects;
  ASSERT_EQ(json["effects"].size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const nlohmann::json& effect = json["effects"][i];
    EXPECT_EQ(effect.size(), 4u);
    EXPECT_EQ(effect["name"], names[i]);
    EXPECT_FALSE(effect["reason"].get<std::string>().empty());
    EXPECT_TRUE(effect["on"].get<bool>() || effect["cost_ms"] == 0.0) << "what is off costs nothing";
  }
  const nlohmann::json& others = json["if_switched_on"];
  const auto ofShadows =
      std::ranges::find_if(others, [](const nlohmann::json& other) { return other["name"] == "shadow"; });
  ASSERT_NE(ofShadows, others.end()) << others;
  EXPECT_TRUE((*ofShadows)["cost_ms"].is_number());
  EXPECT_GT((*ofShadows)["brought_levels"]["most"], 0.0);
  EXPECT_EQ(json["effects"][4]["on"], true) << "opacity follows the gradient";
  EXPECT_EQ(json["effects"][7]["on"], false) << "there is no fog";
  EXPECT_NE(outcome.err.find("median"), std::string::npos) << "the method is named: " << outcome.err;
}

TEST_F(CommandLine, effectsPrintsATableAndTheMethod) {
  const Outcome outcome = run("effects phantom:8 --model none --size 32x32");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* text :
       {"lighting              off", "without light", "fog is off", "the median of 7 pictures"})
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text << " in " << outcome.out;
}

TEST_F(CommandLine, effectsPrintsTheShaderThatDrawsTheScene) {
  const Outcome unlit = run("effects phantom:8 --model none --shader");
  ASSERT_EQ(unlit.status, 0) << unlit.err;
  EXPECT_EQ(unlit.out.rfind("#version 130", 0), 0u);
  EXPECT_EQ(unlit.out.find("#define EFFECT_LIGHTING"), std::string::npos);
  const Outcome lit = run("effects phantom:8 --model enhanced --shader");
  EXPECT_NE(lit.out.find("#define EFFECT_OPACITY_MAP"), std::string::npos);
}

TEST_F(CommandLine, sceneFileRenders) {
  std::ofstream(file("scene.json"))
      << R"({"limn_scene": 1, "volume": "phantom:8", "image": {"width": 40, "height": 30}})";
  for (const char* name : {"c.png", "c.tif", "c.jpg", "c.exr"}) {
    const Outcome outcome = run("render " + file("scene.json").string() + " -o " + file(name).string());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_GT(std::filesystem::file_size(file(name)), 100u) << name;
  }
}

TEST_F(CommandLine, referenceAndGlWriteThePicturesOfOneScene) {
  ASSERT_EQ(run("render phantom:6 --size 48x48 --engine gl -o " + file("gl.png").string()).status, 0);
  ASSERT_EQ(run("render phantom:6 --size 48x48 --engine reference -o " + file("ref.png").string()).status, 0);
  EXPECT_GT(std::filesystem::file_size(file("ref.png")), 1000u);
}

TEST_F(CommandLine, benchPrintsTheTimesOfEveryRendererAsOneJsonObject) {
  const Outcome outcome = run("bench phantom:8 --json --size 24x16 --step 2,1 --frames 3 --all-effects");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_FALSE(json["machine"].get<std::string>().empty());
  ASSERT_EQ(json["rows"].size(), 4u); // two steps by two programs
  for (std::size_t i = 0; i < 4; ++i) {
    const nlohmann::json& row = json["rows"][i];
    EXPECT_EQ(row["program"], i % 2 == 0 ? "limn-gl" : "limn-gl-all");
    EXPECT_EQ(row["scene"].get<std::string>().substr(0, 9), "phantom:8");
    EXPECT_EQ(row["size"], nlohmann::json::array({24, 16}));
    EXPECT_EQ(row["step_voxels"], i < 2 ? 2.0 : 1.0);
    EXPECT_GT(row["ms"]["min"], 0.0);
    EXPECT_GE(row["ms"]["median"], row["ms"]["min"]);
    EXPECT_GE(row["ms"]["max"], row["ms"]["median"]);
    EXPECT_GT(row["cpu_ms"], 0.0);
    // The first picture compiles a program, which takes longer than a picture of this size.
    EXPECT_GT(row["first_ms"], row["ms"]["min"]);
    EXPECT_GT(row["edit_ms"], 0.0);
    EXPECT_TRUE(row["peak_mb"].is_number());
    // Half the step errs less; both hold the rounding to 8 bits, a quarter of a level on average.
    EXPECT_GT(row["mean_error"], 0.1);
    EXPECT_LE(row["mean_error"], json["rows"][i % 2]["mean_error"]);
    EXPECT_EQ(row.size(), 10u);
  }
}

TEST_F(CommandLine, benchSaysWhichRendererCannotDrawASceneAndMeasuresTheOthers) {
  std::ofstream(file("mip.json")) << R"({"limn_scene": 1, "volume": "phantom:8", "projection": "mip"})";
  const std::string scene = file("mip.json").string();
  const Outcome outcome =
      run("bench '" + scene + "' --quiet --size 24x16 --frames 1 --engine slices,cpu --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json rows = nlohmann::json::parse(outcome.out)["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NE(rows[0]["missing"].get<std::string>().find("Slices cannot draw the projection \"mip\""),
            std::string::npos)
      << rows[0];
  EXPECT_GT(rows[1]["cpu_ms"], 0.0);
  const Outcome table = run("bench '" + scene + "' --quiet --size 24x16 --frames 1 --engine slices,cpu");
  EXPECT_NE(table.out.find("no figures: Slices cannot draw"), std::string::npos) << table.out;
  const Outcome none = run("bench '" + scene + "' --quiet --size 24x16 --frames 1 --engine slices");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("Slices cannot draw"), std::string::npos) << none.err;
}

TEST_F(CommandLine, benchShowsHowCostsGrowWithTheSizeOfAVolumeThatItMakes) {
  const Outcome outcome = run("bench --scale --largest 128 --frames 1 --json --quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json rows = nlohmann::json::parse(outcome.out)["rows"];
  ASSERT_EQ(rows.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(rows[i]["program"], i == 0 ? "limn-gl" : "limn-cpu");
    EXPECT_EQ(rows[i]["edge"], 128);
    EXPECT_NEAR(rows[i]["voxels_mb"], 2.097, 0.001); // 128³ bytes
    for (const char* figure : {"open_ms", "first_ms", "first_cpu_ms", "cpu_ms", "edit_ms"})
      EXPECT_GT(rows[i][figure], 0.0) << figure;
  }
  const Outcome table = run("bench --scale --largest 128 --engine cpu --frames 1 --quiet");
  EXPECT_NE(table.out.find("  128      2.1 limn-cpu"), std::string::npos) << table.out;
  for (const char* mistake : {"bench", "bench phantom:8 --scale"})
    EXPECT_EQ(run(mistake).status, 2) << mistake;
}

TEST_F(CommandLine, benchSavesThePictureOfEachRenderer) {
  const Outcome outcome =
      run("bench phantom:8 --quiet --size 24x16 --step 1 --frames 1 --engine gl,slices,reference "
          "--preset 'CT bone' --model classic --pictures " +
          file("pictures").string());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* program : {"limn-gl", "limn-slices", "limn-reference"})
    EXPECT_TRUE(std::filesystem::exists(
        file("pictures") / ("phantom:8, CT bone, classic, step 1, " + std::string(program) + ".png")));
}

TEST_F(CommandLine, slicesWriteThePictureInBothOrdersAndRefuseOtherProjections) {
  for (const char* engine : {"slices", "slices-back-to-front"}) {
    const std::string picture = file(std::string(engine) + ".png").string();
    const Outcome outcome =
        run("render phantom:6 --size 48x48 --engine " + std::string(engine) + " -o " + picture);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_GT(std::filesystem::file_size(picture), 1000u);
  }
  std::ofstream(file("mip.json")) << R"({"limn_scene": 1, "volume": "phantom:8", "projection": "mip"})";
  const Outcome refused = run("render " + file("mip.json").string() + " --engine slices -o x.png");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("Slices cannot draw the projection \"mip\""), std::string::npos) << refused.err;
}

TEST_F(CommandLine, mistakesEndWithTheirStatusAndOneSentence) {
  const struct {
    const char* arguments;
    int status;
    const char* says;
  } cases[] = {
      {"render", 2, "SOURCE"},
      {"render phantom:8", 2, "output"},
      {"render phantom:8 -o x.png --size 0x3", 2, "--size"},
      {"render phantom:8 -o x.png --engine vulkan", 2, "vulkan"},
      {"render phantom:8 -o x.png --engine fast", 2, "fast"},
      {"render phantom:8 -o x.png --model shiny", 2, "shiny"},
      {"render phantom:8 -o x.png --preset none-such", 2, "none-such"},
      {"render phantom:abc -o x.png", 2, "phantom:abc"},
      {"render nowhere.nii.gz -o x.png", 3, "nowhere.nii.gz"},
      {"info nowhere.nii.gz", 3, "nowhere.nii.gz"},
      {"effects", 2, "SOURCE"},
      {"effects phantom:8 --model compare", 2, "compare"},
      {"frobnicate --loudly", 2, "loudly"},
      {"redner phantom:8 -o x.png", 2, "did you mean render?"},
      {"presets conver a.json b.json", 2, "did you mean convert?"},
      {"render phantom:8 -o x.png --modle classic", 2, "did you mean --model?"},
      {"render phantom:8 --presett x", 2, "did you mean --preset?"},
      {"accurcy", 2, "did you mean accuracy?"},
      {"info sampel", 3, "did you mean sample?"},
      {"info phantm:8", 3, "did you mean phantom?"},
      {"help accurcy", 2, "did you mean accuracy?"},
      {"--theme dark help", 2, "Help stands in front"},
      {"render phantom:8 -o x.png --preset bome", 2, "did you mean \"CT bone\"?"},
      {"render phantom:8 -o x.png --model clasic", 2, "did you mean classic?"},
      {"bench phantom:8 --engine cpuu", 2, "did you mean cpu?"},
      {"render phantom:8", 2, "--output is required (see limn render --help)"},
      {"presets", 2, "limn presets needs one of its commands: list, show, convert (see limn presets --help)"},
      {"presets convert a.json b.json c.json", 2, "takes one IN and one OUT; c.json is one word too many"},
      {"render phantom:8 --size", 2, "--size needs a value behind it (see limn render --help)"},
      {"render phantom:8 --size 8x8 --size 9x9 -o x.png", 2, "--size is there more than once"},
      {"render phantom:8 -o x.png -x", 2, "limn render has no option -x"},
      {"render phantom:8 -o x.png --step abc", 2, "\"abc\" is not a number from 0.0001 to 10000"},
      {"render phantom:8 -o x.png --threads 1.5", 2, "\"1.5\" is not a whole number from 1 to 4096"},
      {"accuracy phantom:8 -o x --within -1", 2, "\"-1\" is not a number from 0.01 to 255"},
      {"surface phantom:8 -o x.stl --value abc", 2, "\"abc\" is not a number (see limn surface --help)"},
      {"stability -o x --seed -1", 2, "\"-1\" is not a whole number from 0"},
      {"render phantom:8 -o nowhere/x.png", 1, "there is no folder nowhere"},
      {"presets show nothing", 2, "nothing"},
      {"bench phantom:8 --step fast", 2, "--step"},
      {"bench phantom:8 --engine vulkan", 2, "vulkan"},
      {"phantom:8 --spacing 1,2", 2, "--spacing"},
  };
  for (const auto& one : cases) {
    const Outcome outcome = run(one.arguments);
    EXPECT_EQ(outcome.status, one.status) << one.arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(one.says), std::string::npos) << one.arguments << "\n" << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  }
}

TEST_F(CommandLine, helpIsACommandToo) {
  EXPECT_EQ(run("help").out, run("--help").out);
  EXPECT_EQ(run("help presets convert").out, run("presets convert --help").out);
  EXPECT_EQ(run("help render").status, 0);
}

TEST_F(CommandLine, theFilesOfAFolderAreCountedAndTheFolderIsNamed) {
  std::filesystem::create_directory(file("series"));
  for (const char* name : {"1.dcm", "2.dcm", "3.dcm", "4.dcm"})
    test::writeBytes(file("series") / name, "slice");
  const Outcome outcome = run("info '" + file("series").string() + "'/*.dcm");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err,
            "limn: limn info takes one SOURCE; " + (file("series") / "2.dcm").string() +
                " and 2 more are too many, and slices of one series are given by their folder, " +
                file("series").string() + " (see limn info --help)\n");
}

TEST_F(CommandLine, everyCommandSaysThatTheNumberOfASeriesWasIgnored) {
  const std::string out = file("out").string();
  for (const std::string& command : std::vector<std::string>{
           "info phantom:16 --series 3", "effects phantom:16 --series 3 --size 16x16 --frames 5",
           "render phantom:16 --series 3 --size 16x16 -o '" + out + ".png'",
           "figure phantom:16 --series 3 --size 300 -o '" + out + ".png'",
           "surface phantom:16 --series 3 --value 300 -o '" + out + ".stl'",
           "turntable phantom:16 --series 3 --size 16x16 --frames 2 -o '" + out + "'",
           "bench phantom:16 --series 3 --size 16x16 --frames 1 --engine cpu"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << command << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find("This is no DICOM series; its number 3 was ignored."), std::string::npos)
        << command << "\n"
        << outcome.err;
  }
  EXPECT_EQ(run("info phantom:16 --series 3 --quiet").err, "");
}

TEST_F(CommandLine, aSceneWithAMisspeltKeyIsRefusedByName) {
  std::ofstream(file("scene.json")) << R"({"limn_scene": 1, "volume": "phantom:8", "shadingg": {}})";
  const Outcome outcome = run("render " + file("scene.json").string() + " -o x.png");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("shadingg"), std::string::npos) << outcome.err;
}

TEST_F(CommandLine, aSceneWhoseVolumeMovedSaysSoAndOpensWithItsNewPlace) {
  std::filesystem::create_directory(file("elsewhere"));
  std::ofstream(file("scene.json"))
      << R"({"limn_scene": 1, "volume": "moved.nii", "image": {"width": 8, "height": 8}})";
  const std::string picture = file("m.png").string();
  const Outcome lost = run("render " + file("scene.json").string() + " -o " + picture);
  EXPECT_EQ(lost.status, 3);
  EXPECT_NE(lost.err.find("moved.nii"), std::string::npos) << lost.err;
  const Outcome found = run("render " + file("scene.json").string() + " --volume phantom:8 -o " + picture);
  EXPECT_EQ(found.status, 0) << found.err;
}

TEST_F(CommandLine, thatAViewIsFittedToAnotherVolumeIsSaidOnlyWhereNoOtherViewIsGiven) {
  std::ofstream(file("scene.json"))
      << R"({"limn_scene": 1, "volume": "gone.nii", "image": {"width": 8, "height": 8},)"
         R"( "camera": {"position": [9300, 0, 0], "target": [9300, 300, 0]}})";
  const std::string command =
      "render " + file("scene.json").string() + " --volume phantom:8 -o " + file("m.png").string();
  const std::string sentence = "The saved view looks past this volume";
  const Outcome fitted = run(command);
  EXPECT_EQ(fitted.status, 0) << fitted.err;
  EXPECT_NE(fitted.err.find(sentence), std::string::npos) << fitted.err;
  const Outcome given = run(command + " --view left");
  EXPECT_EQ(given.status, 0) << given.err;
  EXPECT_EQ(given.err.find(sentence), std::string::npos) << given.err;
}

TEST_F(CommandLine, withoutADisplayTheWindowSaysWhatToDo) {
  const Outcome outcome = run("phantom:8");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("limn render"), std::string::npos) << outcome.err;
}

TEST_F(CommandLine, presetsAreListedAndShown) {
  const Outcome list = run("presets list");
  EXPECT_EQ(list.status, 0);
  EXPECT_GE(std::count(list.out.begin(), list.out.end(), '\n'), 20);
  const Outcome show = run("presets show 'CT bone'");
  EXPECT_EQ(nlohmann::json::parse(show.out)["name"], "CT bone");
  EXPECT_EQ(run("presets show 'ct BONE'").out, show.out);
}

TEST_F(CommandLine, aVeryLongPresetNameWidensNoOtherLine) {
  const std::string before = run("presets list").out;
  nlohmann::json preset = nlohmann::json::parse(run("presets show 'CT bone'").out);
  preset["name"] = std::string(120, 'n');
  const std::filesystem::path presets = file(".local/share/limn/limn/presets");
  std::filesystem::create_directories(presets);
  std::ofstream(presets / "long.json") << preset;
  const std::string list = run("presets list").out;
  EXPECT_EQ(list.rfind(before, 0), 0u) << "the others are as they were:\n" << list;
  EXPECT_NE(list.find(std::string(120, 'n') + "\n"), std::string::npos) << list;
}

TEST_F(CommandLine, aRealHeadRendersFromItsFile) {
  LIMN_NEEDS_SHARED("data/ct_head_cranium/ct_head_cranium.nii.gz");
  const std::string head = (test::sharedFolder() / "data/ct_head_cranium/ct_head_cranium.nii.gz").string();
  const Outcome outcome =
      run("render " + head + " --model compare --size 128x64 --step 1 -o " + file("h.png").string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("CT bone and veil"), std::string::npos) << outcome.err;
  const std::string description = readImageDescription(file("h.png"));
  EXPECT_EQ(description.find("shared"), std::string::npos) << "folder names must not travel with the picture";
}

} // namespace
} // namespace limn
