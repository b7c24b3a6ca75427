// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/FigureFile.h"

#include "scene/basics/Error.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

FigureDocument twoPanels() {
  FigureDocument figure;
  figure.settings.unit = FigureSettings::Unit::pixels;
  figure.settings.width = 1200.5;
  figure.settings.height = 800.0;
  figure.settings.dotsPerInch = 150.0;
  figure.settings.panelAspect = 1.25;
  figure.settings.textPoints = 7.5;
  figure.settings.page = FigureSettings::Page::transparent;
  figure.settings.marks[static_cast<std::size_t>(FigureMark::curve)] = false;
  Scene scene;
  scene.transferFunction.points = {{0.0, {1.0, 0.5, 0.25}, 0.0}, {100.0, {1.0, 1.0, 1.0}, 0.5}};
  scene.shading.model = ShadingModel::robust;
  figure.panels.push_back({"Knochen \xC3\xBC",
                           std::nullopt,
                           {},
                           documentOf(scene, "head.nii.gz"),
                           PictureAccuracy{0.42, "99.9 % of the pixels lie within 0.42 levels.", {}}});
  PlaneSettings planes;
  planes.crosshairMm = {1.0, -2.5, 3.0};
  planes.isTinted = true;
  figure.panels.push_back({"Coronal", PatientPlane::coronal, planes, documentOf(scene, "head.nii.gz")});
  return figure;
}

TEST(FigureFile, isReadAsItWasWritten) {
  const FigureDocument figure = twoPanels();
  const std::string text = figureToJson(figure);
  EXPECT_TRUE(looksLikeFigure(text));
  EXPECT_FALSE(looksLikeScene(text));
  EXPECT_EQ(parseFigure(text, "figure.png"), figure);
  for (const char character : text)
    ASSERT_LT(static_cast<unsigned char>(character), 128) << "image descriptions are ASCII";
}

void expectRefused(const std::string& text, const std::string& because) {
  try {
    parseFigure(text, "figure.png");
    FAIL() << "read: " << text;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(because), std::string::npos) << error.what();
  }
}

TEST(FigureFile, isRefusedByNameWhereItIsWrong) {
  expectRefused(R"({"limn_figure": 2, "panels": []})", "figure of a newer Limn");
  expectRefused(R"({"limn_figure": 1})", "panels");
  expectRefused(R"({"limn_figure": 1, "panels": []})", "1 to 4");
  expectRefused(R"({"limn_figure": 1, "panels": [{"name": "a"}]})", "panels.0.scene");
  expectRefused(
      R"({"limn_figure": 1, "colour": "red", "panels": [{"scene": {"limn_scene": 1, "volume": "a"}}]})",
      "colour");
  expectRefused(R"({"limn_figure": 1, "marks": {"frame": true}, "panels": []})", "frame");
  expectRefused(R"({"limn_figure": 1, "size": {"dpi": 5}, "panels": []})", "dpi");
  expectRefused("{", "figure.png");
}

} // namespace
} // namespace limn
