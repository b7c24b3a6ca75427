// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper says of its Figs. 3 and 4 (section 6 and 7), as figures on a real CT head.
#include "raycaster/RayCaster.h"
#include "scene/PictureFigures.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/TestData.h"

#include <iostream>
#include <tuple>

namespace limn {
namespace {

struct Figures {
  double contrast = 0.0;
  Overflow overflow;
  double visibleBone = 0.0;
};

Figures figuresOf(RayCaster& caster, const Scene& scene) {
  constexpr glm::ivec2 size{160, 160};
  const TissueScenes tissue = tissueScenes(scene);
  return {contrastOf(caster.render(scene, size)), overflowOf(caster.renderUnlimited(scene, size)),
          visibleShare(caster.render(tissue.weights, size), caster.render(tissue.surface, size))};
}

using PaperClaims = test::GlTest;

TEST_F(PaperClaims, holdOnARealHeadFromTheFrontAndFromTheSide) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  RayCaster caster;
  for (const StandardView view : {StandardView::anterior, StandardView::left}) {
    std::vector<Figures> figures;
    for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust}) {
      Scene scene = test::headScene(test::ctHead(), model);
      scene.camera = standardView(scene.camera, scene.volume->grid(), view);
      scene.quality = {};
      scene.isovalue = 300.0;
      figures.push_back(figuresOf(caster, scene));
      std::cout << figures.back().contrast << ", " << figures.back().overflow.share << " by "
                << figures.back().overflow.meanOvershoot << ", " << figures.back().visibleBone << "\n";
    }
    const auto& [classic, enhanced, robust] = std::tie(figures[0], figures[1], figures[2]);
    EXPECT_GT(enhanced.contrast, 1.2 * classic.contrast) << "significantly higher contrast";
    EXPECT_GT(enhanced.visibleBone, 1.2 * classic.visibleBone) << "bone is no longer hidden by muscle";
    EXPECT_GT(enhanced.overflow.share, classic.overflow.share) << "brighter highlights, which overflow";
    EXPECT_LT(robust.overflow.share, enhanced.overflow.share) << "the robust model overflows less";
    EXPECT_GT(robust.visibleBone, classic.visibleBone);
  }
}

} // namespace
} // namespace limn
