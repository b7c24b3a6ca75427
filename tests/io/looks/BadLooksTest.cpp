// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

#include <chrono>

// What every family must refuse in one sentence that names the file, or bear.
namespace limn {
namespace {

using test::refusal;

// A sound text of each family.
std::vector<std::string> soundTexts() {
  Preset preset;
  preset.name = "CT demo";
  preset.transferFunction.points = {
      {-100, {0.5, 0, 0}, 0}, {200, {1, 0.5, 0.25}, 0.75}, {900, {1, 1, 1}, 0.5}};
  std::vector<std::string> texts;
  for (const char* file : {"a.vp.json", "a.vp", "a.xml", "a.plist", "a.paraview.json", "a.weasis.json"})
    texts.push_back(lookAs(file, preset).text);
  return texts;
}

TEST(BadLooks, everyTextCutAnywhereIsReadOrRefusedInOneSentence) {
  for (const std::string& text : soundTexts()) {
    EXPECT_EQ(refusal(text), "");
    int refused = 0;
    for (std::size_t length = 0; length + 4 < text.size(); length += 3)
      refused += refusal(text.substr(0, length)).empty() ? 0 : 1;
    EXPECT_GT(refused, static_cast<int>(text.size() / 6)) << text.substr(0, 60);
  }
}

// Whoever reads it wrote no JSON: the file, why, and what to do.
TEST(BadLooks, aDamagedPresetIsToldInWordsForEverybody) {
  Preset preset;
  preset.name = "CT demo";
  preset.modality = "CT";
  preset.transferFunction.points = {{-100, {0.5, 0, 0}, 0}, {200, {1, 0.5, 0.25}, 0.75}};
  const std::string sound = lookAs("a.json", preset).text;
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string text = sound;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), instead);
  };
  const std::vector<std::pair<std::string, std::string>> damaged{
      {sound.substr(0, sound.size() / 2), "it is damaged or cut off"},
      {with("0.75", "7.5"), "is 7.5 and must be from 0 to 1"},
      {with("0.75", "\"much\""), "\"transfer_function.points[1].opacity\" must be a number"},
      {with("\"limn_preset\": 1", "\"limn_preset\": 2"), "it is a preset of a newer Limn"},
      {with("\"modality\"", "\"modalty\""), "\"modalty\" is nothing that Limn knows there"}};
  for (const auto& [text, why] : damaged) {
    const std::string said = refusal(text);
    EXPECT_EQ(said.find("Cannot read "), 0u) << said;
    EXPECT_NE(said.find(why), std::string::npos) << said;
    EXPECT_NE(said.find("; "), std::string::npos) << "and what to do: " << said;
    for (const char* jargon : {"JSON", "XML", "byte", " key", "object", "array"})
      EXPECT_EQ(said.find(jargon), std::string::npos) << said;
  }
}

TEST(BadLooks, foreignTextIsRefusedWithWhatToDo) {
  for (const char* text :
       {"", "   \n", "hello\nworld\n", "{}", "[]", "[FLT]\nmin=1\n", "<html></html>", "{\"a\": 1}"})
    EXPECT_NE(refusal(text).find("no look that Limn knows"), std::string::npos) << text;
}

TEST(BadLooks, numbersThatAreNotFiniteAreRefused) {
  for (const char* number : {"nan", "inf", "-inf", "1e999"}) {
    const std::string n = number;
    EXPECT_NE(refusal("1\n1\n0.8\n0.1\n0.2\n12\n4 0 0 " + n + " 1\n\n8 0 0 0 0 1 1 1 1\n"), "") << n;
    EXPECT_NE(refusal("1\n1\n0.8\n0.1\n" + n + "\n12\n4 0 0 1 1\n\n8 0 0 0 0 1 1 1 1\n"), "") << n;
    EXPECT_NE(refusal("[{\"RGBPoints\": [0, 0, 0, 0, " + n + ", 1, 1, 1]}]"), "") << n;
    EXPECT_NE(refusal("[{\"group\": [{\"point\": [{\"intensity\": \"" + n + "\", \"opacity\": \"1\"}]}]}]"),
              "")
        << n;
    EXPECT_NE(
        refusal("<plist><dict><key>CLUT</key><string/><key>ww</key><real>" + n + "</real></dict></plist>"),
        "")
        << n;
  }
}

TEST(BadLooks, functionsThatContradictThemselvesAreRefused) {
  const auto lines = [](const std::string& opacity) {
    return "1\n1\n1\n1\n1\n1\n" + opacity + "\n\n8 0 0 0 0 1 1 1 1\n";
  };
  EXPECT_NE(refusal(lines("4 0 0 1")).find("should have 4 numbers"), std::string::npos) << "cut";
  EXPECT_NE(refusal(lines("4 0 0 1 1 2 1")).find("should have 4 numbers"), std::string::npos) << "longer";
  EXPECT_NE(refusal(lines("3 0 0 1")).find("2 for each point"), std::string::npos);
  EXPECT_NE(refusal(lines("0")).find("no points"), std::string::npos);
  EXPECT_NE(refusal(lines("4 0 zero 1 1")).find("\"zero\""), std::string::npos);
  EXPECT_NE(refusal("[{\"RGBPoints\": [0, 0, 0, 0, 1, 1]}]").find("4 numbers for each point"),
            std::string::npos);
  EXPECT_NE(refusal("[{\"RGBPoints\": []}]").find("no points"), std::string::npos);
  EXPECT_NE(refusal("{\"volumeProperties\": []}").find("no volume property"), std::string::npos);
  EXPECT_NE(refusal("{\"volumeProperties\": [{\"components\": [{}]}]}").find("no points"), std::string::npos);
  EXPECT_NE(refusal("<MRML><VolumeProperty name=\"a\"/></MRML>").find("functions of its own"),
            std::string::npos);
}

TEST(BadLooks, whatLiesOutsideZeroToOneIsLimitedAndTold) {
  const ReadLook look = test::onlyLook(
      "[{\"RGBPoints\": [0, -1, 0, 0, 900, 1, 2, 1], \"Points\": [0, 0, 0.5, 0, 900, 7, 0.5, 0]}]");
  EXPECT_EQ(look.preset.transferFunction.points.back().opacity, 1.0);
  EXPECT_TRUE(test::isTold(look.changes, "limited"));
}

TEST(BadLooks, aMillionPointsAreRefusedSoonAndAHundredThousandAreRead) {
  const auto lines = [](int count) {
    std::string opacity = std::to_string(2 * count);
    for (int i = count; i > 0; --i) // in descending order, too
      opacity += " " + std::to_string(i) + " 0.5";
    return "1\n1\n1\n1\n1\n1\n" + opacity + "\n\n8 0 0 0 0 1 1 1 1\n";
  };
  EXPECT_NE(refusal(lines(1000000)).find("more than 100000 points"), std::string::npos);
  const ReadLook look = test::onlyLook(lines(99000));
  EXPECT_EQ(look.preset.transferFunction.points.size(), 99001u) << "and one of the colour, at 0";
  std::string bent;
  for (int i = 0; i < 99000; ++i)
    bent += std::string(i ? "," : "") + std::to_string(i) + "," + (i % 2 ? "0.9" : "0.1") + ",0.5,0.5";
  EXPECT_NE(refusal("[{\"RGBPoints\": [0,0,0,0,1,1,1,1], \"Points\": [" + bent + "]}]")
                .find("more than 100000 points"),
            std::string::npos)
      << "straight segments for curved ones are bounded, too";
}

TEST(BadLooks, aNumberInAnotherLanguagesWritingIsNone) {
  EXPECT_NE(refusal("1\n1\n0,8\n0.1\n0.2\n12\n4 0 0 1 1\n\n8 0 0 0 0 1 1 1 1\n").find("\"0,8\""),
            std::string::npos);
  EXPECT_NE(refusal("[{\"group\": [{\"point\": [{\"intensity\": \"1,5\", \"opacity\": \"1\"}]}]}]"), "");
}

TEST(BadLooks, anEndingThatNamesNoKindIsWrongUsage) {
  try {
    lookAs("look.txt", Preset{});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::usage);
    EXPECT_NE(std::string(error.what()).find(".vp.json"), std::string::npos);
  }
}

} // namespace
} // namespace limn
