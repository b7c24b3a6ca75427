// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/rays/PictureTerms.h"

#include <algorithm>

namespace limn::cpu {

Ray inLengths(const PictureTerms& terms, const Ray& ray) {
  const FramedRay framed = framedRay(terms.frame, ray.pixel.x, ray.pixel.y, terms.size);
  const glm::dvec3 first = framed.anchor + ray.span.begin * framed.direction;
  const double beforeAnchor = -framed.eye - terms.frame.anchorDistanceMm;
  Ray result = ray;
  result.offset = 0.0f;
  result.first = glm::vec3(first + terms.centre);
  result.stride = glm::vec3(terms.lengthMm * framed.direction);
  result.firstIndex = glm::vec3(first);
  result.firstDepth = static_cast<float>((ray.span.begin + beforeAnchor) / terms.lengthMm);
  result.strideDepth = 1.0f;
  result.units = terms.perUnitDistance;
  return result;
}

VoxelSource sourceOf(const void* voxels, VoxelSource::Kind kind, const glm::ivec3& dims, float scale) {
  const bool isByte = kind == VoxelSource::Kind::byte || kind == VoxelSource::Kind::signedByte;
  const std::int64_t row = std::int64_t{isByte ? 1 : kind == VoxelSource::Kind::single ? 4 : 2} * dims.x;
  VoxelSource source;
  source.kind = kind;
  source.begin = static_cast<const unsigned char*>(voxels);
  source.bytes = row * dims.y * dims.z;
  source.scale = scale;
  source.dims = dims;
  source.strideY = dims.y > 1 ? row : 0;
  source.strideZ = dims.z > 1 ? row * dims.y : 0;
  return source;
}

RaySpan partInBrick(const PictureTerms& terms, const FramedRay& ray, const RaySpan& span) {
  if (!terms.brick)
    return span;
  const RaySpan inBrick = spanInBox(ray, *terms.brick);
  return {std::max(span.begin, inBrick.begin), std::min(span.end, inBrick.end)};
}

FewSegments fewSegments(const PiecewiseTable& table) {
  FewSegments few;
  if (table.segmentCount > FewSegments::most)
    return few;
  few.count = table.segmentCount;
  for (int i = 0; i < few.count; ++i) {
    const glm::vec4* texels = &table.segments[4 * static_cast<std::size_t>(i)];
    few.starts[i] = texels[2].x;
    few.ends[i] = texels[2].y;
    for (int channel = 0; channel < 4; ++channel) {
      few.values[channel][i] = texels[0][channel];
      few.slopes[channel][i] = texels[1][channel];
    }
  }
  return few;
}

} // namespace limn::cpu
