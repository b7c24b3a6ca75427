// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/UnseenCrop.h"

#include "app/window/WindowContext.h"
#include "scene/framing/VisibleVoxels.h"
#include "widgets/view/CompareView.h"

#include <algorithm>
#include <utility>

namespace limn {

UnseenCrop::UnseenCrop(WindowContext& context, std::function<bool(const Scene&)> isKnown)
    : m_context(context), m_isKnown(std::move(isKnown)) {
  connect(&context.view, &CompareView::told, this, [this](const ViewNews& news) {
    followScene(m_context.session.scene());
    if (news.state.resting)
      judge();
  });
  connect(&m_judging, &BackgroundWork::failed, this, [this] { m_context.view.setCropHidesNothing(false); });
}

// Of another crop, or another volume, nothing was found out.
void UnseenCrop::followScene(const Scene& scene) {
  if (m_judged.empty() || (m_judged.front().volume == scene.volume && m_judged.front().crop == scene.crop))
    return;
  m_judging.cancel();
  m_judged.clear();
  m_context.view.setCropHidesNothing(m_isKnown(scene));
}

// Cameras and light change nothing of it. What lies on the disk is not read for it.
void UnseenCrop::judge() {
  std::vector<Scene> sides = m_context.view.scenesOfSides();
  for (Scene& side : sides) {
    Scene seen;
    seen.volume = side.volume;
    seen.transferFunction = side.transferFunction;
    seen.keep = side.keep;
    seen.crop = side.crop;
    seen.projection = side.projection;
    seen.isovalue = side.isovalue;
    side = seen;
  }
  if (sides == m_judged)
    return;
  m_judged = sides;
  m_judging.cancel();
  if (sides.empty() || !sides.front().volume || sides.front().crop == CropBox{} ||
      sides.front().volume->room())
    return m_context.view.setCropHidesNothing(false);
  m_judging.start([this, sides](const Effort& effort) -> BackgroundWork::Deliver {
    const bool hidesNothing =
        std::ranges::all_of(sides, [&](const Scene& side) { return cropsOnlyUnseen(side, effort); });
    return [this, hidesNothing] { m_context.view.setCropHidesNothing(hidesNothing); };
  });
}

} // namespace limn
