// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "widgets/view/pictures/RestWork.h"

#include <algorithm>

// What the view tells of effects and does while its pictures rest, in a real window.

namespace limn {
namespace {

using test::ViewHost;

// Keeps what the view told last.
struct Told {
  explicit Told(CompareView& view) {
    QObject::connect(&view, &CompareView::told, [this](const ViewNews& news) {
      changes += news.effects != rows || news.effectsOf != picture ? 1 : 0;
      rows = news.effects;
      picture = news.effectsOf;
      times = news.times;
    });
  }
  bool isOn(const std::string& name) const {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const EffectRow& row) { return row.name == name && row.isOn; });
  }
  int changes = 0;
  std::vector<EffectRow> rows;
  QString picture;
  EffectTimes times;
};

[[nodiscard]] bool idle(ViewHost& host) {
  return test::waitUntil([&] { return host.isIdle(); });
}

TEST(AtRest, tellsTheEffectsOfTheRightPictureAndOfEveryChange) {
  ViewHost host;
  Told told(host.view);
  host.view.setCompareLayout(CompareLayout::sideBySide);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return told.changes == 1; }));
  EXPECT_EQ(told.picture, QStringLiteral("Enhanced (right)"));
  EXPECT_TRUE(told.isOn("opacity_map"));
  EXPECT_FALSE(told.isOn("fog"));
  host.scene.fog = {Fog::Mode::exp, glm::dvec3(0.1), 0.001, 0.0, 0.0};
  host.view.setScene(host.scene);
  ASSERT_TRUE(test::waitUntil([&] { return told.isOn("fog"); }));
  host.scene.camera.position *= 1.01;
  const int changes = told.changes;
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(told.changes, changes) << "another camera calls for the same";
  host.view.setScene({});
  ASSERT_TRUE(test::waitUntil([&] { return told.rows.empty(); }));
}

TEST(AtRest, measuresTheCostsOnRequestAndStopsWhenTheSceneChanges) {
  ViewHost host({200, 120});
  Told told(host.view);
  host.showPhantom(8.0);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(idle(host));
  EXPECT_TRUE(told.times.costs.empty()) << "nobody asked";
  host.view.measureEffects();
  ASSERT_TRUE(test::waitUntil([&] { return told.times.fraction > 0.2; }));
  EXPECT_TRUE(told.times.isMeasuring);
  host.scene.camera.position *= 1.01;
  host.view.setScene(host.scene);
  ASSERT_TRUE(test::waitUntil([&] { return told.times == EffectTimes{}; }));
  ASSERT_TRUE(idle(host));
  EXPECT_EQ(told.times, EffectTimes{}) << "it does not begin again by itself";
  const QImage before = host.view.currentPicture(0);
  host.view.measureEffects();
  ASSERT_TRUE(test::waitUntil([&] { return !told.times.costs.empty(); }));
  ASSERT_EQ(told.times.costs.size(), told.rows.size());
  for (std::size_t i = 0; i < told.rows.size(); ++i)
    EXPECT_EQ(told.times.costs[i].has_value(), told.rows[i].isOn) << told.rows[i].name;
  EXPECT_EQ(told.times.size, QSize(200, 120)) << "small pictures are measured as they are";
  EXPECT_FALSE(told.times.method.isEmpty());
  EXPECT_GT(told.times.wholeMs, 0.0);
  EXPECT_EQ(host.view.currentPicture(0), before);
}

TEST(AtRest, aResizeWhileCostsAreMeasuredMeasuresThoseOfTheNewPicture) {
  ViewHost host({200, 120});
  Told told(host.view);
  host.showPhantom(8.0);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(idle(host));
  host.view.measureEffects();
  ASSERT_TRUE(test::waitUntil([&] { return told.times.fraction > 0.2; }));
  host.view.resize(160, 120); // the camera may follow
  ASSERT_TRUE(test::waitUntil([&] { return !told.times.costs.empty() && !told.times.isMeasuring; }));
  EXPECT_EQ(told.times.size, QSize(160, 120));
}

TEST(AtRest, labelsGetContrastAndOverflowOfLitPictures) {
  ViewHost host;
  host.view.setCompareLayout(CompareLayout::sideBySide);
  host.view.setModels(ShadingModel::none, ShadingModel::enhanced);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(idle(host));
  const std::vector<SideState> sides = host.view.pictureState().sides;
  ASSERT_EQ(sides.size(), 2u);
  EXPECT_GT(sides[0].contrast.value_or(0.0), 0.0);
  EXPECT_FALSE(sides[0].overflow) << "without light nothing overflows";
  EXPECT_TRUE(sides[1].overflow);
  host.scene.camera.position *= 1.01;
  host.view.setScene(host.scene);
  QCoreApplication::processEvents();
  for (const SideState& side : host.view.pictureState().sides)
    EXPECT_FALSE(side.overflow) << "of a picture that is no longer shown";
}

TEST(RestWork, measuresPicturesOfTheSameShapeThatFitIntoATurn) {
  EXPECT_EQ(smallerSize({640, 480}, 256), glm::ivec2(256, 192));
  EXPECT_EQ(smallerSize({480, 640}, 256), glm::ivec2(192, 256));
  EXPECT_EQ(smallerSize({100, 50}, 256), glm::ivec2(100, 50));
  EXPECT_EQ(smallerSize({4000, 1}, 256), glm::ivec2(256, 1));
}

} // namespace
} // namespace limn
