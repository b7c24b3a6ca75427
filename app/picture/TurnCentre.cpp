// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/TurnCentre.h"

#include "reference/ProfileAlong.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QObject>

namespace limn {

TurnCentre turnCentreAlong(const CompareView& view, const Ray& ray, int side) {
  const Scene scene = view.sceneOfSide(side);
  if (scene.projection == Projection::average)
    return {{},
            QObject::tr("In an average every depth counts alike, so that there is no place to turn about.")};
  const std::optional<RayProfile> profile = profileAlong(scene, view.input().scaleOfSide(side), ray);
  if (const auto depth = profile ? halfLightDepth(*profile) : std::nullopt)
    return {placeAt(*profile, *depth), {}};
  return {{}, noPlaceText()};
}

QString noPlaceText() {
  return QObject::tr("Nothing is seen there.");
}

} // namespace limn
