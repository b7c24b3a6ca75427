// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/ShaderVariant.h"

#include "raycaster/EmbeddedShaders.h"

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

// GLSL 1.30 is the language of OpenGL 3.0. Desktop drivers ignore precision.
constexpr const char* version = "#version 130\n";

bool readsRatio(EffectSet effects) {
  return effects.has(Effect::exponentMap) || effects.has(Effect::opacityMap) ||
         effects.has(Effect::significance);
}

bool hasFog(EffectSet effects) {
  return effects.has(Effect::fogLinear) || effects.has(Effect::fogExp) || effects.has(Effect::fogExp2);
}

std::string prelude(EffectSet effects) {
  std::string text = version;
  const auto define = [&text](const char* name) { text += std::string("#define ") + name + "\n"; };
  for (int i = 0; i < effectCount; ++i)
    if (effects.has(static_cast<Effect>(i)))
      define(describe(static_cast<Effect>(i)).define);
  // Blocks that several effects share.
  if (readsRatio(effects))
    define("EFFECT_GRADIENT_RATIO");
  if (hasFog(effects))
    define("EFFECT_FOG");
  return text;
}

void appendBlock(ShaderSource& source, const char* name) {
  source.append(name, embeddedShader(name));
}

// What one sample needs, in the order of the stage contract.
void appendSampleBlocks(ShaderSource& source, EffectSet effects) {
  for (const char* block : {"stable_math.glsl", "volume.glsl", "piecewise.glsl", "classification.glsl"})
    appendBlock(source, block);
  if (effects.has(Effect::emptySpaceSkipping))
    appendBlock(source, "empty_space.glsl");
  if (effects.has(Effect::gradient))
    appendBlock(source, "gradient.glsl");
  if (readsRatio(effects))
    appendBlock(source, "gradient_ratio.glsl");
  if (effects.has(Effect::gradientOpacity))
    appendBlock(source, "gradient_opacity.glsl");
  if (effects.has(Effect::cutFaces))
    appendBlock(source, "cut_faces.glsl");
  if (effects.has(Effect::lighting))
    appendBlock(source, "lighting.glsl");
  if (hasFog(effects))
    appendBlock(source, "fog.glsl");
  appendBlock(source, "sample.glsl");
}

} // namespace

const std::string& embeddedShader(const std::string& name) {
  const auto& shaders = embeddedShaders();
  const auto found = std::find_if(shaders.begin(), shaders.end(),
                                  [&name](const EmbeddedShader& shader) { return shader.name == name; });
  assert(found != shaders.end());
  return found->text;
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

ShaderSource fragmentSource(EffectSet effects) {
  ShaderSource source;
  source.append("prelude", prelude(effects));
  appendBlock(source, "ray.glsl");
  if (!effects.has(Effect::sampleCounts))
    appendSampleBlocks(source, effects);
  appendBlock(source, "composite.glsl");
  return source;
}

ShaderSource sliceSource(EffectSet effects) {
  ShaderSource source;
  source.append("prelude", prelude(effects));
  appendBlock(source, "ray.glsl");
  appendSampleBlocks(source, effects);
  appendBlock(source, "slice.glsl");
  return source;
}

} // namespace limn
