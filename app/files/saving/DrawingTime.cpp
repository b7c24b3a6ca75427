// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/DrawingTime.h"

#include "app/core/drawing/PathDrawing.h"
#include "cpu/LightStore.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/LightingTerms.h"
#include "widgets/ValueText.h"
#include "widgets/controls/TimeLeft.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// The error falls as the root of the paths.
std::optional<double> pathsUntil(const Until& until, const std::optional<PathFigures>& shown) {
  if (const auto* paths = std::get_if<UntilPaths>(&until))
    return paths->paths;
  const auto* levels = std::get_if<UntilLevels>(&until);
  if (!levels || !shown || !shown->rmsLevels)
    return std::nullopt;
  return std::min(shown->paths * std::pow(*shown->rmsLevels / levels->levels, 2.0), double(mostPaths));
}

} // namespace

bool isAsSaved(const Scene& scene, const SideState& shown) {
  if (!isPhysical(scene))
    return true;
  const PhysicalLight& light = scene.shading.physical;
  return !light.filtersNoise && shown.paths &&
         nextPaths(light.until, *shown.paths, 0.0) == shown.paths->paths;
}

std::optional<double> secondsToDraw(const Scene& scene, const SideState& shown, double timesThePixels) {
  // Until it is complete, what the last one took is known, which may have been of another light.
  if (!isPhysical(scene))
    return shown.completeMs && shown.fraction >= 1.0
               ? std::optional(1e-3 * timesThePixels * *shown.completeMs)
               : std::nullopt;
  const PhysicalLight& light = scene.shading.physical;
  const double share = light.filtersNoise ? shareOfPaths : 1.0;
  if (const auto* time = std::get_if<UntilSeconds>(&light.until)) {
    // Its first paths it has in any case.
    const double first = nextPaths(light.until, {}, 0.0) * shown.msPerPath.value_or(0.0);
    return std::max(time->seconds, 1e-3 * timesThePixels * first) / share;
  }
  const std::optional<double> paths = pathsUntil(light.until, shown.paths);
  if (!paths || !shown.msPerPath)
    return std::nullopt;
  return 1e-3 * timesThePixels * *paths * *shown.msPerPath / share;
}

bool findsLightForEachView(const Scene& scene, Engine engine) {
  if (engine == Engine::cpu && !cpu::looksUpLight(scene))
    return false;
  const LightingTerms terms = lightingTerms(scene.shading);
  return hasTravellingLight(scene) && terms.shadow.strength > 0.0 && terms.lightAxes == LightAxes::camera;
}

QString framesTimeText(const Scene& scene, Engine engine, const SideState& shown, double timesThePixels,
                       int frames) {
  if (findsLightForEachView(scene, engine))
    return QObject::tr("How long drawing takes is not known: light is found anew for each frame.");
  const std::optional<double> one = secondsToDraw(scene, shown, timesThePixels);
  if (one && frames * *one >= longSeconds)
    return QObject::tr("Drawing takes %1.", "a time").arg(aboutText(frames * *one));
  return one || shown.fraction >= 1.0
             ? QString()
             : QObject::tr("How long drawing takes is known once the picture is complete.");
}

QString savedPathsText(const PhysicalLight& light) {
  QString text;
  if (const auto* levels = std::get_if<UntilLevels>(&light.until))
    text = QObject::tr("paths until %1 of 255 levels of noise are left").arg(plainNumber(levels->levels, 2));
  else if (const auto* seconds = std::get_if<UntilSeconds>(&light.until))
    text = QObject::tr("paths for %1 s").arg(plainNumber(seconds->seconds, 1));
  else
    text = QObject::tr("%1 paths a pixel").arg(std::get<UntilPaths>(light.until).paths);
  return light.filtersNoise ? QObject::tr("%1, noise filtered", "paths").arg(text) : text;
}

} // namespace limn
