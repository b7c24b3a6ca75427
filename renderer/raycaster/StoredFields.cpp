// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/StoredFields.h"

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

// Lifts the components of gradients, at most 1, to where halves have all their digits: far below 65504.
constexpr float halvesLift = 0x1p15f;

// The gradient of a texel; the apron has that of its neighbour, with which it is never mixed.
glm::vec3 gradientOf(const TextureVoxels& voxels, const glm::ivec3& texel, const glm::vec3& scale) {
  const glm::ivec3 at = glm::clamp(texel, glm::ivec3(1), voxels.size - 2);
  const std::ptrdiff_t strides[3] = {1, voxels.size.x,
                                     static_cast<std::ptrdiff_t>(voxels.size.x) * voxels.size.y};
  const float* here = &voxels.texels[voxelOffset(voxels.size, at.x, at.y, at.z)];
  return scale * glm::vec3(here[strides[0]] - here[-strides[0]], here[strides[1]] - here[-strides[1]],
                           here[strides[2]] - here[-strides[2]]);
}

// Calls `function(texel number, gradient)` for a slice.
template <class Function>
void forSlice(const TextureVoxels& voxels, const glm::vec3& scale, int k, Function&& function) {
  std::size_t texel = 0;
  for (int j = 0; j < voxels.size.y; ++j)
    for (int i = 0; i < voxels.size.x; ++i)
      function(texel++, gradientOf(voxels, {i, j, k}, scale));
}

float largestModulus(const TextureVoxels& voxels, const glm::vec3& scale) {
  float largest = 0.0f;
  for (int k = 1; k + 1 < voxels.size.z; ++k)
    forSlice(voxels, scale, k, [&largest](std::size_t, const glm::vec3& gradient) {
      largest = std::max(largest, glm::dot(gradient, gradient));
    });
  return std::sqrt(largest);
}

glm::vec4 inBytes(const glm::vec3& gradient, float largest) {
  const float modulus = glm::length(gradient);
  const glm::vec3 direction = modulus > 0.0f ? gradient / modulus : glm::vec3(0.0f);
  return {0.5f + 0.5f * direction, largest > 0.0f ? modulus / largest : 0.0f};
}

} // namespace

StoredGradients storedGradients(const TextureVoxels& voxels, const glm::dvec3& scale, GradientFormat format) {
  const glm::vec3 scaleInFloat(scale);
  if (format == GradientFormat::halves)
    return {VoxelTexture(voxels.size, VoxelTexture::Format::halves, Message::tr("gradients in half floats"),
                         [&](int k, std::vector<glm::vec4>& texels) {
                           forSlice(voxels, scaleInFloat, k, [&](std::size_t i, const glm::vec3& gradient) {
                             texels[i] = glm::vec4(halvesLift * gradient, 0.0f);
                           });
                         }),
            1.0 / halvesLift};
  assert(format == GradientFormat::directions);
  const float largest = largestModulus(voxels, scaleInFloat);
  return {VoxelTexture(voxels.size, VoxelTexture::Format::bytes, Message::tr("gradients in bytes"),
                       [&](int k, std::vector<glm::vec4>& texels) {
                         forSlice(voxels, scaleInFloat, k, [&](std::size_t i, const glm::vec3& gradient) {
                           texels[i] = inBytes(gradient, largest);
                         });
                       }),
          largest};
}

VoxelTexture classifiedVolume(const TextureVoxels& voxels, const ValueRange& range,
                              const TransferFunction& function, ClassificationOrder order) {
  assert(order != ClassificationOrder::afterInterpolation);
  const bool isHalves = order == ClassificationOrder::beforeInHalves;
  // A volume of one value keeps its distance to that value.
  const double width = range.highest > range.lowest ? range.highest - range.lowest : 1.0;
  const std::size_t sliceTexels = static_cast<std::size_t>(voxels.size.x) * voxels.size.y;
  return VoxelTexture(voxels.size, isHalves ? VoxelTexture::Format::halves : VoxelTexture::Format::bytes,
                      Message::tr("classified voxels"), [&](int k, std::vector<glm::vec4>& texels) {
                        const float* slice = &voxels.texels[sliceTexels * static_cast<std::size_t>(k)];
                        for (std::size_t i = 0; i < sliceTexels; ++i) {
                          const Classified at = classify(function, range.lowest + slice[i] * width);
                          texels[i] = glm::vec4(glm::dvec4(at.color * at.opacity, at.opacity));
                        }
                      });
}

} // namespace limn
