// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/DriverRecovery.h"

#include <QApplication>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

// The exit status by which CTest knows a skipped test.
constexpr int skipped = 77;

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (!std::getenv("DISPLAY") && !std::getenv("QT_QPA_PLATFORM")) {
    std::puts("Skipped: these tests open windows, and there is neither a display nor xvfb-run to make one.");
    return skipped;
  }
  QSurfaceFormat::setDefaultFormat(limn::limnSurfaceFormat());
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
