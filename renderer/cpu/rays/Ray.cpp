// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/rays/Ray.h"

#include "scene/basics/StableMath.h"

#include <algorithm>
#include <cmath>

namespace limn::cpu {
namespace {

// The samples of a ray that lie in the part where something shows, one more on either side.
void limitTo(const RaySpan& visible, double stepMm, Ray& ray) {
  const double from = std::floor((visible.begin - ray.span.begin) / stepMm - ray.offset) - 1.0;
  const double to = std::ceil((visible.end - ray.span.begin) / stepMm - ray.offset) + 1.0;
  ray.from = static_cast<int>(std::clamp(from, 0.0, double(ray.count)));
  ray.to = static_cast<int>(std::clamp(to, double(ray.from), double(ray.count)));
}

void lightAlong(const PictureTerms& terms, const glm::dvec3& direction, Ray& ray) {
  const glm::dvec3 toViewer = -direction;
  glm::dvec3 toLight = toViewer;
  glm::dvec3 halfway = toViewer;
  if (terms.effects.has(Effect::fixedLight)) {
    toLight = terms.towardsLight;
    const glm::dvec4 between = safeNormal(toLight + toViewer);
    halfway = between.w > shortestHalfVector ? glm::dvec3(between) : glm::dvec3(0.0);
  }
  ray.toViewer = glm::vec3(toViewer);
  ray.toLight = glm::vec3(toLight);
  ray.halfway = glm::vec3(halfway);
}

// Places sample 0 `offset` steps behind the entry.
void place(const PictureTerms& terms, double offset, double stepMm, Ray& ray) {
  const FramedRay& framed = ray.framed;
  const glm::dvec3 stride = stepMm * framed.direction;
  const glm::dvec3 first = framed.anchor + ray.span.begin * framed.direction + offset * stride;
  ray.offset = static_cast<float>(offset);
  ray.first = glm::vec3(first + terms.centre);
  ray.stride = glm::vec3(stride);
  ray.firstIndex = glm::vec3(first);
  ray.strideIndex = ray.stride;
  const double beforeAnchor = -framed.eye - terms.frame.anchorDistanceMm;
  ray.firstDepth = static_cast<float>((ray.span.begin + offset * stepMm + beforeAnchor) / terms.lengthMm);
  ray.strideDepth = static_cast<float>(stepMm / terms.lengthMm);
  ray.units = static_cast<float>(stepMm / terms.lengthMm) * terms.perUnitDistance;
}

Ray divided(const PictureTerms& terms, const FramedRay& framed, const RaySpan& span, const RaySpan& visible,
            int x, int y) {
  Ray ray;
  ray.framed = framed;
  ray.span = span;
  ray.count = sampleCount(span.end - span.begin, terms.stepLengths * terms.lengthMm);
  const bool isJittered = terms.effects.has(Effect::jitter);
  const double stepMm = (span.end - span.begin) / ray.count;
  place(terms, isJittered ? jitteredOffset(x, y, terms.size.y) : 0.5, stepMm, ray);
  if (terms.effects.has(Effect::lighting))
    lightAlong(terms, framed.direction * terms.spacing * terms.lengthMm, ray);
  limitTo(visible, stepMm, ray);
  return ray;
}

} // namespace

std::optional<Ray> rayOf(const PictureTerms& terms, int x, int y) {
  const FramedRay framed = framedRay(terms.frame, x, y, terms.size);
  const RaySpan visible = spanInBox(framed, terms.visibleBox);
  if (visible.isEmpty())
    return std::nullopt;
  const RaySpan span = spanInBox(framed, terms.box);
  return span.isEmpty() ? std::nullopt : std::optional(divided(terms, framed, span, visible, x, y));
}

std::optional<Ray> rayUpTo(const PictureTerms& terms, const Ray& ray, int x, int y, double steps) {
  RaySpan span = ray.span;
  span.end = span.begin + steps * (span.end - span.begin) / ray.count;
  if (span.isEmpty())
    return std::nullopt;
  return divided(terms, ray.framed, span, spanInBox(ray.framed, terms.visibleBox), x, y);
}

Ray inLengths(const PictureTerms& terms, const Ray& ray) {
  Ray result = ray;
  place(terms, 0.0, terms.lengthMm, result);
  return result;
}

} // namespace limn::cpu
