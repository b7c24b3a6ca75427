// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/SceneSource.h"
#include "app/figures/FigureMaker.h"
#include "io/ImageFile.h"
#include "support/ProgramRun.h"
#include "support/ShortVolume.h"
#include "support/TemporaryFolder.h"
#include "widgets/figure/FigurePainting.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

// `limn figure`, called as a user calls it: without a display.

namespace limn {
namespace {

using test::Outcome;

// Drawn by one engine, small enough to take a moment.
constexpr const char* small = " --engine cpu --threads 1 --size 400 --dpi 72 --text 6 --quiet ";

template <class Sample>
struct Pixels {
  int width = 0, height = 0, channels = 0;
  std::vector<Sample> samples;

  const Sample* at(int x, int y) const {
    return samples.data() + (static_cast<std::size_t>(y) * width + x) * channels;
  }
  bool operator==(const Pixels&) const = default;
};

template <class Sample>
Pixels<Sample> pixelsOf(const std::filesystem::path& path, OIIO::TypeDesc type) {
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &wishes);
  if (!input) {
    ADD_FAILURE() << path << ": " << OIIO::geterror();
    return {};
  }
  const OIIO::ImageSpec& spec = input->spec();
  Pixels<Sample> pixels{spec.width, spec.height, spec.nchannels, {}};
  pixels.samples.resize(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
  EXPECT_TRUE(input->read_image(0, 0, 0, input->spec().nchannels, type, pixels.samples.data()));
  return pixels;
}

class FigureCommand : public testing::Test {
protected:
  Outcome run(const std::string& arguments, const std::string& before = {}) {
    return test::runProgram(folder.path(), arguments, before);
  }
  std::string file(const std::string& name) const { return (folder.path() / name).string(); }

  Pixels<std::uint8_t> bytesOf(const std::string& name) const {
    return pixelsOf<std::uint8_t>(folder.path() / name, OIIO::TypeDesc::UINT8);
  }
  Pixels<float> floatsOf(const std::string& name) const {
    return pixelsOf<float>(folder.path() / name, OIIO::TypeDesc::FLOAT);
  }

  void make(const std::string& arguments) {
    const Outcome outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << arguments << "\n" << outcome.err;
  }

  /// A figure that was written, as it was laid out.
  Figure figureIn(const std::string& name) const {
    const auto loaded = loadFigure(file(name), {}, {});
    Figure figure;
    if (!loaded)
      return figure;
    figure.settings = loaded->settings;
    for (const LoadedFigure::Panel& panel : loaded->panels)
      figure.panels.push_back(panelOf(panel));
    return figure;
  }

  /// What a tool prints.
  std::string printedBy(const std::string& command) const {
    const std::string out = file("printed");
    EXPECT_EQ(std::system((command + " > '" + out + "'").c_str()), 0) << command;
    return test::bytesOfFile(out);
  }

  test::TemporaryFolder folder;
};

// Of another patient, whose head lies a metre away: both panels see it from one place.
TEST_F(FigureCommand, panelsThatLookPastAnotherVolumeAreFittedToItAlike) {
  make("figure phantom:16 --model compare -o " + file("both.png") + small);
  std::ofstream(file("other.nrrd"))
      << "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\n"
         "space directions: (9,0,0) (0,9,0) (0,0,9)\nspace origin: (9000,0,0)\n"
         "encoding: ascii\n\n0 900 900 900 900 900 900 900\n";
  SourceOptions options;
  options.volume = file("other.nrrd");
  const auto fitted = loadFigure(file("both.png"), options, {});
  ASSERT_TRUE(fitted);
  ASSERT_EQ(fitted->panels.size(), 2u);
  for (const LoadedFigure::Panel& panel : fitted->panels) {
    EXPECT_FALSE(panel.scene.hasOwnCamera);
    EXPECT_EQ(panel.scene.scene.camera, fitted->panels[0].scene.scene.camera);
    EXPECT_NEAR(panel.scene.scene.camera.target.x, 9004.5, 9.0);
  }
  EXPECT_NE(fitted->panels[0].scene.scene.shading.model, fitted->panels[1].scene.scene.shading.model);
}

TEST_F(FigureCommand, aPanelThatIsNoneIsRefusedBeforeTheWorkWithTheNearest) {
  for (const auto& [word, meant] :
       {std::pair("axiall", "axial"), {"bome", "CT bone"}, {"clasic", "classic"}}) {
    const Outcome outcome = run("figure nowhere.nii --panels classic," + std::string(word) + " -o x.png");
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("did you mean \"" + std::string(meant) + "\"?"), std::string::npos)
        << outcome.err;
  }
}

TEST_F(FigureCommand, panelsAreThePicturesOfRenderBitForBitUnderTheirMarks) {
  // Without the scale, whose length follows what is seen in the middle: no file tells that.
  make("figure phantom:6 --model compare --marks letters,names,orientation,curve,accuracy,region" +
       std::string(small) + "-o " + file("figure.png"));
  const Figure figure = figureIn("figure.png");
  ASSERT_EQ(figure.panels.size(), 2u);
  const FigureLayout layout = figureLayout(figure);
  const QSize size = layout.pictureSize();
  const std::string sized = " --size " + std::to_string(size.width()) + "x" + std::to_string(size.height()) +
                            " --engine cpu --quiet -o ";
  make("render phantom:6 --model classic" + sized + file("panel0.png"));
  make("render phantom:6 --model enhanced" + sized + file("panel1.png"));
  const Pixels<std::uint8_t> whole = bytesOf("figure.png");
  ASSERT_EQ(whole.width, 400);
  for (std::size_t panel = 0; panel < 2; ++panel) {
    const Pixels<std::uint8_t> alone = bytesOf("panel" + std::to_string(panel) + ".png");
    ASSERT_EQ(QSize(alone.width, alone.height), size);
    const std::vector<QRectF> covered = coveredBy(pictureMarks(figure, layout, panel), layout);
    const QPoint corner = layout.pictures[panel].topLeft();
    int compared = 0;
    for (int y = 0; y < alone.height; ++y)
      for (int x = 0; x < alone.width; ++x) {
        const QPointF at = QPointF(corner) + QPointF(x + 0.5, y + 0.5);
        if (std::ranges::any_of(covered, [&](const QRectF& mark) { return mark.contains(at); }))
          continue;
        ++compared;
        ASSERT_TRUE(std::equal(alone.at(x, y), alone.at(x, y) + 3, whole.at(corner.x() + x, corner.y() + y)))
            << "panel " << panel << " at " << x << ", " << y;
      }
    EXPECT_GT(compared, 0.85 * size.width() * size.height());
  }
}

// As its caption does.
TEST_F(FigureCommand, theFileStatesTheAccuracyOfEachPanel) {
  make("figure phantom:8 --panels enhanced,axial,none" + std::string(small) + "-o " + file("told.png"));
  const FigureDocument figure = parseFigure(readImageDescription(file("told.png")), "told.png");
  ASSERT_EQ(figure.panels.size(), 3u);
  EXPECT_FALSE(figure.panels[1].accuracy) << "a slice is exact";
  std::string statement;
  for (const std::size_t panel : {0u, 2u}) {
    const auto& accuracy = figure.panels[panel].accuracy;
    ASSERT_TRUE(accuracy && accuracy->levels);
    EXPECT_NE(accuracy->sentence.find("% of the pixels"), std::string::npos) << accuracy->sentence;
    statement += (panel == 0 ? "a: " : " c: ") + accuracy->sentence;
  }
  const Outcome info = run("info --quiet " + file("told.png"));
  EXPECT_NE(info.out.find("accuracy    " + statement + "\n"), std::string::npos) << info.out;
  make("figure phantom:8 --panels enhanced,none --marks none" + std::string(small) + "-o " +
       file("silent.png"));
  EXPECT_NE(run("info --quiet " + file("silent.png")).out.find("accuracy    not stated\n"),
            std::string::npos);
}

TEST_F(FigureCommand, withoutMarksAWholePanelIsThePictureOfRender) {
  make("figure phantom:6 --panels robust,axial --marks none" + std::string(small) + "-o " +
       file("figure.exr"));
  // The figure opens as its first scene, in the size that it has there.
  make("render " + file("figure.exr") + " --engine cpu --quiet -o " + file("panel.exr"));
  const Figure figure = figureIn("figure.exr");
  const QPoint corner = figureLayout(figure).pictures[0].topLeft();
  const Pixels<float> whole = floatsOf("figure.exr");
  const Pixels<float> alone = floatsOf("panel.exr");
  ASSERT_EQ(QSize(alone.width, alone.height), figureLayout(figure).pictureSize());
  for (int y = 0; y < alone.height; ++y)
    for (int x = 0; x < alone.width; ++x)
      ASSERT_TRUE(std::equal(alone.at(x, y), alone.at(x, y) + 4, whole.at(corner.x() + x, corner.y() + y)));
}

TEST_F(FigureCommand, everyFormatReopensAsTheScenesItShows) {
  make("figure phantom:8 --panels enhanced,coronal,none --names A,B,C --page black" + std::string(small) +
       "-o " + file("first.png"));
  const Figure first = figureIn("first.png");
  ASSERT_EQ(first.panels.size(), 3u);
  EXPECT_EQ(first.panels[0].name, QStringLiteral("A"));
  EXPECT_EQ(first.panels[0].scene.shading.model, ShadingModel::enhanced);
  EXPECT_EQ(first.panels[1].plane, PatientPlane::coronal);
  EXPECT_EQ(first.panels[2].scene.shading.model, ShadingModel::none);
  const Pixels<std::uint8_t> drawn = bytesOf("first.png");
  for (const char* ending : {"png", "tif", "exr", "pdf"}) {
    const std::string again = std::string("again.") + ending;
    make("figure " + file("first.png") + " --engine cpu --threads 1 --quiet -o " + file(again));
    Figure figure = figureIn(again);
    ASSERT_EQ(figure.panels.size(), 3u) << ending;
    EXPECT_EQ(figure.settings, first.settings) << ending;
    for (std::size_t i = 0; i < 3; ++i) {
      figure.panels[i].scene.volume = first.panels[i].scene.volume; // read again
      EXPECT_EQ(figure.panels[i], first.panels[i]) << ending << ", panel " << i;
    }
    make("figure " + file(again) + " --engine cpu --threads 1 --quiet -o " + file("drawn.png"));
    EXPECT_EQ(bytesOf("drawn.png"), drawn) << "drawn again from " << ending;
  }
}

TEST_F(FigureCommand, aPdfHasTextAsTextAndPicturesWithoutLoss) {
  if (std::system("command -v pdftotext >/dev/null && command -v pdfimages >/dev/null") != 0)
    GTEST_SKIP() << "poppler-utils is not installed";
  make("figure phantom:6 --model compare" + std::string(small) + "-o " + file("figure.pdf"));
  const std::string text = printedBy("pdftotext -layout '" + file("figure.pdf") + "' -");
  for (const char* word :
       {"a", "Classic", "b", "Enhanced", "SP 4–32", "cm", "HU", "Opacity", "Not for diagnosis."})
    EXPECT_NE(text.find(word), std::string::npos) << word << " is not in\n" << text;
  // 400 pixels at 72 dpi are 400 points.
  EXPECT_NE(printedBy("pdfinfo '" + file("figure.pdf") + "'").find("Page size:       400 x "),
            std::string::npos);
  printedBy("pdfimages -png '" + file("figure.pdf") + "' '" + file("image") + "'");
  const QSize size = figureLayout(figureIn("figure.pdf")).pictureSize();
  make("render phantom:6 --model classic --engine cpu --quiet --size " + std::to_string(size.width()) + "x" +
       std::to_string(size.height()) + " -o " + file("panel.png"));
  EXPECT_EQ(bytesOf("image-000.png"), bytesOf("panel.png"));
  // It opens: a page of pixels is drawn from it.
  printedBy("pdftoppm -r 72 -png -singlefile '" + file("figure.pdf") + "' '" + file("page") + "'");
  EXPECT_EQ(bytesOf("page.png").width, 400);
}

TEST_F(FigureCommand, aTransparentPageHasHolesAroundThePatient) {
  make("figure phantom:8 --page transparent" + std::string(small) + "-o " + file("figure.png"));
  const Pixels<std::uint8_t> pixels = bytesOf("figure.png");
  ASSERT_EQ(pixels.channels, 4);
  EXPECT_EQ(pixels.at(0, 0)[3], 0) << "the page";
  const QRect picture = figureLayout(figureIn("figure.png")).pictures[0];
  EXPECT_EQ(pixels.at(picture.left() + 2, picture.top() + 2)[3], 0) << "beside the head";
  EXPECT_GT(pixels.at(picture.center().x(), picture.center().y())[3], 200) << "the head";
}

TEST_F(FigureCommand, marksAreWhatIsAskedFor) {
  make("figure phantom:8 --marks names,note" + std::string(small) + "-o " + file("figure.png"));
  const FigureSettings settings = figureIn("figure.png").settings;
  for (const FigureMark mark : figureMarks)
    EXPECT_EQ(settings.shows(mark), mark == FigureMark::names || mark == FigureMark::notForDiagnosis);
}

TEST_F(FigureCommand, sizesAreTypedInPixelsOrCentimetres) {
  make("figure phantom:16 --engine cpu --size 5x4cm --dpi 127 --marks none --quiet -o " + file("a.png"));
  // 5 cm · 127 dpi / 2.54 = 250 pixels.
  EXPECT_EQ(bytesOf("a.png").width, 250);
  EXPECT_EQ(bytesOf("a.png").height, 200);
  make("figure phantom:16 --engine cpu --size 300x200 --marks none --quiet -o " + file("b.png"));
  EXPECT_EQ(bytesOf("b.png").width, 300);
  EXPECT_EQ(bytesOf("b.png").height, 200);
}

TEST_F(FigureCommand, errorsAreOneSentenceAndLeaveNoFile) {
  struct Case {
    std::string arguments;
    int status;
    std::string because;
  };
  const std::string out = " -o " + file("figure.png");
  const std::vector<Case> cases{
      {"figure phantom:16 --size 40000 --marks none" + out, 2, "40000 pixels wide"},
      {"figure phantom:16 --size 20mm" + out, 2, "--size"},
      {"figure phantom:16 -o " + file("figure.bmp"), 2, ".png, .tif, .exr or .pdf"},
      {"figure phantom:16 --panels wrong" + out, 2, "wrong"},
      {"figure phantom:16 --marks frame" + out, 2, "--marks"},
      {"figure phantom:16 --panels axial,axial,axial,axial,axial" + out, 2, "at most 4"},
      {"figure phantom:16 phantom:16 --panels axial" + out, 2, "--panels"},
      {"figure phantom:16 --names A,B" + out, 2, "--names"},
      {"figure phantom:16 --size 300x80" + out, 2, "no room"},
      {"figure " + file("missing.nii") + out, 3, "missing.nii"}};
  for (const Case& one : cases) {
    const Outcome outcome = run(one.arguments);
    EXPECT_EQ(outcome.status, one.status) << one.arguments;
    EXPECT_NE(outcome.err.find(one.because), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(file("figure.png")));
  }
}

TEST_F(FigureCommand, memoryIsToldBeforeAndRefusedWhereThereIsNone) {
  FigureLayout layout;
  layout.size = QSize(30000, 30000);
  layout.pictures = {QRect(0, 0, 30000, 30000)};
  // While it is drawn, two pictures of 16 bytes a pixel and one of 4: 30,000² · 36 = 32.4 GB.
  EXPECT_EQ(bytesToMake(layout, FigurePixels::bytes), 32.4e9);
  EXPECT_EQ(memoryNote(layout, FigurePixels::bytes)
                .find("The figure has 30000 × 30000 pixels and takes 32.4 GB of memory while it is made"),
            0u);
  FigureLayout modest = layout;
  modest.size = QSize(2000, 1000);
  modest.pictures = {QRect(0, 0, 2000, 1000)};
  EXPECT_EQ(memoryNote(modest, FigurePixels::bytes), "");
  if (hasMemoryFor(layout, FigurePixels::bytes))
    GTEST_SKIP() << "this machine has memory for 30,000 × 30,000 pixels";
  const Outcome outcome =
      run("figure phantom:16 --size 30000x30000 --marks none --engine cpu -o " + file("large.png"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("Choose a smaller figure or close other programs."), std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(file("large.png")));
}

TEST_F(FigureCommand, aFullDiskIsSaidAndLeavesTheOldFile) {
  for (const char* ending : {"png", "tif", "exr", "pdf"}) {
    const std::string path = file(std::string("figure.") + ending);
    test::writeBytes(path, "old");
    // Room for 4 blocks of 512 bytes; the program is not ended by the signal.
    const Outcome outcome =
        run("figure phantom:16 --engine cpu --size 300 --quiet -o " + path, "trap '' XFSZ; ulimit -f 4;");
    EXPECT_EQ(outcome.status, 1) << ending << outcome.err;
    EXPECT_NE(outcome.err.find("Cannot write"), std::string::npos) << outcome.err;
    EXPECT_EQ(test::bytesOfFile(path), "old") << ending;
  }
}

TEST_F(FigureCommand, aPanelThatShowsNothingIsSaid) {
  // Nothing of the phantom is as dense: all that the curve makes visible lies above 20,000 HU.
  test::writeBytes(file("empty.json"),
                   R"({"limn_scene": 1, "volume": "phantom:16", "transfer_function": {"points": [
                   {"value": 20000, "color": [1, 1, 1], "opacity": 0}, {"value": 21000, "color": [1, 1, 1], "opacity": 1}]}})");
  const Outcome outcome = run("figure phantom:16 " + file("empty.json") +
                              " --engine cpu --size 300 --dpi 72 -o " + file("figure.png"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("Panel b shows nothing: everything in view is transparent."), std::string::npos)
      << outcome.err;
}

TEST_F(FigureCommand, labelsWithCurvesOfTheirOwnStandInALegend) {
  // Two halves of a cube of one value, red and blue; the labels are called after the files of their masks.
  const auto write = [&](const std::string& name, const auto& value) {
    test::writeShorts(folder.path() / name, 8, value);
  };
  write("v.nrrd", [](const glm::ivec3&) { return 300; });
  write("masks/Liver.nrrd", [](const glm::ivec3& v) { return v.x < 4 ? 1 : 0; });
  write("masks/Spleen.nrrd", [](const glm::ivec3& v) { return v.x < 4 ? 0 : 1; });
  const auto look = [](const std::string& color) {
    return R"({"unit_distance_mm": 1.0, "points": [{"value": 0, "color": )" + color + R"(, "opacity": 0.4},
             {"value": 900, "color": )" +
           color + R"(, "opacity": 0.4}]})";
  };
  std::ofstream(folder.path() / "s.json")
      << R"({"limn_scene": 1, "volume": "v.nrrd", "keep": {"labels": "masks", "looks": {"1": )"
      << look("[1, 0, 0]") << R"(, "2": )" << look("[0, 0, 1]") << "}}}";
  make("figure " + file("s.json") + std::string(small) + "-o " + file("figure.png"));
  const Figure figure = figureIn("figure.png");
  EXPECT_TRUE(figure.settings.shows(FigureMark::labels));
  const FigureLayout layout = figureLayout(figure);
  ASSERT_EQ(layout.labelLegends.size(), 1u);
  const QRectF place = layout.labelLegends.front().place;
  const Pixels<std::uint8_t> pixels = bytesOf("figure.png");
  int red = 0, blue = 0;
  for (int y = static_cast<int>(place.top()); y < place.bottom(); ++y)
    for (int x = static_cast<int>(place.left()); x < place.right(); ++x) {
      const std::uint8_t* pixel = pixels.at(x, y);
      red += pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 0 ? 1 : 0;
      blue += pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 255 ? 1 : 0;
    }
  EXPECT_GT(red, 4);
  EXPECT_EQ(red, blue) << "a square of each";
  make("figure " + file("s.json") + " --marks names,note" + std::string(small) + "-o " + file("without.png"));
  EXPECT_LT(bytesOf("without.png").height, pixels.height);
  if (std::system("command -v pdftotext >/dev/null") != 0)
    GTEST_SKIP() << "poppler-utils is not installed";
  make("figure " + file("s.json") + std::string(small) + "-o " + file("figure.pdf"));
  const std::string text = printedBy("pdftotext -layout '" + file("figure.pdf") + "' -");
  for (const char* word : {"Liver", "Spleen"})
    EXPECT_NE(text.find(word), std::string::npos) << word << " is not in\n" << text;
}

} // namespace
} // namespace limn
