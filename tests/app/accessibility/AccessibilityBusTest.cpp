// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/accessibility/PrivateBus.h"
#include "support/Waiting.h"

#include <QRegularExpression>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

// What assistive technology finds in the shipped program, asked on a bus of its own as a screen reader asks,
// and not inside the process.

namespace limn {
namespace {

using test::BusObject;
using test::ProgramOnPrivateBus;

// Bits of AT-SPI's states (atspi-constants.h).
constexpr int focused = 12;
constexpr int showing = 25;

using test::Role;

bool hasRole(const BusObject& object, Role role) {
  return object.role() == role;
}

class OnTheBus : public testing::Test {
protected:
  // One program for all tests; each finds the curve as the one before left it.
  static void SetUpTestSuite() {
    s_program = std::make_unique<ProgramOnPrivateBus>(QStringList{QStringLiteral("phantom:4")});
    if (s_program->missing().isEmpty())
      s_canvas = s_program->waitForObject([](const BusObject& object) {
        return hasRole(object, Role::canvas) && !object.children().empty();
      });
  }
  static void TearDownTestSuite() {
    s_canvas.reset();
    s_program.reset();
  }

  void SetUp() override {
    if (!s_program->missing().isEmpty())
      GTEST_SKIP() << s_program->missing().toStdString();
    ASSERT_TRUE(s_canvas) << "the program never showed a curve with points";
  }

  static BusObject root() { return *s_program->waitForProgram(); }
  static const BusObject& canvas() { return *s_canvas; }
  static BusObject point(std::size_t index) { return canvas().children().at(index); }
  static std::vector<BusObject> all(Role role) {
    return findAll(root(), [role](const BusObject& object) { return hasRole(object, role); });
  }

  inline static std::unique_ptr<ProgramOnPrivateBus> s_program;
  inline static std::optional<BusObject> s_canvas;
};

TEST_F(OnTheBus, theCurveHasAChildForEachPointWithNamePlaceValueAndOpacity) {
  EXPECT_FALSE(canvas().name().isEmpty());
  const QRect plot = canvas().place();
  const std::vector<BusObject> points = canvas().children();
  ASSERT_GE(points.size(), 2u);
  double former = -1e300;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].role(), Role::slider);
    EXPECT_EQ(points[i].name(), QStringLiteral("Point %1 of %2").arg(i + 1).arg(points.size()));
    EXPECT_TRUE(plot.contains(points[i].place())) << i;
    EXPECT_EQ(points[i].parent().path(), canvas().path());
    ASSERT_TRUE(points[i].number());
    EXPECT_GE(*points[i].number(), former); // from left to right
    former = *points[i].number();
    // The phantom is in HU.
    EXPECT_TRUE(points[i].description().contains(QRegularExpression(QStringLiteral("\\d.HU, opacity [01]"))))
        << points[i].description().toStdString();
    const std::vector<BusObject> parts = points[i].children();
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].name(), QStringLiteral("Opacity of point %1").arg(i + 1));
    ASSERT_TRUE(parts[0].number());
    EXPECT_GE(*parts[0].number(), 0.0);
    EXPECT_LE(*parts[0].number(), 1.0);
  }
}

TEST_F(OnTheBus, aValueSetMovesThePointAndWhatIsSaidOfIt) {
  const BusObject second = point(1);
  const double lowest = *second.number(QStringLiteral("MinimumValue"));
  const double highest = *second.number(QStringLiteral("MaximumValue"));
  ASSERT_LT(lowest, highest);
  const double wanted = std::round(0.25 * lowest + 0.75 * highest);
  const QRect before = second.place();
  const double former = *second.number();
  ASSERT_NE(wanted, former);
  second.setNumber(wanted);
  ASSERT_TRUE(test::waitUntil([&] { return second.number() == wanted; }));
  EXPECT_EQ(second.place().center().x() > before.center().x(), wanted > former);
  EXPECT_EQ(second.place().center().y(), before.center().y());
  // It stops where its neighbour is.
  second.setNumber(highest + 1000.0);
  ASSERT_TRUE(test::waitUntil([&] { return second.number() == highest; }));
}

TEST_F(OnTheBus, anOpacitySetMovesThePointUp) {
  const BusObject second = point(1);
  const BusObject opacity = second.children().at(0);
  const int before = second.place().center().y();
  const double wanted = *opacity.number() < 0.5 ? 0.875 : 0.125;
  opacity.setNumber(wanted);
  ASSERT_TRUE(test::waitUntil([&] { return opacity.number() == wanted; }));
  EXPECT_EQ(second.place().center().y() < before, wanted > 0.5);
  EXPECT_TRUE(second.description().endsWith(QStringLiteral("opacity %1").arg(wanted)))
      << second.description().toStdString();
}

TEST_F(OnTheBus, whatChangesIsTold) {
  test::BusEvents told(s_program->bus(), QStringLiteral("object:property-change:accessible-value"));
  // The program learns of the wish when it comes to it, and tells nothing of what changed before.
  const auto isToldOf = [&told](const BusObject& object, double one, double other) {
    return test::waitUntil([&] {
      object.setNumber(object.number() == one ? other : one);
      return told.paths().contains(object.path());
    });
  };
  const BusObject third = point(2), opacity = third.children().at(0);
  const double lowest = *third.number(QStringLiteral("MinimumValue"));
  const double highest = *third.number(QStringLiteral("MaximumValue"));
  ASSERT_LT(lowest, highest);
  ASSERT_TRUE(isToldOf(third, lowest, highest));
  EXPECT_FALSE(told.paths().contains(opacity.path()));
  EXPECT_FALSE(told.paths().contains(point(0).path()));
  ASSERT_TRUE(isToldOf(opacity, 0.25, 0.75));
}

TEST_F(OnTheBus, aPointThatIsGivenTheFocusHasIt) {
  point(0).act();
  ASSERT_TRUE(test::waitUntil([] { return point(0).hasState(focused); }));
  EXPECT_FALSE(point(1).hasState(focused));
  EXPECT_FALSE(canvas().hasState(focused));
}

TEST_F(OnTheBus, everySliderHasANameAndANumberWithinItsLimits) {
  const std::vector<BusObject> sliders = all(Role::slider);
  EXPECT_GE(sliders.size(), 20u);
  for (const BusObject& slider : sliders) {
    const std::string name = slider.name().toStdString();
    EXPECT_FALSE(name.empty()) << slider.path().toStdString();
    ASSERT_TRUE(slider.number()) << name;
    EXPECT_LT(*slider.number(QStringLiteral("MinimumValue")), *slider.number(QStringLiteral("MaximumValue")))
        << name;
  }
  const auto step = std::ranges::find_if(
      sliders, [](const BusObject& slider) { return slider.name() == QStringLiteral("Step"); });
  ASSERT_NE(step, sliders.end());
  EXPECT_TRUE(step->description().contains(QStringLiteral("voxel"))) << step->description().toStdString();
}

TEST_F(OnTheBus, aRangeIsAGroupOfTwoNamedSliders) {
  const auto ranges = findAll(root(), [](const BusObject& object) {
    return hasRole(object, Role::panel) && object.name() == QStringLiteral("Highlight sharpness (SP)");
  });
  ASSERT_FALSE(ranges.empty());
  const std::vector<BusObject> handles = ranges.front().children();
  ASSERT_EQ(handles.size(), 2u);
  EXPECT_NE(handles[0].name(), handles[1].name());
  EXPECT_EQ(*handles[0].number(QStringLiteral("MaximumValue")), *handles[1].number());
}

TEST_F(OnTheBus, aSliderSetChangesItsFieldToo) {
  const auto stepsOf = [](Role role) {
    return findAll(root(), [role](const BusObject& object) {
      return hasRole(object, role) && object.name() == QStringLiteral("Step");
    });
  };
  const std::vector<BusObject> sliders = stepsOf(Role::slider), fields = stepsOf(Role::spinButton);
  ASSERT_EQ(sliders.size(), 1u);
  ASSERT_EQ(fields.size(), 1u);
  ASSERT_NE(fields[0].number(), 1.5);
  sliders[0].setNumber(1.5);
  ASSERT_TRUE(test::waitUntil([&] { return fields[0].number() == 1.5; }));
  EXPECT_EQ(sliders[0].number(), 1.5);
}

// The window goes on while it is asked: what it took away since it was listed has no role any more.
TEST_F(OnTheBus, everyButtonHasAName) {
  const auto isButton = [](const BusObject& object) {
    constexpr std::array roles{Role::pushButton, Role::checkBox, Role::radioButton, Role::toggleButton};
    return std::ranges::find(roles, object.role()) != roles.end();
  };
  std::size_t named = 0;
  for (const BusObject& button : findAll(root(), isButton)) {
    const bool isNamed = !button.name().isEmpty();
    named += isNamed ? 1 : 0;
    if (!isNamed && isButton(button))
      ADD_FAILURE() << button.path().toStdString() << " in " << button.parent().name().toStdString()
                    << (button.hasState(showing) ? "" : " (hidden)");
  }
  EXPECT_GE(named, 30u);
}

} // namespace
} // namespace limn
