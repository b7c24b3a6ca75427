// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/ProjectionCurves.h"

#include "app/document/SceneEdits.h"
#include "app/presets/PresetStore.h"
#include "scene/presets/PresetFit.h"

namespace limn {
namespace {

// In Hounsfield units. Air around the body is left out of a minimum, and of an average but for its depth.
TransferFunction minimumCurve() {
  return {1.0,
          {{-985.0, glm::dvec3(0.0), 0.0},
           {-985.0, glm::dvec3(0.0), 1.0},
           {-200.0, glm::dvec3(0.55), 1.0},
           {100.0, glm::dvec3(1.0), 1.0}}};
}

TransferFunction averageCurve() {
  return {1.0,
          {{-950.0, glm::dvec3(0.0), 0.0},
           {-950.0, glm::dvec3(0.0), 1.0},
           {-300.0, glm::dvec3(0.45), 1.0},
           {500.0, glm::dvec3(1.0), 1.0}}};
}

} // namespace

ProjectionCurves::Kind ProjectionCurves::kindOf(Projection projection) {
  switch (projection) {
  case Projection::mip:
    return Kind::maximum;
  case Projection::minip:
    return Kind::minimum;
  case Projection::average:
    return Kind::average;
  case Projection::xray:
    return Kind::xray;
  case Projection::composite:
  case Projection::isosurface:
  case Projection::compositeIsosurface:
    break;
  }
  return Kind::tissue;
}

TransferFunction ProjectionCurves::ownCurve(const Scene& scene, Kind kind, const Histogram& histogram) {
  const bool isHounsfield = looksLikeHounsfield(*scene.volume);
  Preset preset;
  preset.modality = "CT";
  if (kind == Kind::tissue)
    preset = bestFitting(builtInPresets(), *scene.volume);
  else if (kind == Kind::maximum)
    preset = presetNamed(builtInPresets(), isHounsfield ? "CT maximum (MIP)" : "MR maximum (MIP)");
  else if (kind == Kind::xray)
    preset = presetNamed(builtInPresets(), "CT X-ray");
  else
    preset.transferFunction = kind == Kind::minimum ? minimumCurve() : averageCurve();
  return kind == Kind::tissue ? preset.transferFunction
                              : fittedToValues(preset, *scene.volume, histogram).transferFunction;
}

void ProjectionCurves::note(const Scene& scene) {
  if (m_volume != scene.volume)
    m_shown.clear();
  m_volume = scene.volume;
  if (scene.volume)
    m_shown[kindOf(scene.projection)] = scene.transferFunction;
}

Scene ProjectionCurves::changed(const Scene& scene, Projection projection, const Histogram& histogram) const {
  Scene result = withProjection(scene, projection, histogram);
  const Kind kind = kindOf(projection);
  if (!scene.volume || kind == kindOf(scene.projection))
    return result;
  const auto shown = m_volume == scene.volume ? m_shown.find(kind) : m_shown.end();
  result.transferFunction = shown != m_shown.end() ? shown->second : ownCurve(scene, kind, histogram);
  return result;
}

} // namespace limn
