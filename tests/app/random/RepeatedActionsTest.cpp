// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/panels/presets/PresetController.h"
#include "app/picture/CutController.h"
#include "app/picture/RegionController.h"
#include "support/Sanitizers.h"
#include "support/ShortVolume.h"

#include <QContextMenuEvent>
#include <QDialog>
#include <QDockWidget>
#include <QPixmapCache>

#include <malloc.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>

// One thing done again and again in the program's window, and undone: nothing of it may be left. Random
// actions tell whether memory is flat; this tells what fills it where it is not. LIMN_REPEATED_TIMES does
// each more often and judges bytes, too, which few times do not tell from what buffers take;
// LIMN_REPEATED_ONLY=one,two does those alone.

namespace limn {
namespace {

// What is kept from the first times on (menus that are made once, letters, programs) is no loss.
constexpr int timesBefore = 2;

// What is lost is lost in each of so many rows; what a cache or a buffer takes is not.
constexpr int rowsOfTimes = 3;

std::ptrdiff_t bytesInUse() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<std::ptrdiff_t>(heap.uordblks + heap.hblkhd);
}

// The least that is lost of a thing that shows: a line of text.
std::ptrdiff_t bytesOfALabel() {
  const auto make = [] { return std::make_unique<QLabel>(QStringLiteral("a word or two")); };
  make(); // what all labels share
  constexpr int count = 16;
  std::vector<std::unique_ptr<QLabel>> labels;
  labels.reserve(count);
  const std::ptrdiff_t before = bytesInUse();
  for (int n = 0; n < count; ++n)
    labels.push_back(make());
  return (bytesInUse() - before) / count;
}

class RepeatedActions : public test::OpenGlWindow {
protected:
  struct Held {
    std::ptrdiff_t bytes = 0;   ///< that were asked for and not given back
    std::ptrdiff_t objects = 0; ///< of Qt, in all windows
  };

  void SetUp() override {
    OpenGlWindow::SetUp();
    const int asked = qEnvironmentVariableIntValue("LIMN_REPEATED_TIMES");
    m_times = asked > 0 ? asked : 5;
    // Icons that are made for a moment fill it up to its own limit of 10 MB.
    QPixmapCache::setCacheLimit(0);
    window->resize(1, 1); // as small as it can be: what pictures cost tells nothing here
    // Those of presets are drawn in spare time, of which a busy machine has none.
    window->findChild<QDockWidget*>(QStringLiteral("presetDock"))->hide();
    // Large enough that a copy of their voxels is no trifle.
    const auto write = [this](const char* name, const auto& value) {
      test::writeShorts(folder.path() / name, size, value);
    };
    const auto radius = [](const glm::ivec3& v) { return glm::length(glm::dvec3(v) - 0.5 * size) / size; };
    write("ball.nrrd", [&](const glm::ivec3& v) {
      return radius(v) < 0.2 ? 1200 : radius(v) < 0.4 ? 40 : -1000;
    });
    write("other.nrrd", [&](const glm::ivec3& v) { return radius(v) < 0.3 ? 900 : -1000; });
    write("core.seg.nrrd", [&](const glm::ivec3& v) { return radius(v) < 0.2 ? 7 : 0; });
    ASSERT_TRUE(openAlone(pathTo("ball.nrrd")));
    ASSERT_TRUE(rest());
  }
  void TearDown() override { QPixmapCache::setCacheLimit(m_pixmapsBefore); }

  void trigger(const char* name) {
    auto* action = window->findChild<QAction*>(QLatin1String(name));
    ASSERT_TRUE(action && action->isEnabled()) << name;
    action->trigger();
    QCoreApplication::processEvents();
  }

  RegionController& regions() { return *window->findChild<RegionController*>(); }
  [[nodiscard]] bool ready() {
    const auto& cutting = *window->findChild<CutController*>();
    return test::waitUntil([&] { return !regions().isBusy() && !cutting.isBusy(); });
  }

  void leaveOthers() {
    while (QWidget* popup = QApplication::activePopupWidget())
      popup->close();
    for (QWidget* other : QApplication::topLevelWidgets())
      if (other != window.get() && other->isVisible() && !qobject_cast<QDockWidget*>(other))
        other->close();
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

  void askForMenu(QWidget& of) {
    const QPoint at = of.rect().center();
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, of.mapToGlobal(at));
    QCoreApplication::sendEvent(&of, &event);
    QTest::mouseClick(&of, Qt::RightButton, {}, at);
    QCoreApplication::processEvents();
    EXPECT_NE(QApplication::activePopupWidget(), nullptr) << "no menu";
    leaveOthers();
  }

  // An edit that is seen and taken back.
  void edit(const std::function<void(Scene&)>& change) {
    Scene next = scene();
    change(next);
    session().edit(next, {nextGestureId(), QStringLiteral("edit")});
    EXPECT_TRUE(rest());
    undo().undo();
  }

  void drawScissors() {
    trigger("tool-scissors");
    const QPoint middle = view().mapTo(window.get(), view().logicalRect(0).center().toPoint());
    QWindow* handle = window->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, middle + QPoint(-20, -20));
    for (const QPoint& at : {QPoint(20, -20), QPoint(20, 20), QPoint(-20, 20)})
      QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, middle + at);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, middle + QPoint(-20, 20));
    QCoreApplication::processEvents();
    EXPECT_TRUE(ready());
    EXPECT_EQ(scene().keep.cuts.size(), 1u);
    EXPECT_TRUE(rest());
    undo().undo();
    trigger("tool-rotate");
  }

  Held heldAtRest() {
    leaveOthers();
    EXPECT_TRUE(rest() && ready());
    Held held;
    for (const QWidget* top : QApplication::topLevelWidgets())
      held.objects += 1 + top->findChildren<QObject*>().size();
    held.bytes = bytesInUse();
    return held;
  }

  void expectNothingLeft(const QString& of, const std::function<void()>& act) {
    const QString only = qEnvironmentVariable("LIMN_REPEATED_ONLY");
    if (!only.isEmpty() && !only.split(QLatin1Char(',')).contains(of))
      return;
    for (int n = 0; n < timesBefore; ++n)
      act();
    Held before = heldAtRest();
    std::array<Held, rowsOfTimes> grown;
    for (Held& row : grown) {
      for (int n = 0; n < m_times; ++n)
        act();
      const Held after = heldAtRest();
      row = {after.bytes - before.bytes, after.objects - before.objects};
      before = after;
    }
    const auto bytes = std::ranges::min(grown, {}, &Held::bytes).bytes;
    const auto objects = std::ranges::min(grown, {}, &Held::objects).objects;
    std::printf("%-22s %8td bytes, %td objects a time; %.1f MB\n", of.toUtf8().constData(), bytes / m_times,
                objects / m_times, 1e-6 * static_cast<double>(before.bytes));
    std::fflush(stdout);
    EXPECT_LE(objects, 0) << of.toStdString() << ": lost in each of " << rowsOfTimes << " rows of "
                          << m_times;
    // A sanitizer keeps what was given back.
    if (!test::isSanitised && qEnvironmentVariableIsSet("LIMN_REPEATED_TIMES")) {
      EXPECT_LT(bytes, m_times * bytesOfALabel()) << of.toStdString();
    }
  }

  static constexpr int size = 48;
  int m_times = 0;
  const int m_pixmapsBefore = QPixmapCache::cacheLimit();
};

TEST_F(RepeatedActions, leaveNothingOfTheVolumeBehind) {
  expectNothingLeft("a curve", [&] {
    dragAPoint();
    undo().undo();
  });
  expectNothingLeft("shadows", [&] {
    edit([](Scene& next) {
      next.shading.shadow.strength = 0.7;
      next.shading.lightDirection = glm::dvec3(0.6, 0.8, 0.0);
    });
  });
  expectNothingLeft("smooth normals",
                    [&] { edit([](Scene& next) { next.shading.gradientSmoothing = 1.5; }); });
  expectNothingLeft("a projection", [&] { edit([](Scene& next) { next.projection = Projection::mip; }); });
  expectNothingLeft("a cut", [&] { drawScissors(); });
  expectNothingLeft("labels", [&] {
    regions().openLabels(pathTo("core.seg.nrrd"));
    EXPECT_TRUE(ready());
    EXPECT_EQ(scene().keep.kind, Region::Kind::labels);
    EXPECT_TRUE(rest());
    undo().undo();
  });
  expectNothingLeft("a second picture", [&] {
    setLayout(CompareLayout::sideBySide);
    EXPECT_TRUE(rest());
    setLayout(CompareLayout::single);
  });
  expectNothingLeft("a measurement", [&] {
    session().setMeasurements({{Measurement::Kind::distance, std::nullopt, {{2, 2, 2}, {20, 20, 20}}}},
                              {nextGestureId(), QStringLiteral("measure")});
    undo().undo();
  });
  expectNothingLeft("a named view", [&] {
    session().setViews({{"one", scene().camera}}, QStringLiteral("keep"));
    undo().undo();
  });
  expectNothingLeft("presets", [&] {
    for (const Preset& preset : window->findChild<PresetController*>()->fittedPresets()) {
      session().usePreset(preset, {nextGestureId(), QString::fromStdString(preset.name)});
      undo().undo();
    }
  });
  expectNothingLeft("no volume", [&] {
    trigger("closeVolume");
    EXPECT_TRUE(open(pathTo("ball.nrrd")) && rest());
  });
  expectNothingLeft("a missing file", [&] {
    EXPECT_TRUE(open(pathTo("nothing.nrrd")));
    EXPECT_TRUE(messages().isVisible());
  });
}

// Each of these two still leaves 2 kB a time, and nobody knows where.
TEST_F(RepeatedActions, leaveNothingOfSlicesAndOfVolumesBehind) {
  expectNothingLeft("slices", [&] {
    trigger("planes-picture_and_three");
    trigger("planes-picture");
  });
  expectNothingLeft("another volume", [&] {
    const std::weak_ptr<const Volume> before = scene().volume;
    EXPECT_TRUE(open(pathTo("other.nrrd")) && rest());
    EXPECT_TRUE(test::waitUntil([&] { return before.expired(); })) << "somebody holds it";
    EXPECT_TRUE(open(pathTo("ball.nrrd")) && rest());
  });
}

TEST_F(RepeatedActions, nobodyHoldsTheVolumeBefore) {
  setLayout(CompareLayout::sideBySide);
  trigger("planes-picture_and_three");
  ASSERT_TRUE(rest());
  setLayout(CompareLayout::single);
  trigger("planes-picture");
  ASSERT_TRUE(rest());
  const std::weak_ptr<const Volume> before = scene().volume;
  ASSERT_TRUE(open(pathTo("other.nrrd")) && rest());
  EXPECT_TRUE(test::waitUntil([&] { return before.expired(); })) << "somebody holds it";
}

TEST_F(RepeatedActions, leaveNothingThatShowsBehind) {
  for (const char* dialog : {"settings", "shortcuts", "about", "guide", "saveFigure", "saveTurntable",
                             "exportSurface", "suggest", "stability", "tour"})
    expectNothingLeft(QLatin1String(dialog), [&] {
      trigger(dialog);
      leaveOthers();
    });
  expectNothingLeft("menu of the picture", [&] { askForMenu(view()); });
  expectNothingLeft("menu of the curve", [&] { askForMenu(*curves().valueEditor()->canvas()); });
  for (const char* twice : {"float-shadingDock", "pictureOnly", "cropBox", "orientationCube"})
    expectNothingLeft(QLatin1String(twice), [&] {
      trigger(twice);
      trigger(twice);
    });
  expectNothingLeft("themes", [&] {
    trigger("theme-light");
    trigger("theme-dark");
  });
}

} // namespace
} // namespace limn
