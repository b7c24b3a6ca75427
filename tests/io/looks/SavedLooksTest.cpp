// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"
#include "io/ImageFile.h"
#include "io/scenefile/FigureFile.h"
#include "io/scenefile/SessionFile.h"
#include "support/TemporaryFolder.h"

#include <fstream>

// What Limn saved of a volume, taken as a look for another one.
namespace limn {
namespace {

class SavedLooks : public testing::Test {
protected:
  SavedLooks() {
    document.volume = "head.nii.gz";
    document.hasTransferFunction = true;
    document.scene.transferFunction.points = {{-100, {0.5, 0, 0}, 0}, {200, {1, 0.5, 0.25}, 0.75}};
    document.scene.shading.model = ShadingModel::robust;
    document.scene.projection = Projection::compositeIsosurface;
    document.scene.isovalue = 150.0;
  }

  std::string savedAs(const std::string& name, const std::string& description) const {
    writeImage(folder.path() / name, Image({4, 3}), {}, description);
    return (folder.path() / name).string();
  }

  ReadLook only(const std::vector<ReadLook>& looks) const {
    EXPECT_EQ(looks.size(), 1u);
    return looks.front();
  }

  std::string refusalOf(const std::string& file) const {
    try {
      readLooks(file);
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::input) << error.what();
      return error.what();
    }
  }

  test::TemporaryFolder folder;
  SceneDocument document;
};

TEST_F(SavedLooks, everyKindOfPictureIsALookCalledAsItsFile) {
  for (const char* name : {"my look.png", "my look.tif", "my look.exr", "my look.jpg"}) {
    const ReadLook look = only(readLooks(savedAs(name, sceneToJson(document))));
    EXPECT_EQ(look.preset, presetOf(document.scene, "my look")) << name;
    EXPECT_TRUE(test::isTold(look.changes, "its view, quality and background were not")) << name;
    EXPECT_EQ(look.changes.size(), 1u) << test::allOf(look.changes);
  }
}

TEST_F(SavedLooks, whatBelongsToTheOtherVolumeIsToldToBeLeftOut) {
  document.scene.fog.mode = Fog::Mode::exp;
  document.scene.crop.upper.x = 0.5;
  document.measurements = {{Measurement::Kind::mark, std::nullopt, {{1, 2, 3}}, "1"}};
  const std::string text = sceneToJson(document);
  const std::vector<Message> told = test::onlyLook(text).changes;
  for (const char* words : {"fog was left out", "cropped, cut or hidden", "measurements were left out"})
    EXPECT_TRUE(test::isTold(told, words)) << words << "\n" << test::allOf(told);
}

TEST_F(SavedLooks, ofASessionTheyAreCalledAsItsPreset) {
  SessionDocument session;
  session.scene = document;
  const std::string path = (folder.path() / "monday.limn.json").string();
  const auto nameOf = [&] {
    std::ofstream(path) << sessionToJson(session);
    return only(readLooks(path)).preset.name;
  };
  EXPECT_EQ(nameOf(), "monday");
  session.preset = "CT bone";
  EXPECT_EQ(nameOf(), "CT bone");
  session.changedPreset = presetOf(document.scene, "CT skin");
  EXPECT_EQ(nameOf(), "CT skin");
}

TEST_F(SavedLooks, ofAFigureEachIsThereOnce) {
  FigureDocument figure;
  FigurePanelDocument panel;
  panel.scene = document;
  panel.scene.hasCamera = true;
  figure.panels = {panel, panel, panel, panel};
  figure.panels[1].scene.scene.camera.position.x = 100.0; // the same look from elsewhere
  figure.panels[2].plane = PatientPlane::axial;
  figure.panels[3].scene.scene.shading.model = ShadingModel::classic;
  const std::vector<ReadLook> looks = readLooks(savedAs("figure.png", figureToJson(figure)));
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_EQ(looks[0].preset.name, "figure");
  EXPECT_EQ(looks[1].preset.name, "figure 2");
  EXPECT_EQ(looks[1].preset.shading->model, ShadingModel::classic);
}

TEST_F(SavedLooks, aPictureOfAnotherProgramIsRefusedAsOne) {
  for (const char* description : {"", "a holiday", "{\"limn_scene\": "}) {
    const std::string said = refusalOf(savedAs("holiday.png", description));
    EXPECT_NE(said.find("holiday.png: it is no picture that Limn saved with its look"), std::string::npos)
        << said;
  }
  std::ofstream(folder.path() / "text.png") << "no picture";
  EXPECT_NE(refusalOf((folder.path() / "text.png").string()).find("text.png"), std::string::npos);
}

TEST_F(SavedLooks, aSceneThatLeavesTheCurveToItsVolumeIsNone) {
  const std::string said = test::refusal(R"({"limn_scene": 1, "volume": "head.nii.gz"})");
  EXPECT_NE(said.find("leaves the curve to its volume"), std::string::npos) << said;
}

} // namespace
} // namespace limn
