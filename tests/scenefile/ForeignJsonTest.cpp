// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/ForeignJson.h"

#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

std::string refusalOfJson(const std::string& text) {
  try {
    refuseForeignJson(text, "file.json");
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(ForeignJson, isCalledWhatItIs) {
  const std::pair<const char*, const char*> kinds[] = {
      {R"({"@schema": "https://raw.githubusercontent.com/slicer/slicer/x.json#", "volumeProperties": []})",
       "3D Slicer (volume rendering"},
      {R"({"@schema": "https://raw.githubusercontent.com/slicer/slicer/x.json#", "markups": []})",
       "markups of 3D Slicer"},
      {R"([{"ColorSpace": "Lab", "Name": "x", "RGBPoints": []}])", "ParaView"},
      {R"({"limn_preset": 1, "name": "Bone"})", "a preset of Limn"},
      {R"({"limn_settings": 1, "values": {}})", "Limn's own settings"},
      {R"({"layers": [], "zoom": 1})", "its first key is \"layers\""},
      {"{}", "an empty JSON object"},
      {"[1, 2]", "JSON of another program"}};
  for (const auto& [text, kind] : kinds) {
    const std::string sentence = refusalOfJson(text);
    EXPECT_NE(sentence.find("file.json"), std::string::npos) << text;
    EXPECT_NE(sentence.find(kind), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("limn_scene"), std::string::npos) << sentence;
  }
}

TEST(ForeignJson, whatMayBeASceneIsLeftToItsReader) {
  for (const char* text : {R"({"limn_scene": 1})", R"({"limn_session": 1})", R"({"volume": "head.nii"})",
                           R"({"transfer_function": {}})", "{\"limn_scene\": 1, ", "no JSON"})
    EXPECT_EQ(refusalOfJson(text), "") << text;
}

TEST(ForeignJson, aKeyOfAnyLengthAndBytesStaysASentence) {
  const std::string sentence = refusalOfJson("{\"" + std::string(5000, 'k') + "\": 1}");
  EXPECT_LT(sentence.size(), 400u);
  EXPECT_EQ(refusalOfJson(R"({"a\nb": 1})").find('\n'), std::string::npos);
}

} // namespace
} // namespace limn
