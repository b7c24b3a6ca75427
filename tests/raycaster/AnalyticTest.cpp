// SPDX-License-Identifier: GPL-3.0-or-later
// The GLSL ray caster against closed forms, within the tolerances that the file of cases states for floats.
#include "raycaster/RayCaster.h"
#include "support/GlTest.h"
#include "support/RendererRules.h"

namespace limn {
namespace {

using RayCasterAnalytic = test::GlTest;

TEST_F(RayCasterAnalytic, everyGridExactCaseMeetsItsClosedForm) {
  if (isAnotherRasteriser())
    GTEST_SKIP() << "GALLIUM_DRIVER names none that this driver has; it draws with " << rendererName();
  RayCaster caster;
  test::expectClosedForms(
      [&](const Scene& scene, const glm::ivec2& size) { return caster.render(scene, size); });
}

} // namespace
} // namespace limn
