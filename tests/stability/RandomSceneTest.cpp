// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/RandomScene.h"
#include "stability/CameraFuzz.h"

#include "scene/Error.h"
#include "scene/RayFrame.h"

#include <gtest/gtest.h>

#include <iostream>
#include <set>

namespace limn {
namespace {

TEST(RandomScenes, aHundredThousandCamerasGiveFiniteAndBoundedRays) {
  const CameraFuzzReport report = fuzzCameras(100000, 1);
  std::cout << report.cameras << " cameras, " << report.hits << " of " << report.rays << " rays hit, at most "
            << report.mostSamples << " samples, " << report.seconds << " s\n";
  EXPECT_EQ(report.firstFailure, "");
  EXPECT_EQ(report.cameras, 100000);
  EXPECT_GT(report.hits, report.rays / 4);
  EXPECT_EQ(report.mostSamples, mostSamples);
}

} // namespace
} // namespace limn
