// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/FigureLayout.h"

#include "planes/PlaneGrid.h"
#include "scene/basics/Error.h"
#include "scene/regions/LabelColor.h"
#include "scene/volume/Phantom.h"
#include "widgets/figure/FigurePainting.h"
#include "widgets/figure/FigureText.h"
#include "widgets/figure/LabelLegend.h"

#include <QDataStream>
#include <QLineF>
#include <QPainter>
#include <QPicture>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace limn {
namespace {

std::shared_ptr<const Volume> volume() {
  static const std::shared_ptr<const Volume> phantom = phantomVolume({16.0});
  return phantom;
}

Figure figureOf(std::size_t panels) {
  Figure figure;
  for (std::size_t i = 0; i < panels; ++i) {
    FigurePanel panel;
    panel.scene.volume = volume();
    panel.scene.camera = defaultCamera(volume()->grid());
    panel.scene.transferFunction.points = {{0.0, {1.0, 0.0, 0.0}, 0.0}, {1000.0, {1.0, 1.0, 1.0}, 1.0}};
    panel.name = usualName(panel);
    figure.panels.push_back(panel);
  }
  return figure;
}

void hide(Figure& figure, FigureMark mark) {
  figure.settings.marks[static_cast<std::size_t>(mark)] = false;
}

TEST(FigureLayout, hasTheSizeInCentimetresAtItsDotsPerInch) {
  Figure figure = figureOf(2);
  figure.settings.width = 17.0;
  figure.settings.height = 10.0;
  figure.settings.dotsPerInch = 300.0;
  // 17 cm / 2.54 · 300 = 2007.9, 10 cm / 2.54 · 300 = 1181.1.
  EXPECT_EQ(figureLayout(figure).size, QSize(2008, 1181));
  figure.settings.unit = FigureSettings::Unit::pixels;
  figure.settings.width = 640.0;
  figure.settings.height = 480.0;
  EXPECT_EQ(figureLayout(figure).size, QSize(640, 480));
}

TEST(FigureLayout, givesEveryPanelTheSameWholePixelsAndNothingOverlaps) {
  for (std::size_t count = 1; count <= mostPanels; ++count)
    for (const bool sharesCurve : {true, false}) {
      Figure figure = figureOf(count);
      if (!sharesCurve)
        figure.panels.back().scene.transferFunction.points.back().opacity = 0.5;
      const FigureLayout layout = figureLayout(figure);
      ASSERT_EQ(layout.pictures.size(), count);
      EXPECT_EQ(layout.legends.size(), sharesCurve || count == 1 ? 1u : count);
      std::vector<QRectF> places(layout.headings);
      for (const QRect& picture : layout.pictures) {
        EXPECT_EQ(picture.size(), layout.pictureSize());
        places.emplace_back(picture);
      }
      for (const LegendPlace& legend : layout.legends)
        places.push_back(legend.place);
      places.push_back(layout.notes);
      const QRectF page(QPointF(0.0, 0.0), layout.size);
      for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_TRUE(page.contains(places[i])) << count << " panels, place " << i;
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_FALSE(places[i].intersects(places[k])) << count << " panels, places " << i << " and " << k;
      }
    }
}

TEST(FigureLayout, picturesHaveTheShapeAskedForWhereNoHeightIsGiven) {
  Figure figure = figureOf(4);
  for (const double aspect : {0.5, 1.0, 1.6}) {
    figure.settings.panelAspect = aspect;
    const QSize size = figureLayout(figure).pictureSize();
    EXPECT_NEAR(size.height(), size.width() / aspect, 0.5);
  }
}

TEST(FigureLayout, withoutMarksIsPictures) {
  Figure figure = figureOf(1);
  figure.settings.marks.fill(false);
  const FigureLayout layout = figureLayout(figure);
  EXPECT_TRUE(layout.headings.empty());
  EXPECT_TRUE(layout.legends.empty());
  EXPECT_TRUE(layout.notes.isEmpty());
  const int margin = layout.pictures[0].left();
  EXPECT_EQ(layout.size, layout.pictureSize() + QSize(2 * margin, 2 * margin));
}

TEST(FigureText, aPanelWithAnotherNameTellsItsModelBesideIt) {
  FigurePanel panel = figureOf(1).panels.front();
  panel.scene.shading.model = ShadingModel::enhanced;
  panel.name = QStringLiteral("CT bone");
  EXPECT_TRUE(panelDetails(panel).startsWith(QStringLiteral("Enhanced · SP ")))
      << panelDetails(panel).toStdString();
  for (const char* name : {"Enhanced", "CT bone, enhanced"}) {
    panel.name = QLatin1String(name);
    EXPECT_TRUE(panelDetails(panel).startsWith(QStringLiteral("SP "))) << name << " tells it";
  }
  panel.name = QStringLiteral("CT lung");
  panel.scene.projection = Projection::mip;
  EXPECT_EQ(panelDetails(panel), usualName(panel)) << "what its rays show";
  panel.name = usualName(panel);
  EXPECT_EQ(panelDetails(panel), QString());
}

TEST(FigureLayout, scaledKeepsItsProportions) {
  Figure figure = figureOf(2);
  const FigureLayout full = figureLayout(figure);
  figure.settings = scaledBy(figure.settings, 0.25);
  const FigureLayout small = figureLayout(figure);
  EXPECT_NEAR(small.size.width(), 0.25 * full.size.width(), 1.0);
  // Heights are sums of some ten lengths that are rounded each.
  EXPECT_NEAR(small.size.height(), 0.25 * full.size.height(), 10.0);
  EXPECT_NEAR(small.textPixels, 0.25 * full.textPixels, 0.01);
}

void expectRefused(const Figure& figure, const std::string& because) {
  try {
    figureLayout(figure);
    FAIL() << "laid out";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::usage);
    EXPECT_NE(std::string(error.what()).find(because), std::string::npos) << error.what();
  }
}

TEST(FigureLayout, refusesWhatCannotBeDrawn) {
  Figure figure = figureOf(1);
  figure.settings.width = 300.0; // at 300 dpi 35,433 pixels
  expectRefused(figure, "35433 pixels wide");
  figure.settings.width = 0.1; // 12 pixels
  expectRefused(figure, "12 pixels wide");
  figure.settings.width = 17.0;
  figure.settings.height = 1.0; // legend, notes and heading take more
  expectRefused(figure, "no room");
  figure.settings.height.reset();
  figure.settings.panelAspect = 1e-3;
  expectRefused(figure, "pixels high");
}

TEST(FigureText, saysOfEachNoteWhereItHolds) {
  Figure figure = figureOf(2);
  figure.panels[0].errorLevels = 0.42;
  figure.panels[1].errorLevels = 1.5;
  figure.panels[1].scene.camera.projection = Camera::Projection::orthographic;
  EXPECT_EQ(
      notesOf(figure).toStdString(),
      "Estimated within 0.42 (a), 1.5 (b) of 255 levels of the exact picture. Scale at the depth of the "
      "turning point (perspective: a). Not for diagnosis.");
  figure.panels[1] = figure.panels[0];
  EXPECT_EQ(notesOf(figure).toStdString(),
            "Estimated within 0.42 of 255 levels of the exact picture. Scale at the depth of the "
            "turning point (perspective). Not for diagnosis.");
  for (FigurePanel& panel : figure.panels)
    panel.isStated = true;
  EXPECT_EQ(
      notesOf(figure).toStdString(),
      "99.9 % of pixels within 0.42 of 255 levels of the exact picture (95 % sure). Scale at the depth of "
      "the turning point (perspective). Not for diagnosis.");
  hide(figure, FigureMark::accuracy);
  hide(figure, FigureMark::scaleBar);
  hide(figure, FigureMark::notForDiagnosis);
  EXPECT_EQ(notesOf(figure), QString());
}

TEST(FigureText, tellsThePathsOfPhysicalLightAndTheirError) {
  Figure figure = figureOf(2);
  figure.settings.marks.fill(false);
  figure.settings.marks[static_cast<std::size_t>(FigureMark::accuracy)] = true;
  figure.panels[0].errorLevels = 0.42;
  figure.panels[1].paths = PanelPaths{256, 1.234};
  EXPECT_EQ(
      notesOf(figure).toStdString(),
      "Estimated within 0.42 (a) of 255 levels of the exact picture. Random paths: 256 a pixel, standard "
      "error 1.3 of 255 levels RMS (b).");
  figure.panels[1].paths = PanelPaths{1, {}};
  figure.panels[0] = figure.panels[1];
  EXPECT_EQ(notesOf(figure).toStdString(), "Random paths: 1 a pixel.");
}

TEST(FigureText, tellsWhereNormalsAreSmooth) {
  Figure figure = figureOf(2);
  figure.settings.marks.fill(false);
  figure.settings.marks[static_cast<std::size_t>(FigureMark::region)] = true;
  figure.panels[0].scene.shading.gradientSmoothing = 17.5; // voxels are 16 mm apart
  EXPECT_EQ(notesOf(figure), QStringLiteral("Normals smoothed by 17.5 mm (a)."));
  figure.panels[1].scene.shading = figure.panels[0].scene.shading;
  EXPECT_EQ(notesOf(figure), QStringLiteral("Normals smoothed by 17.5 mm."));
  figure.panels[0].plane = PatientPlane::axial; // a slice has none
  EXPECT_EQ(notesOf(figure), QStringLiteral("Normals smoothed by 17.5 mm (b)."));
}

TEST(FigureText, tellsARegionThatIsHidden) {
  Figure figure = figureOf(2);
  figure.settings.marks.fill(false);
  figure.settings.marks[static_cast<std::size_t>(FigureMark::region)] = true;
  EXPECT_EQ(notesOf(figure), QString());
  const glm::ivec3 dims = volume()->grid().dims;
  std::vector<std::uint8_t> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 1);
  places.front() = 0;
  figure.panels[0].scene.keep = bodyRegion(dims, places);
  EXPECT_EQ(notesOf(figure), QStringLiteral("Body only: table hidden (a)."));
  figure.panels[1].scene.keep = figure.panels[0].scene.keep;
  EXPECT_EQ(notesOf(figure), QStringLiteral("Body only: table hidden."));
  figure.panels[1].scene.crop.upper.z = 0.5;
  EXPECT_EQ(notesOf(figure), QStringLiteral("Body only: table hidden. Cropped (b)."));
  figure.panels[0].scene.keep = {};
  figure.panels[0].scene.crop = figure.panels[1].scene.crop;
  EXPECT_EQ(notesOf(figure), QStringLiteral("Cropped. Body only: table hidden (b)."));
  figure.panels[0].plane = PatientPlane::axial;
  EXPECT_EQ(notesOf(figure), QStringLiteral("Body only: table hidden (b). Cropped (b)."));
  figure.panels[0].scene.keep = figure.panels[1].scene.keep;
  EXPECT_EQ(notesOf(figure),
            QStringLiteral("The line is around what is kept (a). Body only: table hidden (b). "
                           "Cropped (b)."));
  figure.panels[0].planes.outlinesRegion = false;
  EXPECT_EQ(notesOf(figure), QStringLiteral("Body only: table hidden (b). Cropped (b)."));
}

TEST(FigureText, croppedIsSaidUnlessNothingThatIsSeenIsCutAway) {
  Figure figure = figureOf(1);
  figure.panels[0].scene.crop.lower.x = 0.1;
  EXPECT_TRUE(notesOf(figure).contains(QStringLiteral("Cropped.")));
  figure.panels[0].cropHidesNothing = false;
  EXPECT_TRUE(notesOf(figure).contains(QStringLiteral("Cropped.")));
  figure.panels[0].cropHidesNothing = true;
  EXPECT_FALSE(notesOf(figure).contains(QStringLiteral("Cropped")));
}

TEST(PictureMarks, inPerspectiveTheScaleHoldsAtTheDepthOfTheTarget) {
  FigurePanel panel = figureOf(1).panels.front();
  Camera& camera = panel.scene.camera;
  ASSERT_EQ(camera.projection, Camera::Projection::perspective);
  const double atTarget = mmPerPixelOf(panel, {200, 200});
  camera.target = 0.5 * (camera.position + camera.target);
  EXPECT_NEAR(mmPerPixelOf(panel, {200, 200}), 0.5 * atTarget, 1e-12 * atTarget);
}

TEST(PictureMarks, scaleBarIsAsLongAsItSays) {
  Figure figure = figureOf(1);
  Camera& camera = figure.panels[0].scene.camera;
  camera.projection = Camera::Projection::orthographic;
  camera.heightMm = 250.0;
  const FigureLayout layout = figureLayout(figure);
  const auto scale = pictureMarks(figure, layout, 0).scale;
  ASSERT_TRUE(scale);
  const double mm = 250.0 / layout.pictureSize().height() * scale->bar.width();
  // At most 30 % of the picture's 250 mm: 50 mm is the longest round length.
  EXPECT_EQ(scale->text, QStringLiteral("5\u00a0cm"));
  EXPECT_NEAR(mm, 50.0, 1e-6);
}

TEST(FigurePainting, drawsWhatWasMeasuredInSlicesAndPicturesAndNowhereElse) {
  Figure figure = figureOf(2);
  const glm::dvec3 middle = middleVoxelMm(volume()->grid());
  const glm::dvec3 across(60.0, 0.0, 0.0);
  figure.panels[1].plane = PatientPlane::axial;
  figure.panels[1].firstWindow = {0.0, 2000.0};
  for (FigurePanel& panel : figure.panels)
    panel.measurements = {
        {Measurement::Kind::distance, PatientPlane::axial, {middle - across, middle + across}},
        {Measurement::Kind::distance, PatientPlane::coronal, {middle - across, middle + across}, {}, false}};
  const FigureLayout layout = figureLayout(figure);
  std::vector<QImage> pictures(2, QImage(layout.pictureSize(), QImage::Format_RGB32));
  for (QImage& picture : pictures)
    picture.fill(QColor(40, 80, 40));
  const QImage image = figureImage(figure, layout, pictures);
  for (std::size_t panel = 0; panel < 2; ++panel) {
    const std::optional<FigureMeasures> measures = pictureMarks(figure, layout, panel).measures;
    ASSERT_TRUE(measures);
    ASSERT_EQ(measures->marks.size(), 1u) << "the other one is hidden, and lies in another plane";
    const MeasureShape& shape = measures->marks.front().shape;
    EXPECT_TRUE(shape.text.startsWith(QStringLiteral("120"))) << shape.text.toStdString();
    // 120 mm at the scale of the panel; in perspective both ends lie about as deep as the target.
    const double pixels = measures->scale * QLineF(shape.places[0], shape.places[1]).length();
    const double mm = mmPerPixelOf(figure.panels[panel], layout.pictureSize());
    EXPECT_NEAR(pixels * mm, 120.0,
                panel == 1 ? 1e-6
                           : 120.0 * 16.0 / glm::length(middle - figure.panels[0].scene.camera.position));
    const QPointF between =
        measures->picture.topLeft() + measures->scale * (0.4 * shape.places[0] + 0.6 * shape.places[1]);
    int white = 0; // a line with a light core, wherever between two rows it lies
    for (int row = -3; row <= 3; ++row)
      white += image.pixelColor(between.toPoint() + QPoint(0, row)).lightness() > 200;
    EXPECT_GT(white, 0) << "panel " << panel;
    const std::vector<QRectF> covered = coveredBy(pictureMarks(figure, layout, panel), layout);
    const QRect& place = layout.pictures[panel];
    for (int y = place.top(); y <= place.bottom(); ++y)
      for (int x = place.left(); x <= place.right(); ++x) {
        const bool isCovered = std::ranges::any_of(
            covered, [&](const QRectF& mark) { return mark.contains(QPointF(x + 0.5, y + 0.5)); });
        ASSERT_TRUE(isCovered || image.pixelColor(x, y) == QColor(40, 80, 40)) << x << ", " << y;
      }
  }
  hide(figure, FigureMark::measurements);
  EXPECT_FALSE(pictureMarks(figure, layout, 0).measures);
}

TEST(FigurePainting, changesNoPixelOfAPictureOutsideItsMarks) {
  for (const FigureSettings::Page page : figurePages) {
    Figure figure = figureOf(2);
    figure.settings.page = page;
    const FigureLayout layout = figureLayout(figure);
    std::vector<QImage> pictures;
    for (int panel = 0; panel < 2; ++panel) {
      QImage noise(layout.pictureSize(), QImage::Format_RGBA8888);
      for (int y = 0; y < noise.height(); ++y)
        for (int x = 0; x < noise.width(); ++x)
          noise.setPixelColor(x, y, QColor((x * 7 + y * 13 + panel) % 256, (x * y) % 256, (x + 3 * y) % 256));
      pictures.push_back(noise);
    }
    const QImage image = figureImage(figure, layout, pictures);
    ASSERT_EQ(image.size(), layout.size);
    for (std::size_t panel = 0; panel < 2; ++panel) {
      const std::vector<QRectF> covered = coveredBy(pictureMarks(figure, layout, panel), layout);
      ASSERT_EQ(covered.size(), 6u) << "four letters, a bar and its text";
      const QRect& place = layout.pictures[panel];
      int compared = 0;
      int painted = 0;
      for (int y = 0; y < place.height(); ++y)
        for (int x = 0; x < place.width(); ++x) {
          const QPoint at = place.topLeft() + QPoint(x, y);
          const bool isSame = image.pixelColor(at) == pictures[panel].pixelColor(x, y);
          const bool isCovered = std::ranges::any_of(
              covered, [&](const QRectF& mark) { return mark.contains(QPointF(at) + QPointF(0.5, 0.5)); });
          compared += !isCovered;
          painted += !isSame;
          ASSERT_TRUE(isSame || isCovered) << x << ", " << y;
        }
      EXPECT_GT(compared, 0.9 * place.width() * place.height());
      EXPECT_GT(painted, 100) << "the marks are there";
    }
  }
}

TEST(FigurePainting, curvesThatAreComparedHaveOneAxis) {
  Figure figure = figureOf(2);
  figure.panels[1].scene.transferFunction.points = {{-600.0, {1.0, 0.0, 0.0}, 0.0},
                                                    {400.0, {1.0, 1.0, 1.0}, 1.0}};
  const FigureLayout layout = figureLayout(figure);
  ASSERT_EQ(layout.legends.size(), 2u) << "curves that differ have a legend each";
  const ValueRange first = legendRange(figure, layout, 0);
  EXPECT_EQ(first, legendRange(figure, layout, 1));
  // 0..1000 and -600..400, each with 6 % of 1000 beside it.
  EXPECT_EQ(first, (ValueRange{-660.0, 1060.0}));
}

// Labels in turns, every one but the first (the background) with a look of its own: opaque in a colour
// of its number.
Region turnsWithLooks(int labels) {
  const glm::ivec3& dims = volume()->grid().dims;
  std::vector<std::uint8_t> places;
  for (int voxel = 0; voxel < dims.x * dims.y * dims.z; ++voxel)
    places.push_back(static_cast<std::uint8_t>(voxel % labels));
  std::vector<Label> names;
  std::map<std::size_t, TransferFunction> looks;
  for (int n = 0; n < labels; ++n) {
    names.push_back({n, "organ " + std::to_string(n), glm::dvec3(1.0)});
    if (n > 0)
      looks[static_cast<std::size_t>(n)] = {1.0, {{0.0, {n / 255.0, 0.0, 1.0}, 0.5}}};
  }
  return withLooks({Region::Kind::labels, "seg", std::make_shared<const LabelMap>(dims, places, names),
                    std::vector<double>(static_cast<std::size_t>(labels), 1.0)},
                   looks);
}

TEST(LabelLegend, namesTheLabelsThatAreShownByCurvesOfTheirOwn) {
  Figure figure = figureOf(1);
  FigurePanel& panel = figure.panels.front();
  EXPECT_TRUE(panelLabels(panel).rows.empty());
  panel.scene.keep = turnsWithLooks(6);
  panel.scene.keep.weights[2] = 0.0;
  panel.scene.keep.lookOf[4] = 0;
  std::vector<LabelRow> rows = panelLabels(panel).rows;
  ASSERT_EQ(rows.size(), 3u) << "not the hidden one, nor that with the scene's curve";
  EXPECT_EQ(rows[0], (LabelRow{QColor(1, 0, 255), QStringLiteral("organ 1")}));
  EXPECT_EQ(rows[2], (LabelRow{QColor(5, 0, 255), QStringLiteral("organ 5")}));
  panel.scene.projection = Projection::mip;
  EXPECT_TRUE(panelLabels(panel).rows.empty()) << "which takes the scene's curve";
  panel.plane = PatientPlane::axial;
  rows = panelLabels(panel).rows;
  ASSERT_EQ(rows.size(), 4u) << "a slice outlines them, whoever's curve they have";
  EXPECT_EQ(rows[0], (LabelRow{QColor(1, 0, 255), QStringLiteral("organ 1")})) << "in one colour everywhere";
  EXPECT_EQ(rows[2], (LabelRow{QColor(255, 255, 255), QStringLiteral("organ 4")})) << "that of its file";
  panel.planes.outlinesRegion = false;
  EXPECT_TRUE(panelLabels(panel).rows.empty()) << "plain grey";
  panel.planes.isTinted = true;
  EXPECT_EQ(panelLabels(panel).rows.size(), 3u);
}

TEST(LabelLegend, endsAfterTwelveWithHowManyMoreThereAre) {
  Figure figure = figureOf(1);
  figure.panels.front().scene.keep = turnsWithLooks(13);
  EXPECT_EQ(panelLabels(figure.panels.front()).rows.size(), 12u);
  figure.panels.front().scene.keep = turnsWithLooks(30);
  const std::vector<LabelRow> rows = panelLabels(figure.panels.front()).rows;
  ASSERT_EQ(rows.size(), 13u);
  EXPECT_EQ(rows[11].text, QStringLiteral("organ 12"));
  EXPECT_EQ(rows.back(), (LabelRow{std::nullopt, QStringLiteral("and 17 more")}));
}

TEST(LabelLegend, theCurvesOfLabelsAreDrawnInTheirColoursAndTold) {
  Figure figure = figureOf(1);
  FigurePanel& panel = figure.panels.front();
  EXPECT_TRUE(figureLabels(figure).front().curves.empty());
  EXPECT_FALSE(notesOf(figure).contains(QStringLiteral("curves of their own")));
  const TransferFunction rising{1.0, {{-500.0, {0, 1, 0}, 0.0}, {2000.0, {0, 1, 0}, 1.0}}};
  panel.scene.keep = withLooks(turnsWithLooks(4), {{2, rising}});
  panel.scene.keep.weights[3] = 0.25;
  const std::vector<LabelCurve> curves = figureLabels(figure).front().curves;
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves.front(), (LabelCurve{QColor(0, 255, 0), rising}));
  const FigureLayout layout = figureLayout(figure);
  const ValueRange range = legendRange(figure, layout, 0);
  EXPECT_TRUE(range.lowest < -500.0 && range.highest > 2000.0) << "all of it is seen";
  const QImage drawn = figureImage(figure, layout, {});
  const QRect legend = layout.legends.front().place.toAlignedRect().intersected(drawn.rect());
  int green = 0;
  for (int y = legend.top(); y <= legend.bottom(); ++y)
    for (int x = legend.left(); x <= legend.right(); ++x)
      green += drawn.pixel(x, y) == QColor(0, 255, 0).rgb() ? 1 : 0;
  EXPECT_GT(green, legend.width() / 8) << "along the axis";
  EXPECT_TRUE(notesOf(figure).contains(QStringLiteral("the other curve is of the rest")));
  EXPECT_TRUE(notesOf(figure).contains(QStringLiteral("1 label hidden or faded: organ 3.")));
  hide(figure, FigureMark::labels);
  EXPECT_TRUE(figureLabels(figure).front().curves.empty()) << "nothing would name them";
  EXPECT_TRUE(notesOf(figure).contains(QStringLiteral("Labels have curves of their own.")));
}

TEST(LabelLegend, whatIsSaidOfTheCurvesHoldsWhereOnlySomeAreDrawn) {
  Figure figure = figureOf(1);
  FigurePanel& panel = figure.panels.front();
  const auto says = [&figure](const char* text) { return notesOf(figure).contains(QLatin1String(text)); };
  panel.scene.keep = turnsWithLooks(13);
  EXPECT_TRUE(says("Curves in colour are of the labels listed in these colours; the other curve is of the "
                   "rest."));
  panel.scene.keep = turnsWithLooks(30);
  EXPECT_EQ(figureLabels(figure).front().curves.size(), 12u);
  EXPECT_TRUE(says("those of 17 more are not drawn, and the other curve is of the rest."));
  // A tinted slice lists all that it outlines, also those that the scene's curve is of.
  panel.plane = PatientPlane::axial;
  panel.planes.isTinted = true;
  panel.scene.keep = turnsWithLooks(6);
  panel.scene.keep.lookOf[4] = 0;
  const PanelLabels labels = panelLabels(panel);
  EXPECT_EQ(labels.rows.size(), 5u);
  EXPECT_EQ(labels.curves.size(), 4u);
  EXPECT_TRUE(says("Curves in colour are of the labels listed in these colours; the other curve is of the "
                   "rest."));
}

// What is painted, stroke for stroke. Pixels of one painting differ by a level with where they lie in memory
// (Qt rounds a run's ends in another way than what its registers hold at once).
QByteArray strokes(const Figure& figure, const FigureLayout& layout) {
  QPicture picture;
  QPainter painter(&picture);
  paintFigure(painter, figure, layout, {});
  painter.end();
  return {picture.data(), static_cast<qsizetype>(picture.size())};
}

TEST(FigurePainting, everyNumberOfAnAxisIsPaintedBesideItsUnit) {
  Figure figure = figureOf(1);
  // With 6 % beside them 1000 is the axis's end.
  figure.panels[0].scene.transferFunction.points = {{0.0, {1.0, 1.0, 1.0}, 0.0},
                                                    {944.0, {1.0, 1.0, 1.0}, 1.0}};
  const FigureLayout layout = figureLayout(figure);
  const QByteArray painted = strokes(figure, layout);
  for (const QString& text : {QStringLiteral("1000"), QStringLiteral("HU")}) {
    QByteArray written;
    QDataStream stream(&written, QIODevice::WriteOnly);
    stream << text;
    EXPECT_TRUE(painted.contains(written)) << text.toStdString();
  }
}

// Looking at voxels takes time: whoever has found the labels of a figure has them laid out and painted.
TEST(LabelLegend, labelsThatAreKnownAreNotLookedForAgain) {
  Figure figure = figureOf(1);
  figure.panels.front().scene.keep = turnsWithLooks(4);
  const FigureLabels labels = figureLabels(figure);
  const FigureLayout found = figureLayout(figure);
  EXPECT_EQ(found.labels, labels);
  const FigureLayout known = figureLayout(figure, labels);
  EXPECT_EQ(strokes(figure, known), strokes(figure, found));
  const FigureLayout none = figureLayout(figure, FigureLabels(1));
  EXPECT_TRUE(none.labelLegends.empty());
  EXPECT_NE(strokes(figure, none), strokes(figure, found));
  Figure withoutLabels = figure;
  withoutLabels.panels.front().scene.keep = {};
  hide(figure, FigureMark::region);
  hide(withoutLabels, FigureMark::region);
  const FigureLayout plain = figureLayout(withoutLabels);
  EXPECT_EQ(strokes(figure, none), strokes(withoutLabels, plain));
}

TEST(LabelLegend, aColourIsTheMeanOfWhatTheCurveShowsOfTheVoxels) {
  Grid grid;
  grid.dims = {4, 1, 1};
  Scene scene;
  scene.volume = std::make_shared<const Volume>(grid, std::vector<float>{0.0f, 10.0f, 20.0f, 90.0f},
                                                Rescale{}, std::nullopt, VolumeInfo{});
  // Three voxels of the label: clear green, red of 0.2, blue of 0.6. The fourth is another's.
  const TransferFunction look{
      1.0, {{0.0, {0, 1, 0}, 0.0}, {10.0, {1, 0, 0}, 0.2}, {20.0, {0, 0, 1}, 0.6}, {90.0, {1, 1, 1}, 1.0}}};
  scene.keep = withLooks({Region::Kind::labels,
                          "seg",
                          std::make_shared<const LabelMap>(grid.dims, std::vector<std::uint8_t>{1, 1, 1, 0},
                                                           std::vector<Label>{{0, "", {}}, {1, "", {}}}),
                          {1.0, 1.0}},
                         {{1, look}});
  const glm::dvec3 color = shownColor(*scene.volume, scene.keep, 1);
  EXPECT_NEAR(color.r, 0.25, 1e-12);
  EXPECT_NEAR(color.g, 0.0, 1e-12);
  EXPECT_NEAR(color.b, 0.75, 1e-12);
}

TEST(LabelLegend, standsBelowThePicturesOnceWhereAllHaveTheSame) {
  for (const std::size_t count : {1u, 2u, 4u})
    for (const bool isShared : {true, false}) {
      Figure figure = figureOf(count);
      figure.settings.dotsPerInch = 150.0;
      const FigureLayout without = figureLayout(figure);
      for (FigurePanel& panel : figure.panels)
        panel.scene.keep = turnsWithLooks(8);
      if (!isShared)
        figure.panels.back().scene.keep.weights[3] = 0.0;
      const FigureLayout layout = figureLayout(figure);
      ASSERT_EQ(layout.labelLegends.size(), isShared || count == 1 ? 1u : count);
      EXPECT_EQ(layout.pictureSize(), without.pictureSize());
      EXPECT_GT(layout.size.height(), without.size.height());
      std::vector<QRectF> places(layout.headings);
      for (const QRect& picture : layout.pictures)
        places.emplace_back(picture);
      for (const LegendPlace& legend : layout.legends)
        places.push_back(legend.place);
      for (const LegendPlace& legend : layout.labelLegends)
        places.push_back(legend.place);
      places.push_back(layout.notes);
      const QRectF page(QPointF(0.0, 0.0), layout.size);
      for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_TRUE(page.contains(places[i])) << count << " panels, place " << i;
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_FALSE(places[i].intersects(places[k])) << count << " panels, places " << i << " and " << k;
      }
      // Every label's colour is on the page, in a square of its legend; beside it only its curve has it.
      const QImage drawn = figureImage(figure, layout, {});
      for (const LabelRow& row : panelLabels(figure.panels.front()).rows) {
        int found = 0;
        for (int y = 0; y < drawn.height(); ++y)
          for (int x = 0; x < drawn.width(); ++x)
            if (drawn.pixel(x, y) == row.color->rgb()) {
              const auto isIn = [&](const LegendPlace& legend) {
                return legend.place.contains(QPointF(x, y));
              };
              if (std::ranges::any_of(layout.legends, isIn))
                continue;
              ASSERT_TRUE(std::ranges::any_of(layout.labelLegends, isIn)) << x << ' ' << y;
              ++found;
            }
        // The side of one is 0.95 of the text's height, its frame included.
        EXPECT_GT(found, 0.5 * std::pow(0.95 * noteScale * layout.textPixels, 2.0)) << row.text.toStdString();
      }
      hide(figure, FigureMark::labels);
      EXPECT_TRUE(figureLayout(figure).labelLegends.empty());
      // What the notes say of labels may take them a line more.
      const FigureLayout hidden = figureLayout(figure);
      EXPECT_EQ(hidden.size.width(), without.size.width());
      EXPECT_NEAR(hidden.size.height() - hidden.notes.height(),
                  without.size.height() - without.notes.height(), 1.0);
    }
}

} // namespace
} // namespace limn
