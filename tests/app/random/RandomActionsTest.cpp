// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/core/drawing/ProcessCost.h"
#include "app/picture/RegionController.h"
#include "app/random/LastActions.h"
#include "app/random/RandomHand.h"
#include "raycaster/ProgramCache.h"
#include "support/Sanitizers.h"
#include "support/ShortVolume.h"

#include <QDeadlineTimer>
#include <QDockWidget>

#include <malloc.h>

#include <algorithm>
#include <cstdio>

// The program's window, used at random for LIMN_RANDOM_SECONDS (60), from LIMN_RANDOM_SEED (1).

namespace limn {
namespace {

// What the window has filled its caches with (undo steps, volumes of light, pictures of presets) it has in
// five minutes; from then on, or from the first half of less, memory is flat.
constexpr int fillingSeconds = 300;

// What may be added then, MB: what the allocator leaves in pieces, undo steps, glyphs; and for each further
// program that is held what a software driver's compiler keeps of one (30 of them took 165 MB resident).
constexpr double marginMb = 32.0;
constexpr double programMb = 6.0;

// What is held for a while may stand above that as a piece of the time ends, and gives way to other work:
// memory is filled where it has not come back in so many further pieces. What is lost does not come back.
constexpr int furtherPieces = 2;

/// What the process holds at rest.
struct Held {
  double residentMb = 0.0;
  double inUseMb = 0.0; ///< that was asked for and not given back, the programs of a software driver included
  int programs = 0;
};

QStringList warnings;

void noteWarning(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type != QtDebugMsg && type != QtInfoMsg)
    warnings << message;
}

class RandomActions : public test::OpenGlWindow {
protected:
  void SetUp() override {
    // What a thread has freed glibc keeps, up to 64 MB for each of 16 arenas, and malloc_trim leaves it
    // there: after 13,000 actions 123 MB were held and 718 resident. Of a threshold that is set it keeps no
    // more.
    mallopt(M_TRIM_THRESHOLD, 1 << 17);
    OpenGlWindow::SetUp();
    window->resize(1280, 800);
    view().setRefinesAtRest(true);
    // The one thing that a hand would not come back from.
    window->findChild<QAction*>(QStringLiteral("quit"))->setEnabled(false);
    warnings.clear();
    m_before = qInstallMessageHandler(noteWarning);
    const auto write = [this](const char* name, const auto& value) {
      test::writeShorts(folder.path() / name, 32, value);
    };
    write("ball.nrrd", [](const glm::ivec3& v) {
      const double radius = glm::length(glm::dvec3(v) - 16.0);
      return radius < 5.0 ? 1200 : radius < 12.0 ? 40 : v.y >= 29 ? 200 : -1000;
    });
    write("ball.seg.nrrd", [](const glm::ivec3& v) {
      return glm::length(glm::dvec3(v) - 16.0) < 5.0 ? 7 : v.x > 16 && v.z > 16 ? 2 : 0;
    });
  }
  void TearDown() override {
    test::noteAction(QStringLiteral("close the window"));
    window.reset();
    qInstallMessageHandler(m_before);
  }

  // What makes places to go to: every panel, and a volume.
  [[nodiscard]] bool bringBack() {
    test::noteAction(QStringLiteral("bring back every panel and the phantom"));
    QAction& pictureOnly = *window->findChild<QAction*>(QStringLiteral("pictureOnly"));
    if (pictureOnly.isChecked())
      pictureOnly.trigger();
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
      dock->setFloating(false);
      dock->show();
    }
    return open(QStringLiteral("phantom:4"));
  }

  // A ball of labels in the light of a lamp that throws shadows, on a table that is hidden.
  [[nodiscard]] bool bringLabels() {
    test::noteAction(QStringLiteral("bring labels and shadows"));
    auto& regions = *window->findChild<RegionController*>();
    const auto isReady = [&] { return test::waitUntil([&] { return !regions.isBusy(); }); };
    if (!open(pathTo("ball.nrrd")) || !isReady())
      return false;
    regions.openLabels(pathTo("ball.seg.nrrd"));
    Shading lit = scene().shading;
    lit.lightDirection = glm::normalize(glm::dvec3(1, 1, -1));
    lit.shadow.strength = 0.7;
    lit.occlusion.strength = 0.5;
    session().setShading(lit, {nextGestureId(), QStringLiteral("light")});
    return isReady();
  }

  // Acts at random until the time is over, then rests on a fresh phantom.
  Held use(test::RandomHand& hand, int seconds) {
    for (const QDeadlineTimer end(seconds * 1000); !end.hasExpired() && warnings.isEmpty(); ++m_actions) {
      if (m_actions % 300 == 0 && !bringBack())
        break;
      if (m_actions % 300 == 150 && !bringLabels())
        break;
      hand.act();
    }
    hand.leaveOthers();
    const bool isBack = bringBack();
    test::noteAction(QStringLiteral("rest"));
    if (!isBack || !rest())
      ADD_FAILURE() << "the window does not come to rest";
    forgetPeak(); // what nobody holds is none of the program's
    const struct mallinfo2 heap = mallinfo2();
    const bool hasPrograms = view().engine() == Engine::rayCaster;
    return {residentMb(), 1e-6 * static_cast<double>(heap.uordblks + heap.hblkhd),
            hasPrograms ? std::min(compiledPrograms(), static_cast<int>(ProgramCache::most)) : 0};
  }

  int m_actions = 0;

private:
  QtMessageHandler m_before = nullptr;
};

TEST_F(RandomActions, neitherKillNorWarnNorFillTheMemory) {
  const int seconds = qEnvironmentVariableIsSet("LIMN_RANDOM_SECONDS")
                          ? qEnvironmentVariableIntValue("LIMN_RANDOM_SECONDS")
                          : 60;
  const auto seed = static_cast<unsigned>(
      qEnvironmentVariableIsSet("LIMN_RANDOM_SEED") ? qEnvironmentVariableIntValue("LIMN_RANDOM_SEED") : 1);
  test::watchForDeath(seed);
  test::RandomHand hand(seed, *window);
  const int piece = std::clamp(seconds / 2, 1, fillingSeconds);
  const Held first = use(hand, piece);
  std::printf("seed %u: %.0f MB (%.0f in use) with %d programs after %d actions", seed, first.residentMb,
              first.inUseMb, first.programs, m_actions);
  std::fflush(stdout);
  Held held = first;
  const auto isFilled = [&] {
    const int further = std::max(0, held.programs - first.programs);
    return held.residentMb > first.residentMb + marginMb + programMb * further;
  };
  const auto goOn = [&](int pieceSeconds) {
    held = use(hand, pieceSeconds);
    std::printf(", %.0f (%.0f) with %d after %d", held.residentMb, held.inUseMb, held.programs, m_actions);
    std::fflush(stdout);
  };
  for (int left = seconds - piece; left > 0 && warnings.isEmpty(); left -= piece)
    goOn(std::min(left, piece));
  for (int n = 0; n < furtherPieces && isFilled() && !test::isSanitised && warnings.isEmpty(); ++n)
    goOn(piece);
  std::puts("");
  EXPECT_TRUE(window->isVisible());
  ASSERT_TRUE(warnings.isEmpty()) << "seed " << seed << ": " << warnings.join(u'\n').toStdString()
                                  << "\nlast actions:\n"
                                  << test::lastActions();
  EXPECT_GT(m_actions, seconds) << "the window hardly moves";
  if (test::isSanitised)
    GTEST_SKIP() << "checked all but its memory, to which a sanitizer adds its own";
  EXPECT_FALSE(isFilled()) << "seed " << seed << ": more than " << first.residentMb << " MB and what "
                           << held.programs << " programs explain";
}

} // namespace
} // namespace limn
