// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/ShaderVariant.h"

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

// GLSL 1.30 is the language of OpenGL 3.0. Desktop drivers ignore precision.
constexpr const char* version = "#version 130\n";

std::string prelude(EffectSet effects) {
  std::string text = version;
  const auto define = [&text](const char* name) { text += std::string("#define ") + name + "\n"; };
  for (int i = 0; i < effectCount; ++i)
    if (effects.has(static_cast<Effect>(i)))
      define(describe(static_cast<Effect>(i)).define);
  // Blocks that several effects share.
  if (usesRatio(effects))
    define("EFFECT_GRADIENT_RATIO");
  if (effects.hasAny(opacityChanges.with(Effect::region)))
    define("EFFECT_CHANGED_OPACITY");
  if (effects.hasAny(fogs))
    define("EFFECT_FOG");
  if (effects.hasAny(travellingLight))
    define("EFFECT_TRAVELLING_LIGHT");
  return text;
}

void appendBlock(ShaderSource& source, const char* name) {
  source.append(name, embeddedShader(name));
}

const char* filterBlock(EffectSet effects, const Decisions& decisions) {
  return effects.has(Effect::ownWeights) ? "own_weights.glsl" : driverFilterBlock(decisions);
}

const char* volumeBlock(const Decisions& decisions) {
  return decisions.volume == VolumeFormat::r16 ? "volume_wide.glsl" : "volume.glsl";
}

const char* classificationBlock(EffectSet effects, const Decisions& decisions) {
  if (effects.has(Effect::labelLooks))
    return "classification_by_label.glsl";
  return decisions.table == TableFormat::exact ? "classification.glsl" : "function_table.glsl";
}

const char* jitterBlock(const Decisions& decisions) {
  return decisions.place == SamplePlace::middle ? "jitter.glsl" : "front_of_step.glsl";
}

// How gradients are found concerns those of the volume.
const char* gradientBlock(EffectSet effects, const Decisions& decisions) {
  if (effects.has(Effect::smoothNormals))
    return "smoothed_gradient.glsl";
  switch (decisions.gradients) {
  case GradientFormat::onTheFly:
    return "gradient.glsl";
  case GradientFormat::forward:
    return "forward_differences.glsl";
  case GradientFormat::halves:
    return "stored_gradient.glsl";
  case GradientFormat::directions:
    return "stored_direction.glsl";
  }
  return "";
}

void appendGathering(ShaderSource& source, EffectSet effects, const Decisions& decisions) {
  if (effects.has(Effect::localSteps)) {
    appendBlock(source, "local_steps.glsl");
    appendBlock(source, "gather_local_steps.glsl");
  } else if (effects.has(Effect::labelLooks)) {
    appendBlock(source, "fetched_by_label.glsl");
    appendBlock(source,
                effects.has(Effect::preintegration) ? "gather_segments_by_label.glsl" : "gather.glsl");
  } else if (effects.has(Effect::preintegration)) {
    appendBlock(source, "gather_segments.glsl");
  } else {
    const bool isInterpolatedFirst = decisions.classification == ClassificationOrder::afterInterpolation;
    appendBlock(source, isInterpolatedFirst ? "fetched.glsl" : "fetched_classified.glsl");
    appendBlock(source, "gather.glsl");
  }
}

// A sample at the front of its step takes the place of a jittered one.
EffectSet withPlace(EffectSet effects, const Decisions& decisions) {
  const bool isMoved = decisions.place != SamplePlace::middle && !effects.has(Effect::preintegration);
  return isMoved ? effects.with(Effect::jitter) : effects;
}

// The volume, its classification and light, and the steps of a ray through it.
void appendFieldBlocks(ShaderSource& source, EffectSet effects, const Decisions& decisions) {
  const auto blockIf = [&](bool isNeeded, const char* name) {
    if (isNeeded)
      appendBlock(source, name);
  };
  for (const char* name :
       {"stable_math.glsl", filterBlock(effects, decisions), volumeBlock(decisions), "piecewise.glsl"})
    appendBlock(source, name);
  // Looks of labels ask for the weight of a place themselves.
  const bool hasLooks = effects.has(Effect::labelLooks);
  blockIf(hasLooks && effects.has(Effect::region), "region.glsl");
  appendBlock(source, classificationBlock(effects, decisions));
  blockIf(!hasLooks && effects.has(Effect::region), "region.glsl");
  blockIf(effects.has(Effect::preintegration), "preintegration.glsl");
  blockIf(effects.has(Effect::emptySpaceSkipping), "empty_space.glsl");
  blockIf(effects.has(Effect::jitter), jitterBlock(decisions));
  blockIf(effects.has(Effect::gradient), gradientBlock(effects, decisions));
  blockIf(usesRatio(effects), "gradient_ratio.glsl");
  blockIf(effects.has(Effect::gradientOpacity), "gradient_opacity.glsl");
  blockIf(effects.has(Effect::cutFaces), "cut_faces.glsl");
  blockIf(effects.has(Effect::lighting), "lighting.glsl");
  blockIf(effects.hasAny(fogs), "fog.glsl");
  appendBlock(source, "march.glsl");
}

const char* sampleBlock(EffectSet effects) {
  return effects.has(Effect::xray) ? "xray_sample.glsl" : "sample.glsl";
}

} // namespace

const std::string& embeddedShader(const std::string& name) {
  const auto& shaders = embeddedShaders();
  const auto found = std::find_if(shaders.begin(), shaders.end(),
                                  [&name](const EmbeddedShader& shader) { return shader.name == name; });
  assert(found != shaders.end());
  return found->text;
}

const char* driverFilterBlock(const Decisions& decisions) {
  return decisions.weights == FilterWeights::driver ? "driver_weights.glsl" : "weights_of_8_bits.glsl";
}

ShaderSource vertexSource() {
  ShaderSource source;
  source.append("prelude", version);
  appendBlock(source, "full_screen.vert.glsl");
  return source;
}

ShaderSource sliceVertexSource() {
  ShaderSource source;
  source.append("prelude", version);
  appendBlock(source, "slice.vert.glsl");
  return source;
}

ShaderSource fragmentSource(EffectSet effects, const Decisions& decisions, LightFrom lightFrom) {
  ShaderSource source;
  effects = withPlace(effects, decisions);
  source.append("prelude", prelude(effects));
  if (decisions.table == TableFormat::correctedFloats)
    source.append("prelude", "#define DECISION_CORRECTED_TABLE\n");
  if (lightFrom == LightFrom::nodesAlone)
    source.append("prelude", "#define NODES_ALONE\n");
  appendBlock(source, "ray.glsl");
  if (effects == EffectSet{Effect::sampleCounts}) {
    appendBlock(source, "sample_counts.glsl");
    return source;
  }
  appendFieldBlocks(source, effects, decisions);
  if (effects.hasAny(scalarProjections)) {
    appendBlock(source, "scalar_projection.glsl");
    return source;
  }
  appendBlock(source, sampleBlock(effects));
  if (effects.hasAny({Effect::isosurface, Effect::hybrid}))
    appendBlock(source, "isosurface.glsl");
  if (effects.hasAny(travellingLight))
    appendBlock(source, "travelling_light.glsl");
  if (effects.has(Effect::isosurface)) {
    appendBlock(source, "first_hit.glsl");
    return source;
  }
  appendGathering(source, effects, decisions);
  appendBlock(source, "composite.glsl");
  return source;
}

ShaderSource sliceSource(EffectSet effects) {
  ShaderSource source;
  source.append("prelude", prelude(effects));
  appendBlock(source, "ray.glsl");
  appendFieldBlocks(source, effects, {});
  appendBlock(source, sampleBlock(effects));
  appendBlock(source, "slice.glsl");
  return source;
}

} // namespace limn
