// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/FilterBits.h"

#include "glsl/programs/GlslEvaluator.h"
#include "glsl/programs/ShaderVariant.h"
#include "scene/volume/Volume.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <set>

namespace limn {
namespace {

// From 0 at the first voxel's centre to 1 at the second's, along x.
Scene ramp() {
  Grid grid;
  grid.dims = {2, 2, 2};
  grid.originMm = glm::dvec3(-0.5);
  Scene scene;
  scene.volume = std::make_shared<const Volume>(grid, std::vector<float>{0, 1, 0, 1, 0, 1, 0, 1}, Rescale{},
                                                std::nullopt, VolumeInfo{});
  scene.transferFunction.points = {{0.0, glm::dvec3(1.0), 0.0}, {1.0, glm::dvec3(1.0), 1.0}};
  return scene;
}

} // namespace

int filterBits(const Decisions& decisions) {
  constexpr int places = 1 << mostFilterBits;
  std::vector<glm::vec4> arguments;
  arguments.reserve(places);
  for (int i = 0; i < places; ++i)
    arguments.emplace_back((static_cast<float>(i) + 0.5f) / places - 0.5f, 0.0f, 0.0f, 0.0f);
  GLint framebuffer = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
  std::vector<float> values;
  const GlslEvaluator evaluate({driverFilterBlock(decisions), "volume.glsl"});
  for (const glm::vec4& value : evaluate("scalarAt(toTexture(vec3(v.x, 0.0, 0.0)))", arguments, ramp()))
    values.push_back(value.r);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
  return filterBitsOf(values);
}

int filterBitsOf(const std::vector<float>& values) {
  // With b bits there are 2^b values and, where fractions are rounded, one more.
  const std::set<float> different(values.begin(), values.end());
  return std::bit_width(std::max<std::size_t>(different.size(), 1)) - 1;
}

std::string filterText(int bits) {
  const std::string number = std::to_string(bits);
  if (bits >= mostFilterBits)
    return "weights of at least " + number + " bits between voxels";
  return "weights of " + number + " bits between voxels: values are off by up to 1/" +
         std::to_string(2 << bits) + " of what a cell changes by";
}

} // namespace limn
