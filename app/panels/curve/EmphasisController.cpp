// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/curve/EmphasisController.h"

#include "app/window/WindowContext.h"
#include "scene/function/PointShare.h"
#include "widgets/curve/PointLight.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/view/CompareView.h"

namespace limn {

EmphasisController::EmphasisController(WindowContext& context, TransferFunctionCanvas& canvas)
    : QObject(&context.window), m_context(context), m_light(new PointLight(canvas)) {
  connect(m_light, &PointLight::changed, this, &EmphasisController::show);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene&) { m_light->turnOff(); });
}

// The curve in the plot may be one that is previewed itself, and has other points than the session's.
void EmphasisController::show(std::optional<std::size_t> point) {
  Scene scene = m_context.session.scene();
  const bool isShown = scene.volume && point && *point < scene.transferFunction.points.size();
  emit lit(isShown ? point : std::nullopt);
  if (isShown)
    scene.transferFunction = withPointEmphasised(scene.transferFunction, *point);
  m_context.view.setScene(scene); // until the session's own ends it
}

} // namespace limn
