// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/SceneUniforms.h"

#include "scene/basics/StableMath.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/LightDirections.h"
#include "scene/light/LightingTerms.h"
#include "scene/steps/LocalSteps.h"
#include "scene/steps/RayFrame.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace limn {
namespace {

// No colour and no distance reaches it.
constexpr double beyondAll = 1e30;

// Scenes may hold any double. What a float cannot is limited here: an infinity times 0 would be no number.
constexpr double mostOfFloat = 1e37;

// Sets uniforms from doubles.
struct Setter {
  const ShaderProgram& program;
  void operator()(const char* name, double value) const {
    program.set(name, static_cast<float>(std::clamp(value, -mostOfFloat, mostOfFloat)));
  }
  void operator()(const char* name, const glm::dvec2& value) const {
    program.set(name, glm::vec2(glm::clamp(value, -mostOfFloat, mostOfFloat)));
  }
  void operator()(const char* name, const glm::dvec3& value) const {
    program.set(name, glm::vec3(glm::clamp(value, -mostOfFloat, mostOfFloat)));
  }
};

double largestOf(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// From an eye so far away not even doubles find the volume, and limited to floats two rays far beside it
// might cancel out.
bool losesVolume(const RayFrame& frame) {
  return std::max({largestOf(frame.anchor), largestOf(frame.anchorX), largestOf(frame.anchorY)}) > 1e30;
}

void setRays(const Setter& set, const Scene& scene, const glm::ivec2& size, int most) {
  const Grid& grid = scene.volume->grid();
  const RayFrame frame = rayFrame(scene.camera, grid, size);
  const IndexBox box = croppedBox(grid, scene.crop);
  set("u_pictureCentre", glm::dvec2(size) / 2.0);
  set("u_anchor", frame.anchor);
  set("u_anchorX", frame.anchorX);
  set("u_anchorY", frame.anchorY);
  const double unit = lengthUnitMm(grid);
  set("u_direction", frame.direction * unit);
  set("u_directionX", frame.directionX * unit);
  set("u_directionY", frame.directionY * unit);
  set("u_tangentPerPixel", frame.tangentPerPixel);
  set("u_anchorDistance", frame.anchorDistanceMm / unit);
  set("u_boxLower", box.lower);
  set("u_boxUpper", losesVolume(frame) ? box.lower : box.upper);
  set("u_spacing", grid.spacingMm / unit);
  set("u_stepsPerLength", 1.0 / scene.quality.stepVoxels);
  set("u_mostSamples", static_cast<double>(most));
}

void setVolume(const Setter& set, const VolumeTexture& texture) {
  set("u_textureScale", texture.scale());
  set("u_textureOffset", texture.offset());
  set("u_textureLower", texture.lower());
  set("u_textureUpper", texture.upper());
  set("u_texel", texture.texel());
  set("u_blocksPerTexture", texture.blocksPerTexture());
  set("u_blockOffset", texture.blockOffset());
  set("u_lastBlock", glm::dvec3(texture.ranges().blocks() - 1));
}

void setGradient(const Setter& set, const Scene& scene, const SceneTextures& textures) {
  const Grid& grid = scene.volume->grid();
  const GradientScale& scale = textures.gradientScale();
  const double unit = textures.gradientUnit();
  set("u_gradientScale", differenceScale(grid, textures.volume()));
  set("u_flatModulus", unit > 0.0 ? std::ldexp(scale.largest / unit, -20) : 0.0);
  set("u_perReference", scale.reference > 0.0 ? unit / scale.reference : 0.0);
  set("u_gradientDomain", glm::dvec3(textures.gradientCurve().domain()));
}

void setLighting(const Setter& set, const Scene& scene) {
  const LightingTerms terms = lightingTerms(scene.shading);
  set("u_ambient", terms.ambient);
  set("u_diffuse", terms.diffuse);
  set("u_specular", terms.specular);
  set("u_exponent", glm::dvec2(terms.exponent.atFlat, terms.exponent.atBoundary));
  set("u_opacity", glm::dvec2(terms.opacity.atFlat, terms.opacity.atBoundary));
  // So near 0 a logarithmic curve is a line, and so small a number no 0 yet.
  const bool isLog = terms.curve.type == GradientCurve::Type::log;
  set("u_curve", isLog ? std::max(terms.curve.parameter, 1e-30) : terms.curve.parameter);
  set("u_energyWeight", terms.energyFactor ? 1.0 : 0.0);
  // What the scene does not use gets its neutral value, for programs that have more than it needs.
  set("u_knee", terms.knee.value_or(beyondAll));
  const Significance significance = terms.significance.value_or(Significance{0.0, 0.0});
  set("u_significance", glm::dvec2(significance.low, significance.high));
  const glm::dvec3 light = lightTravels(terms, scene.camera).value_or(glm::dvec3(0.0, 0.0, -1.0));
  set("u_lightDirection", towardsLightAlongAxes(light, scene.volume->grid()));
  const Grid& grid = scene.volume->grid();
  set("u_lightFrom", lightOffsetMm(grid) / lengthUnitMm(grid));
  set("u_shadow", terms.shadow.strength);
  set("u_occlusion", terms.occlusion.strength);
}

void setCut(const Setter& set, const Scene& scene) {
  const CutPlanes cut = cutPlanes(scene.volume->grid(), scene.crop);
  set("u_cutLower", cut.lower);
  set("u_cutUpper", cut.upper);
  set("u_cutDepth", 1.0);
}

// Distances count from the anchor plane and not from the eye, so that fog about a volume seen from afar loses
// no digits. A fog that does not show is set as none: the program may have another one.
void setFog(const Setter& set, const Scene& scene, double anchorDistanceMm, double unit) {
  const Fog& fog = scene.fog;
  const bool shows = fogShows(scene);
  set("u_fogColor", fog.color);
  set("u_fogStart", shows ? (fog.startMm - anchorDistanceMm) / unit : beyondAll);
  set("u_fogEnd", shows ? (fog.endMm - anchorDistanceMm) / unit : 2.0 * beyondAll);
  set("u_fogDensity", shows ? fog.densityPerMm * unit : 0.0);
}

void setSurface(const Setter& set, const Scene& scene) {
  set("u_isovalue", normalisedValue(scene.volume->range(), scene.isovalue));
  set("u_isoColor", classify(scene.transferFunction, scene.isovalue).color);
}

void setLocalSteps(const Setter& set, const Scene& scene, const BlockStepTexture& blocks) {
  const std::optional<double> fineness = finenessOf(scene.quality);
  if (!fineness)
    return;
  const Grid& grid = scene.volume->grid();
  set("u_stepBlockOffset", centreIndex(grid) / double(factCells));
  set("u_lastStepBlock", glm::dvec3(blocks.blocks() - 1));
  const double scale = ladderScale(*fineness);
  set("u_fineness", static_cast<double>(wholeRungs(*fineness)));
  set("u_mostChange", mostChange(*fineness));
  set("u_rung0Length", stepOfRung(0) * scale);
  set("u_finestLength", stepOfRung(finestRung) * scale);
}

void setSamplers(const ShaderProgram& program) {
  const auto unit = [&program](const char* sampler, TextureUnit u) {
    program.set(sampler, static_cast<int>(u));
  };
  unit("u_volume", TextureUnit::volume);
  unit("u_region", TextureUnit::region);
  unit("u_functionBins", TextureUnit::functionBins);
  unit("u_functionSegments", TextureUnit::functionSegments);
  unit("u_functionOccupancy", TextureUnit::functionOccupancy);
  unit("u_emptyDistance", TextureUnit::emptyDistance);
  unit("u_blockSteps", TextureUnit::blockSteps);
  unit("u_gradientBins", TextureUnit::gradientBins);
  unit("u_gradientSegments", TextureUnit::gradientSegments);
  unit("u_cellLooks", TextureUnit::cellLooks);
  unit("u_labels", TextureUnit::labels);
  unit("u_directLight", TextureUnit::directLight);
  unit("u_ambientLight", TextureUnit::ambientLight);
  unit("u_smoothedVolume", TextureUnit::smoothedVolume);
}

// So many unit distances hide everything; the whole box must not have more than a float holds.
double unitsPerLength(const Grid& grid, double unitDistanceMm) {
  const double unit = lengthUnitMm(grid);
  return std::min(unit / unitDistanceMm, beyondAll / (boxDiagonalMm(grid) / unit));
}

void setLooks(const Setter& set, const Scene& scene, const SceneTextures& textures) {
  const LookTextures& looks = textures.looks();
  if (looks.isEmpty())
    return;
  const glm::dvec3 size(textures.volume().size());
  set("u_cellsPerTexture", size);
  set("u_lastLayer", size.z - 3.0);
  set("u_lookSegments", static_cast<double>(looks.segmentsPerLook()));
  for (std::size_t look = 0; look < looks.unitDistances().size(); ++look)
    set(("u_lookUnits[" + std::to_string(look) + "]").c_str(),
        unitsPerLength(scene.volume->grid(), looks.unitDistances()[look]));
}

void bind(TextureUnit unit, unsigned target, unsigned texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(target, texture);
}

} // namespace

double lengthUnitMm(const Grid& grid) {
  return smallestSpacingMm(grid);
}

glm::dvec3 differenceScale(const Grid& grid, const VolumeTexture& volume) {
  const glm::dvec3 texelMm = grid.spacingMm * glm::dvec3(volume.reduction());
  return smallestSpacingMm(grid) / (2.0 * texelMm);
}

void bindTextures(const SceneTextures& textures) {
  bind(TextureUnit::volume, GL_TEXTURE_3D, textures.volume().name());
  bind(TextureUnit::region, GL_TEXTURE_3D, textures.region().name());
  bind(TextureUnit::emptyDistance, GL_TEXTURE_3D, textures.emptySpace().name());
  bind(TextureUnit::blockSteps, GL_TEXTURE_3D, textures.blockSteps().name());
  bind(TextureUnit::functionBins, GL_TEXTURE_2D, textures.function().bins());
  bind(TextureUnit::functionSegments, GL_TEXTURE_2D, textures.function().segments());
  bind(TextureUnit::functionOccupancy, GL_TEXTURE_2D, textures.function().occupancy());
  bind(TextureUnit::gradientBins, GL_TEXTURE_2D, textures.gradientCurve().bins());
  bind(TextureUnit::gradientSegments, GL_TEXTURE_2D, textures.gradientCurve().segments());
  if (!textures.looks().isEmpty()) {
    bind(TextureUnit::cellLooks, GL_TEXTURE_3D, textures.looks().cells());
    bind(TextureUnit::labels, GL_TEXTURE_3D, textures.looks().labels());
  }
  if (textures.smoothed().name() != 0)
    bind(TextureUnit::smoothedVolume, GL_TEXTURE_3D, textures.smoothed().name());
}

int sampleLimit(const Scene& scene, const SceneTextures& textures) {
  // A hybrid picture marches twice, to find the surface and to gather what lies before it.
  const int marches = scene.projection == Projection::compositeIsosurface ? 2 : 1;
  // A pre-integrated step looks up both its ends.
  // So does what stands in the way of light, twice.
  const int lookups =
      (scene.quality.preintegrated == Preintegration::never ? 1 : 2) + (hasTravellingLight(scene) ? 2 : 0);
  const int looks = textures.looks().isEmpty() ? 0 : 6;
  const int steps = lookups * textures.function().loopSteps() + textures.gradientCurve().loopSteps() + looks;
  return mostSamples / (marches + steps);
}

void setUniforms(const ShaderProgram& program, const Scene& scene, const glm::ivec2& size,
                 const SceneTextures& textures) {
  const Setter set{program};
  setSamplers(program);
  setRays(set, scene, size, sampleLimit(scene, textures));
  setVolume(set, textures.volume());
  set("u_functionDomain", glm::dvec3(textures.function().domain()));
  const Grid& grid = scene.volume->grid();
  const double unit = lengthUnitMm(grid);
  set("u_perUnitDistance", unitsPerLength(grid, scene.transferFunction.unitDistanceMm));
  setLooks(set, scene, textures);
  setGradient(set, scene, textures);
  setLighting(set, scene);
  setCut(set, scene);
  setFog(set, scene, rayFrame(scene.camera, grid, size).anchorDistanceMm, unit);
  setSurface(set, scene);
  setLocalSteps(set, scene, textures.blockSteps());
  set("u_jitter", scene.quality.jitter ? 1.0 : 0.0);
  set("u_lastTransmittance", lastTransmittance(scene.quality.earlyTermination));
}

} // namespace limn
