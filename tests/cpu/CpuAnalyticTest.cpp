// SPDX-License-Identifier: GPL-3.0-or-later
// The CPU engine against closed forms, within the tolerances that the file of cases states for floats.
#include "cpu/CpuRenderer.h"
#include "support/RendererRules.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(CpuAnalytic, everyGridExactCaseMeetsItsClosedForm) {
  CpuRenderer renderer;
  test::expectClosedForms(
      [&](const Scene& scene, const glm::ivec2& size) { return renderer.render(scene, size); });
}

} // namespace
} // namespace limn
