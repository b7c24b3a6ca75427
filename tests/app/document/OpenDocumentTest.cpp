// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/OpenDocument.h"

#include "app/document/DocumentText.h"

#include <gtest/gtest.h>

#include <limits>

// What is open, what counts as saved and what it is called, without a window.

namespace limn {
namespace {

class OpenDocumentTest : public testing::Test {
protected:
  // Four by three by two voxels of a CT.
  static LoadedScene loaded(const std::string& path, const PatientLabel& patient = {}) {
    VolumeInfo info;
    info.modality = "CT";
    info.unit = "HU";
    info.patient = patient;
    LoadedScene made;
    made.scene.volume = std::make_shared<const Volume>(
        Grid{{4, 3, 2}}, VoxelArray(std::vector<std::int16_t>(24)), Rescale{}, std::nullopt, info);
    made.scene.transferFunction = rampTo(10.0);
    made.volumePath = path;
    made.preset = "Bone";
    return made;
  }

  static TransferFunction rampTo(double value) {
    return {1.0, {{0.0, glm::dvec3(1), 0.0}, {value, glm::dvec3(1), 1.0}}};
  }

  void openAndSettle(const std::string& path, const PatientLabel& patient = {}) {
    document.open(loaded(path, patient), {QString::fromStdString(path), {}}, {});
    document.settle(document.described());
  }

  void edit(double value) { session.setTransferFunction(rampTo(value), {nextGestureId(), "edit"}); }

  Session session;
  OpenDocument document{session};
};

TEST_F(OpenDocumentTest, nothingIsLostWhereNothingIsOpen) {
  EXPECT_FALSE(document.unsaved(document.described()));
  EXPECT_EQ(titleOf(document, true), QStringLiteral("Limn · not for diagnosis[*]"));
  EXPECT_EQ(suggestedName(document), QStringLiteral("limn"));
}

TEST_F(OpenDocumentTest, whatWasOpenedCountsAsSavedUntilItIsEditedAndOnceTheEditIsTakenBack) {
  openAndSettle("/data/head.nii");
  EXPECT_FALSE(document.unsaved(document.described()));
  edit(20.0);
  const auto unsaved = document.unsaved(document.described());
  ASSERT_TRUE(unsaved);
  EXPECT_TRUE(unsaved->isUnsaved);
  EXPECT_EQ(unsaved->scene.volume, "/data/head.nii");
  EXPECT_EQ(unsaved->label, "head.nii · CT 4×3×2");
  session.undoStack().undo();
  EXPECT_FALSE(document.unsaved(document.described()));
}

TEST_F(OpenDocumentTest, anotherArrangementIsKeptWithoutCountingAsAnEditAndAPanelAloneIsNoLoss) {
  openAndSettle("/data/head.nii");
  SessionDocument now = document.described();
  now.panel = SessionDocument::Panel::accuracy;
  EXPECT_FALSE(document.unsaved(now));
  now.labelInHand = 1;
  EXPECT_FALSE(document.unsaved(now)) << "whose curve is looked at is no work";
  now.layout = CompareLayout::wipe;
  const auto unsaved = document.unsaved(now);
  ASSERT_TRUE(unsaved);
  EXPECT_FALSE(unsaved->isUnsaved);
}

TEST_F(OpenDocumentTest, savingToAFileSettlesIt) {
  openAndSettle("/data/head.nii");
  edit(20.0);
  document.settleIn(QStringLiteral("/data/mine.json"), document.described());
  EXPECT_FALSE(document.isEdited());
  EXPECT_FALSE(document.unsaved(document.described()));
  EXPECT_EQ(document.sessionFile(), QStringLiteral("/data/mine.json"));
  EXPECT_TRUE(titleOf(document, true).startsWith(QStringLiteral("mine.json · head.nii")));
  edit(30.0);
  EXPECT_EQ(document.unsaved(document.described())->savedAs, "/data/mine.json");
  EXPECT_TRUE(
      QString::fromStdString(document.unsaved(document.described())->label).startsWith("mine.json · "));
  document.close();
  EXPECT_TRUE(document.sessionFile().isEmpty());
  EXPECT_FALSE(document.unsaved(document.described()));
}

TEST_F(OpenDocumentTest, anUnsavedSessionGoesOnAsWhatItWas) {
  LoadedScene restored = loaded("/data/head.nii");
  restored.session.emplace();
  restored.session->savedAs = "/data/mine.json";
  restored.session->isUnsaved = true;
  restored.session->preset = "Skin";
  document.open(restored, {QStringLiteral("/kept/1/session.json"), {}, true}, {});
  EXPECT_TRUE(document.isEdited());
  EXPECT_EQ(document.sessionFile(), QStringLiteral("/data/mine.json"));
  EXPECT_EQ(document.request().source, QStringLiteral("/data/head.nii")) << "its own file goes";
  EXPECT_EQ(document.presetInUse(), (OpenDocument::PresetInUse{"Skin", false}));
  EXPECT_TRUE(document.unsaved(document.described()));
}

TEST_F(OpenDocumentTest, aPresetIsInUseAndToldAsModifiedWhereWhatItSetsIsChanged) {
  const OpenDocument::PresetInUse bone{"Bone", false};
  const OpenDocument::PresetInUse changed{"Bone", true};
  openAndSettle("/data/head.nii");
  EXPECT_EQ(document.presetInUse(), bone);
  edit(20.0);
  EXPECT_EQ(document.presetInUse(), changed);
  EXPECT_EQ(document.described().preset, "") << "a session names the preset that it shows";
  session.undoStack().undo();
  EXPECT_EQ(document.presetInUse(), bone);
  session.setGradientOpacity(GradientOpacity{{{5.0, 0.25}}}, {nextGestureId(), "edit"});
  EXPECT_EQ(document.presetInUse(), changed);
  session.undoStack().undo();
  Shading shading = session.scene().shading;
  shading.model = ShadingModel::robust;
  session.setShading(shading, {nextGestureId(), "model"});
  EXPECT_EQ(document.presetInUse(), bone) << "the model is chosen beside presets";
  shading.ambient *= 0.5;
  session.setShading(shading, {nextGestureId(), "light"});
  EXPECT_EQ(document.presetInUse(), changed);
}

TEST_F(OpenDocumentTest, aCameraThatFollowsTheWindowIsNoChangeAndOneThatIsMovedIs) {
  openAndSettle("/data/head.nii");
  Camera camera = session.scene().camera;
  camera.position.x += 5.0;
  document.fitCamera(camera);
  EXPECT_EQ(session.scene().camera, camera);
  EXPECT_FALSE(document.unsaved(document.described()));
  camera.position.x += 5.0;
  session.setCamera(camera);
  EXPECT_TRUE(document.unsaved(document.described()));
  camera.position.x += 5.0;
  document.fitCamera(camera); // what was moved stays a change
  EXPECT_TRUE(document.unsaved(document.described()));
}

TEST_F(OpenDocumentTest, undoBringsBackThePresetBefore) {
  openAndSettle("/data/head.nii");
  Preset skin;
  skin.name = "Skin";
  skin.transferFunction = session.scene().transferFunction;
  skin.transferFunction.unitDistanceMm *= 2.0;
  session.usePreset(skin, {nextGestureId(), "use Skin"});
  EXPECT_EQ(document.presetInUse(), (OpenDocument::PresetInUse{"Skin", false}));
  session.undoStack().undo();
  EXPECT_EQ(document.presetInUse(), (OpenDocument::PresetInUse{"Bone", false}));
  edit(20.0);
  EXPECT_EQ(document.presetInUse(), (OpenDocument::PresetInUse{"Bone", true}));
  session.undoStack().undo();
  session.undoStack().redo();
  EXPECT_EQ(document.presetInUse(), (OpenDocument::PresetInUse{"Bone", true}));
}

TEST_F(OpenDocumentTest, thePatientIsNamedInTheTitleOnlyWhereThatIsWanted) {
  openAndSettle("/data/quillon/zebedee.nii", {"ZEBEDEE^QUILLON", "PID7", "19870615"});
  document.settleIn(QStringLiteral("/data/quillon.json"), document.described());
  const QString program = QStringLiteral("[*] — Limn · not for diagnosis");
  EXPECT_EQ(titleOf(document, true),
            QStringLiteral("quillon.json · zebedee.nii · ZEBEDEE^QUILLON · PID7 · 19870615") + program);
  EXPECT_EQ(titleOf(document, false), QStringLiteral("ct-4x3x2") + program);
  EXPECT_EQ(labelOf(document), QStringLiteral("CT 4×3×2"));
  EXPECT_EQ(labelOf(document, document.sessionFile()), QStringLiteral("CT 4×3×2"));
  EXPECT_EQ(suggestedName(document), QStringLiteral("ct-4x3x2"));
}

TEST_F(OpenDocumentTest, aSessionIsCalledAfterItsOwnFileAndNotAsItsVolume) {
  openAndSettle("/data/head.nii");
  document.settleIn(QStringLiteral("/data/t1.limn.json"), document.described());
  EXPECT_EQ(labelOf(document), QStringLiteral("head.nii · CT 4×3×2"));
  EXPECT_EQ(labelOf(document, document.sessionFile()), QStringLiteral("t1.limn.json · CT 4×3×2"));
}

TEST_F(OpenDocumentTest, workOnAFigureThatWasOpenedIsCalledAfterItsVolume) {
  document.open(loaded("/data/head.nii"), {QStringLiteral("/papers/fig1.png"), {}}, {});
  document.settle(document.described());
  EXPECT_EQ(labelOf(document), QStringLiteral("fig1.png · CT 4×3×2")) << "which opens it again";
  edit(20.0);
  const auto unsaved = document.unsaved(document.described());
  ASSERT_TRUE(unsaved);
  EXPECT_EQ(unsaved->label, "head.nii · CT 4×3×2");
}

TEST(DocumentText, tellsOfOneVoxelWithoutDataAsOfOne) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const auto remark = [](std::vector<float> values) {
    Grid grid;
    grid.dims = {3, 1, 1};
    return remarksOn(Volume(grid, std::move(values), {}, {}, {}), {}).join(QLatin1Char('\n'));
  };
  EXPECT_EQ(remark({1.0f, 2.0f, 3.0f}), QString());
  EXPECT_EQ(remark({1.0f, none, 3.0f}),
            QStringLiteral("1 voxel holds no data and is shown as the smallest value."));
  EXPECT_EQ(remark({none, none, 3.0f}),
            QStringLiteral("2 voxels hold no data and are shown as the smallest value."));
}

// Only the first of several is seen before somebody asks for details.
TEST(DocumentText, tellsFirstOfSlicesThatSlanted) {
  const auto remarks = [](bool slants) {
    VolumeInfo info;
    info.warnings = {Message::tr("They slanted."), Message::tr("Corners are empty.")};
    info.slants = slants;
    const Volume volume(Grid{{3, 1, 1}}, std::vector<float>{1.0f, 2.0f, 3.0f}, {}, {}, info);
    return remarksOn(volume, {Message::tr("They lie far apart.")});
  };
  EXPECT_EQ(remarks(true), (QStringList{"They slanted.", "They lie far apart.", "Corners are empty."}));
  EXPECT_EQ(remarks(false), (QStringList{"They lie far apart.", "They slanted.", "Corners are empty."}));
}

TEST_F(OpenDocumentTest, theSampleIsCalledSo) {
  document.open(loaded("/usr/share/sample.inv3"), {QStringLiteral("sample"), {}}, {});
  EXPECT_TRUE(titleOf(document, false).startsWith(QStringLiteral("Sample head[*]")));
  EXPECT_EQ(labelOf(document), QStringLiteral("Sample head"));
}

} // namespace
} // namespace limn
