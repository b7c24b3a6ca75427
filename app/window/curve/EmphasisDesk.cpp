// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/curve/EmphasisDesk.h"

#include "app/document/Session.h"
#include "app/window/picture/PlaneDesk.h"
#include "scene/function/PointShare.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/curve/points/PointLight.h"

namespace limn {

EmphasisDesk::EmphasisDesk(Session& session, TransferFunctionCanvas& canvas, PlaneDesk& planes,
                           QObject* parent)
    : QObject(parent), m_session(session), m_planes(planes), m_light(new PointLight(canvas)) {
  connect(m_light, &PointLight::changed, this, &EmphasisDesk::show);
  connect(&session, &Session::sceneChanged, m_light, &PointLight::turnOff);
}

// The curve in the plot may be one that is previewed itself, and has other points than the session's.
void EmphasisDesk::show(std::optional<std::size_t> point) {
  Scene scene = m_session.scene();
  const bool isShown = scene.volume && point && *point < scene.transferFunction.points.size();
  m_planes.setEmphasised(isShown ? point : std::nullopt);
  if (isShown)
    scene.transferFunction = withPointEmphasised(scene.transferFunction, *point);
  emit previewed(scene);
}

} // namespace limn
