// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "scene/light/Shading.h"
#include "support/Heart.h"
#include "support/Places.h"
#include "support/TestData.h"
#include "widgets/view/panels/PictureStatus.h"

#include <OpenImageIO/imageio.h>

#include <QProcess>
#include <QRegularExpression>
#include <QStatusBar>

#include <cstdio>

// What the status bar says of the picture, against what the shipped program draws.

namespace limn {
namespace {

// Premultiplied RGBA as the file holds it.
std::vector<float> samplesOf(const QString& file) {
  const auto input = OIIO::ImageInput::open(file.toStdString());
  if (!input || input->spec().nchannels != 4)
    return {};
  std::vector<float> samples(4 * static_cast<std::size_t>(input->spec().width) * input->spec().height);
  input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, samples.data());
  return samples;
}

std::vector<float> samplesOf(const Image& image) {
  std::vector<float> samples;
  for (const glm::vec4& pixel : image.pixels)
    samples.insert(samples.end(), {pixel.r, pixel.g, pixel.b, pixel.a});
  return samples;
}

class RefinementTest : public test::OpenGlWindow {
protected:
  QString statusText() const { return window->findChild<PictureStatus*>()->text().line(); }

  // The number before "of 255 levels".
  double statedLevels() const {
    static const QRegularExpression levels(QStringLiteral("within (?:about )?([0-9.]+) of 255 levels"));
    const QRegularExpressionMatch match = levels.match(statusText());
    return match.hasMatch() ? match.captured(1).toDouble() : -1.0;
  }

  // What the tool tip says, as it is typed: {"--step", "0.0625"} or {"--tolerance", "0.5"}.
  QStringList statedSteps() const {
    static const QRegularExpression step(QStringLiteral("step ([0-9.e-]+)(?:/([0-9]+))? of the smallest"));
    static const QRegularExpression tolerance(
        QStringLiteral("by error, meant for ([0-9.e-]+) of 255 levels"));
    const QString toolTip = window->findChild<PictureStatus*>()->text().toolTip;
    if (const QRegularExpressionMatch match = tolerance.match(toolTip); match.hasMatch())
      return {QStringLiteral("--tolerance"), match.captured(1)};
    const QRegularExpressionMatch match = step.match(toolTip);
    EXPECT_TRUE(match.hasMatch()) << toolTip.toStdString();
    const double parts = match.captured(2).isEmpty() ? 1.0 : match.captured(2).toDouble();
    return {QStringLiteral("--step"),
            QString::number(match.captured(1).toDouble() / parts, 'g', QLocale::FloatingPointShortest)};
  }

  [[nodiscard]] bool refined() {
    return test::waitUntil([this] { return loop().isIdle() && view().pictureState().refinementEnd; });
  }

  // The picture of the saved scene by the program that is shipped.
  std::vector<float> renderedByTheProgram(const QString& scene, ShadingModel model, const glm::ivec2& size) {
    const QString out = pathTo("rendered.exr");
    QProcess program;
    program.start(QString::fromStdString(test::programPath()),
                  QStringList{QStringLiteral("render"), scene, QStringLiteral("--engine"),
                              QStringLiteral("gl"), QStringLiteral("--model"), QLatin1String(nameOf(model)),
                              QStringLiteral("--size"), QStringLiteral("%1x%2").arg(size.x).arg(size.y),
                              QStringLiteral("-o"), out} +
                      statedSteps());
    EXPECT_TRUE(program.waitForFinished(-1));
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    return samplesOf(out);
  }

  // Waits for the end of refinement after an edit of the curve by hand; what the window then shows must be
  // what the program draws.
  void editAndCompare() {
    const double step = scene().quality.stepVoxels;
    const Scene before = scene();
    dragAPoint();
    ASSERT_NE(scene(), before);
    // Before the first finer strip programs are compiled and the light's overflow is measured.
    ASSERT_TRUE(test::waitUntil([&] {
      const PictureState& state = view().pictureState();
      return state.resting && state.refinementFraction > 0.0;
    }));
    const test::Heart heart;
    ASSERT_TRUE(refined());
    // A turn aims at 30 ms of drawing and a few of showing.
    test::expectShortTurns(heart, "until " + statusText().toStdString(), 100.0);
    for (const SideState& side : view().pictureState().sides) {
      ASSERT_TRUE(side.estimate && side.chance);
      const bool isClose = side.estimate->p99_9 <= halfALevel;
      EXPECT_TRUE(isClose || statusText().contains(QStringLiteral("smallest"))) << statusText().toStdString();
      // Percentile against percentile: the pixel that is farthest off of those drawn, which the status tells,
      // says nothing of it. Of the phantom in 196×365 pixels the percentile is 0.40 levels, estimated 0.50,
      // and one pixel in three thousand is off by 2.0. Two or three of those drawn lie beyond it; as errors
      // fall off with a power of two (accuracy/Tolerance), so few tell it twice too large in 3 of 100 draws.
      EXPECT_LE(side.chance->p99_9, 2.0 * side.estimate->p99_9 + side.chance->own)
          << statusText().toStdString();
    }
    EXPECT_TRUE(statusText().startsWith(QStringLiteral("99.9 % of pixels within")))
        << statusText().toStdString();
    EXPECT_EQ(scene().quality.stepVoxels, step) << "the step that the user chose stays";
    saving().writeScene(pathTo("scene.json"));
    for (int side = 0; side < static_cast<int>(view().pictureState().sides.size()); ++side) {
      const std::optional<Image> shown = view().restingImage(side);
      ASSERT_TRUE(shown);
      const std::vector<float> expected =
          renderedByTheProgram(pathTo("scene.json"), view().sceneOfSide(side).shading.model, shown->size);
      EXPECT_TRUE(samplesOf(*shown) == expected)
          << "side " << side << ", " << statedSteps().join(QLatin1Char(' ')).toStdString();
    }
  }
};

TEST_F(RefinementTest, afterAnEditThePictureBecomesTheOneThatTheCommandLineDrawsWithTheStepsStated) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(rest());
  view().setRefinesAtRest(true);
  editAndCompare();
}

TEST_F(RefinementTest, theCtHeadDoesSoToo) {
  const char* const head = "data/ct_head_cranium/ct_head_cranium.nii.gz";
  LIMN_NEEDS_SHARED(head);
  setLayout(CompareLayout::single);
  ASSERT_TRUE(open(QString::fromStdString((test::sharedFolder() / head).string())));
  ASSERT_TRUE(rest());
  view().setRefinesAtRest(true);
  editAndCompare();
}

TEST_F(RefinementTest, theStatusBarTellsStepAndTimeAtOnceAndTheEstimateSoon) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(idle());
  EXPECT_GT(statedLevels(), 0.0) << statusText().toStdString();
  EXPECT_TRUE(statusText().contains(QStringLiteral("step 1/2 voxel"))) << statusText().toStdString();
  EXPECT_TRUE(statusText().endsWith(QStringLiteral("OpenGL")));
  QTest::mouseClick(window->findChild<QToolButton*>(QStringLiteral("accuracyBadge")), Qt::LeftButton);
  EXPECT_TRUE(labelSays(QStringLiteral("of 255 levels"))) << "where everybody can read it";
  Scene moved = scene();
  moved.camera = orbited(moved.camera, 0.3, 0.0);
  session().setCamera(moved.camera);
  ASSERT_TRUE(test::waitUntil([&] { return !view().pictureState().resting; }));
  QCoreApplication::processEvents();
  EXPECT_GT(statedLevels(), 0.0) << "what was known of the former view is scaled: "
                                 << statusText().toStdString();
}

TEST_F(RefinementTest, aSavedPictureIsTheOneOnScreenWithItsOwnSteps) {
  setLayout(CompareLayout::single);
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  view().setRefinesAtRest(true);
  ASSERT_TRUE(refined());
  const std::optional<Image> shown = view().restingImage(0);
  saving().writePicture(pathTo("saved.exr"));
  EXPECT_TRUE(samplesOf(pathTo("saved.exr")) == samplesOf(*shown));
  const LoadedScene inside = loadScene((folder.path() / "saved.exr").string(), {}, {});
  EXPECT_EQ(inside.scene.quality, view().sceneOfRestingImage(0).quality);
  EXPECT_NE(inside.scene.quality, scene().quality);
}

TEST_F(RefinementTest, itsSwitchIsRemembered) {
  EXPECT_TRUE(Settings(UserFolders::below(folder.path()).settings).refinesAtRest()) << "at first";
  QAction* refine = action(QStringLiteral("Sharpen while nothing &moves"));
  ASSERT_NE(refine, nullptr);
  refine->trigger();
  EXPECT_FALSE(Settings(UserFolders::below(folder.path()).settings).refinesAtRest());
  EXPECT_FALSE(loop().order().refines);
  refine->trigger();
  EXPECT_TRUE(loop().order().refines);
}

TEST_F(RefinementTest, theStatusKeepsItsPlacesAndGivesWayWhereItIsNarrow) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  // So smooth a curve that the scene's own step is exact.
  session().setTransferFunction({1.0, {{-1000.0, {0, 0, 0}, 0.0}, {3000.0, {1, 1, 1}, 0.02}}},
                                {nextGestureId(), QStringLiteral("ramp")});
  ASSERT_TRUE(idle());
  PictureStatus& status = *window->findChild<PictureStatus*>();
  const auto partSaying = [&](const char* text) -> QLabel* {
    for (QLabel* part : status.findChildren<QLabel*>())
      if (part->isVisible() && part->text().contains(QLatin1String(text)))
        return part;
    return nullptr;
  };
  auto* badge = status.findChild<QToolButton*>(QStringLiteral("accuracyBadge"));
  status.resize(status.sizeHint());
  EXPECT_TRUE(badge->text().contains(QStringLiteral("exact"))) << badge->text().toStdString();
  EXPECT_EQ(partSaying("of 255 levels"), nullptr) << "levels are told when they are asked for";
  QTest::mouseClick(badge, Qt::LeftButton);
  status.resize(status.sizeHint());
  EXPECT_NE(partSaying("of 255 levels"), nullptr);
  ASSERT_NE(partSaying("ms"), nullptr);
  const int place = partSaying("ms")->x();
  PictureStatusText text = status.text();
  text.estimate = QStringLiteral("not resolved");
  text.step = QStringLiteral("step 1/8 voxel, refining");
  status.setText(text);
  EXPECT_EQ(partSaying("ms")->x(), place);
  status.resize(status.minimumSizeHint());
  EXPECT_EQ(partSaying("OpenGL"), nullptr);
  EXPECT_TRUE(badge->isVisible());
}

} // namespace
} // namespace limn
