// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/LabelLooks.h"
#include "scene/basics/StableMath.h"
#include "scene/effects/EffectPlan.h"
#include "scene/function/MeanMaterial.h"
#include "scene/light/Gradient.h"
#include "scene/light/GradientField.h"
#include "scene/light/LightingTerms.h"
#include "scene/steps/BlockWalk.h"
#include "scene/steps/CellRule.h"
#include "scene/steps/RayFrame.h"
#include "scene/volume/Volume.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace limn {

/// The eight voxels around a position and its weights between them.
struct Cell {
  glm::ivec3 low{0};      ///< the voxel with the smallest indices
  glm::dvec3 weight{0.0}; ///< 0..1 towards low + 1
};

/// Reads a volume in its stored type: trilinear scalars and gradients in double (DEFINITION sections 1 and
/// 2).
template <class T>
class FieldSampler {
public:
  FieldSampler(const Volume& volume, const StoredVoxels<T>& stored)
      : m_stored(stored.data()), m_dims(volume.grid().dims), m_rescale(volume.rescale()),
        m_spacing(volume.grid().spacingMm), m_strideY(m_dims.x),
        m_strideZ(static_cast<std::ptrdiff_t>(m_dims.x) * m_dims.y) {}

  /// The cell of a continuous index, clamped to the outermost voxel centres.
  Cell cellAt(const glm::dvec3& index) const {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
      const double p = std::clamp(index[axis], 0.0, m_dims[axis] - 1.0);
      cell.low[axis] = std::min(static_cast<int>(p), std::max(0, m_dims[axis] - 2));
      cell.weight[axis] = p - cell.low[axis];
    }
    return cell;
  }

  /// The scalar, interpolated trilinearly.
  double scalarAt(const Cell& cell) const {
    const std::ptrdiff_t x = m_dims.x > 1 ? 1 : 0;
    const std::ptrdiff_t y = m_dims.y > 1 ? m_strideY : 0;
    const std::ptrdiff_t z = m_dims.z > 1 ? m_strideZ : 0;
    const T* v = m_stored + offset(cell.low);
    const auto alongX = [&](const T* p) { return mix(double(p[0]), double(p[x]), cell.weight.x); };
    const auto alongY = [&](const T* p) { return mix(alongX(p), alongX(p + y), cell.weight.y); };
    return m_rescale.slope * mix(alongY(v), alongY(v + z), cell.weight.z) + m_rescale.intercept;
  }

  /// The gradient along the grid's axes, value/mm: voxel gradients interpolated trilinearly, which is the
  /// central difference of the interpolated field over an apron extrapolated linearly.
  glm::dvec3 gradientAt(const Cell& cell) const {
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
      gradient[axis] = m_dims[axis] > 1 ? derivativeAt(cell, axis) : 0.0;
    return gradient * m_rescale.slope;
  }

private:
  static double mix(double a, double b, double w) { return a + w * (b - a); }

  std::ptrdiff_t offset(const glm::ivec3& i) const { return i.x + i.y * m_strideY + i.z * m_strideZ; }

  std::ptrdiff_t stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? m_strideY : m_strideZ; }

  // The derivative at voxel `index` of the line through p along an axis, stored value/mm.
  double difference(const T* p, int axis, int index) const {
    const std::ptrdiff_t step = stride(axis);
    const bool hasLower = index > 0;
    const bool hasUpper = index + 1 < m_dims[axis];
    const double upper = p[hasUpper ? step : 0];
    const double lower = p[hasLower ? -step : 0];
    return (upper - lower) / ((int(hasLower) + int(hasUpper)) * m_spacing[axis]);
  }

  double derivativeAt(const Cell& cell, int axis) const {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const std::ptrdiff_t alongU = m_dims[u] > 1 ? stride(u) : 0;
    const std::ptrdiff_t alongV = m_dims[v] > 1 ? stride(v) : 0;
    const T* low = m_stored + offset(cell.low);
    const auto along = [&](const T* p) {
      return mix(difference(p, axis, cell.low[axis]), difference(p + stride(axis), axis, cell.low[axis] + 1),
                 cell.weight[axis]);
    };
    const auto acrossU = [&](const T* p) { return mix(along(p), along(p + alongU), cell.weight[u]); };
    return mix(acrossU(low), acrossU(low + alongV), cell.weight[v]);
  }

  const T* m_stored;
  glm::ivec3 m_dims;
  Rescale m_rescale;
  glm::dvec3 m_spacing;
  std::ptrdiff_t m_strideY;
  std::ptrdiff_t m_strideZ;
};

/// What every ray of a picture shares.
struct PictureTerms {
  const Scene& scene;
  EffectSet effects;     ///< that the scene calls for; decides on the steps only, and whether light travels
  bool isByCells = true; ///< how a tolerance is kept
  LightingTerms terms = lightingTerms(scene.shading);
  const Grid& grid = scene.volume->grid();
  IndexBox box = croppedBox(grid, scene.crop);
  CutPlanes cut = cutPlanes(grid, scene.crop);
  bool isCut = scene.crop != CropBox{};
  double step = stepMm(scene);
  int mostSamples = limn::mostSamples; ///< of one ray
  double smallestMm = smallestSpacingMm(grid);
  glm::dvec3 centre = centreIndex(grid);
  std::optional<glm::dvec3> towardsLight = limn::towardsLight(terms, scene.camera, grid);
  bool hasGradientOpacity = scene.gradientOpacity && !scene.gradientOpacity->points.empty();
  bool hasRegion = isRestricting(scene.keep);
  bool changesOpacity = hasRegion || hasGradientOpacity || terms.mapsOpacity() || terms.opacity.atFlat != 1.0;
  bool readsGradient = terms.usesNormal() || terms.usesRatio() || hasGradientOpacity;
  /// Scalars and surfaces are found cell by cell, too.
  bool isExact = scene.quality.toleranceLevels && isByCells;
  std::optional<double> fineness =
      effects.has(Effect::localSteps) && isByCells ? finenessOf(scene.quality) : std::nullopt;
  std::optional<LocalStepTerms> local =
      effects.has(Effect::localSteps) && !isByCells ? localStepTerms(scene) : std::nullopt;
  LabelLooks looks = labelLooks(scene);
  bool hasLooks = looks.areAny();
  /// Over which extinctions are told: the unit distance, of looks, which have each their own, a length.
  double unitMm = hasLooks ? smallestMm : scene.transferFunction.unitDistanceMm;
  LookSegments segments = hasLooks ? lookSegments(looks.functions) : LookSegments{};
  /// Of the field whose gradients smooth normals follow; null: they follow that in `scale`, or none is
  /// smooth.
  const FieldSampler<double>* smoothed = nullptr;
  const PictureTerms* lightPaths = nullptr; ///< of the paths of light that travels; null where none does
  GradientScale scale = readsGradient ? gradientScale(*scene.volume, scene.shading) : GradientScale{};
};

/// What a ray meets in equal steps, a sample `offset` steps behind the start of each (DEFINITION section 7).
/// Places along it are in steps from the entry.
template <class T>
class RaySamples {
public:
  /// What a pre-integrated step within one look has of it.
  struct LookMean {
    std::size_t look = 0;    ///< among LabelLooks::functions
    double extinction = 0.0; ///< mean, over that look's unit distance
  };

  /// What one step absorbs: its opacity and extinction over the unit distance, and its colour.
  struct Material {
    double opacity = 0.0;
    double extinction = 0.0;
    glm::dvec3 color{0.0};
    std::optional<std::size_t> gap; ///< of looks (LookSegments) where a piece of the functions is known
    std::optional<LookMean> mean{}; ///< where the step lies within one look
  };

  /// What a material absorbs at a place, over the unit distance, and its colour there.
  struct Absorbed {
    double extinction = 0.0;
    glm::dvec3 color{0.0};
  };

  /// The unit gradient with its modulus, and r; 0 where nothing reads them.
  struct Steepness {
    glm::dvec4 gradient{0.0};
    double ratio = 0.0;
  };

  RaySamples(const PictureTerms& terms, const FieldSampler<T>& field, const FramedRay& ray,
             const RaySpan& span, double offset)
      : m_terms(terms), m_field(field), m_ray(ray), m_offset(offset) {
    divide(span);
  }

  /// From now on of another part of the ray.
  void divide(const RaySpan& span) {
    m_span = span;
    m_count = sampleCount(span.end - span.begin, m_terms.step, m_terms.mostSamples);
    m_dt = (span.end - span.begin) / m_count;
  }

  /// From now on places are in mm from the entry, for steps that are not equal.
  void countInMm() {
    m_offset = 0.0;
    m_dt = 1.0;
  }

  int count() const { return m_count; }
  double offset() const { return m_offset; }
  double stepMm() const { return m_dt; }
  const RaySpan& span() const { return m_span; }
  const FramedRay& ray() const { return m_ray; }

  double tAt(double place) const { return m_span.begin + place * m_dt; }
  glm::dvec3 centredAt(double place) const { return m_ray.anchor + tAt(place) * m_ray.direction; }
  double scalarAt(double place) const { return m_field.scalarAt(cellAt(place)); }

  /// What the kept region leaves of the opacity.
  double weightAt(double place) const {
    return m_terms.hasRegion ? limn::weightAt(m_terms.scene.keep, centredAt(place) + m_terms.centre) : 1.0;
  }
  bool isKept(double place) const { return weightAt(place) >= keptWeight; }

  Material materialAt(double place) const {
    const bool isPreintegrated = m_terms.effects.has(Effect::preintegration);
    if (m_terms.hasLooks) {
      const std::optional<std::size_t> look = isPreintegrated ? lookOfStep(place) : std::nullopt;
      return look ? meanOfLook(place, *look) : mixedMaterial(place, scalarAt(place), std::nullopt);
    }
    if (isPreintegrated) {
      const MeanMaterial mean = meanOver(m_terms.scene.transferFunction, place);
      return {oneMinusExpNeg(mean.extinction), mean.extinction, mean.color, {}};
    }
    const Classified classified = classify(m_terms.scene.transferFunction, scalarAt(place));
    return {classified.opacity, minusLog1mOpacity(classified.opacity), classified.color, {}};
  }

  /// What lies between two neighbouring points of the function, `segment - 1` and `segment`, the outer ones
  /// without end; where labels have looks, in a gap of LookSegments.
  Material materialIn(std::size_t segment, double place, double scalar) const {
    if (m_terms.hasLooks)
      return mixedMaterial(place, scalar, segment);
    return materialIn(m_terms.scene.transferFunction, segment, scalar);
  }

  static Material materialIn(const TransferFunction& function, std::size_t segment, double scalar) {
    const std::vector<ControlPoint>& points = function.points;
    if (points.empty())
      return {};
    const ControlPoint& below = points[segment > 0 ? segment - 1 : 0];
    const ControlPoint& above = points[std::min(segment, points.size() - 1)];
    const double width = above.value - below.value;
    const double share = width > 0.0 ? std::clamp((scalar - below.value) / width, 0.0, 1.0) : 0.0;
    const double opacity = below.opacity + share * (above.opacity - below.opacity);
    return {opacity, minusLog1mOpacity(opacity), below.color + share * (above.color - below.color), {}};
  }

  Steepness steepnessAt(double place) const {
    if (!m_terms.readsGradient)
      return {};
    const glm::dvec4 gradient = safeNormal(gradientAt(place));
    return {gradient, gradientRatio(m_terms.terms, m_terms.scale, gradient.w)};
  }

  /// What a material absorbs there. Opacities change before they become extinctions, so that the picture does
  /// not depend on the step.
  Absorbed absorbedAt(double place, const Material& material, const Steepness& steepness) const {
    const CoefficientRange& o = m_terms.terms.opacity;
    if (m_terms.hasLooks) {
      double factor = mapped(steepness.ratio, o.atFlat, o.atBoundary);
      if (m_terms.hasGradientOpacity)
        factor *= gradientOpacityAt(*m_terms.scene.gradientOpacity, steepness.gradient.w);
      if (material.mean)
        return {extinctionOf(*material.mean, weightAt(place) * factor), material.color};
      return mixedAt(place, scalarAt(place), material.gap, factor);
    }
    if (!m_terms.changesOpacity)
      return {material.extinction, material.color};
    double opacity = material.opacity * mapped(steepness.ratio, o.atFlat, o.atBoundary);
    if (m_terms.hasGradientOpacity)
      opacity *= gradientOpacityAt(*m_terms.scene.gradientOpacity, steepness.gradient.w);
    return {minusLog1mOpacity(opacity * weightAt(place)), material.color};
  }

  /// The extinction of an X-ray, which knows no other factor of the opacity.
  double absorptionAt(double place, const Material& material) const {
    if (m_terms.hasLooks)
      return material.extinction;
    const double weight = weightAt(place);
    return weight == 1.0 ? material.extinction : minusLog1mOpacity(weight * material.opacity);
  }

  /// What a length of this extinction absorbs, 0..1.
  double alphaOf(double extinction, double lengthMm) const {
    return oneMinusExpNeg(extinction * lengthMm / m_terms.unitMm);
  }

  /// Where the field first reaches the isovalue in what is kept; absent where it stays below.
  std::optional<double> firstHit() const {
    const auto isHitAt = [this](double place) {
      return scalarAt(place) >= m_terms.scene.isovalue && isKept(place);
    };
    const double exit = m_count;
    double below = 0.0;
    if (isHitAt(below))
      return below;

    // Find the first sample at or above the isovalue; the exit counts as the last one.
    std::optional<double> above;
    for (int i = 0; i <= m_count && !above; ++i) {
      const double place = std::min(i + m_offset, exit);
      (isHitAt(place) ? above.emplace() : below) = place;
    }
    if (!above)
      return std::nullopt;

    // Halve the bracket.
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (below + *above);
      (isHitAt(middle) ? *above : below) = middle;
    }
    return above;
  }

private:
  // Along the grid's axes, value/mm; of the smoothed field where normals are smooth.
  glm::dvec3 gradientAt(double place) const {
    if (m_terms.smoothed)
      return m_terms.smoothed->gradientAt(cellAt(place));
    return m_terms.scale.smoothed
               ? followedGradientAt(*m_terms.scene.volume, m_terms.scale, centredAt(place) + m_terms.centre)
               : m_field.gradientAt(cellAt(place));
  }

  // The means of a function over the step around a place.
  MeanMaterial meanOver(const TransferFunction& function, double place) const {
    return meanMaterial(function, scalarAt(place - m_offset), scalarAt(place + 1.0 - m_offset));
  }

  // The look within which the step around a place lies; absent where there is none.
  std::optional<std::size_t> lookOfStep(double place) const {
    const auto lookAt = [this](double at) {
      return lookOfCell(m_terms.looks, m_terms.scene.keep, centredAt(at) + m_terms.centre);
    };
    const std::optional<std::size_t> look = lookAt(place);
    const bool isOne = look && lookAt(place - m_offset) == look && lookAt(place + 1.0 - m_offset) == look;
    return isOne ? look : std::nullopt;
  }

  Material meanOfLook(double place, std::size_t look) const {
    const MeanMaterial over = meanOver(m_terms.looks.functions[look], place);
    const LookMean mean{look, over.extinction};
    const double extinction = extinctionOf(mean, weightAt(place));
    return {oneMinusExpNeg(extinction), extinction, over.color, {}, mean};
  }

  // Over the unit of extinctions, the opacity times `factor`.
  double extinctionOf(const LookMean& mean, double factor) const {
    const double extinction =
        factor == 1.0 ? mean.extinction : minusLog1mOpacity(factor * oneMinusExpNeg(mean.extinction));
    return extinction * unitsOf(mean.look);
  }

  // Unit distances of a look in the unit of extinctions.
  double unitsOf(std::size_t look) const {
    return std::min(m_terms.unitMm / m_terms.looks.functions[look].unitDistanceMm, beyondAll);
  }

  // What the looks of the voxels around a place absorb together (DEFINITION section 10), each opacity times
  // `factor`.
  Absorbed mixedAt(double place, double scalar, const std::optional<std::size_t>& gap, double factor) const {
    const LookShares shares =
        lookSharesAt(m_terms.looks, m_terms.scene.keep, centredAt(place) + m_terms.centre);
    Absorbed mixed;
    for (const LookShare& one : shares.used()) {
      const TransferFunction& function = m_terms.looks.functions[one.look];
      Material material;
      if (gap) {
        material = materialIn(function, m_terms.segments.segments[*gap][one.look], scalar);
      } else {
        const Classified classified = classify(function, scalar);
        material = {classified.opacity, 0.0, classified.color, {}};
      }
      const double extinction =
          one.share * minusLog1mOpacity(one.weight * factor * material.opacity) * unitsOf(one.look);
      mixed.extinction += extinction;
      mixed.color += extinction * material.color;
    }
    if (mixed.extinction > 0.0)
      mixed.color /= mixed.extinction;
    return mixed;
  }

  // The same as a material that nothing changes further.
  Material mixedMaterial(double place, double scalar, const std::optional<std::size_t>& gap) const {
    const Absorbed mixed = mixedAt(place, scalar, gap, 1.0);
    return {oneMinusExpNeg(mixed.extinction), mixed.extinction, mixed.color, gap};
  }

  Cell cellAt(double place) const { return m_field.cellAt(centredAt(place) + m_terms.centre); }

  // So many unit distances hide everything, and their extinction has a product with any other number.
  static constexpr double beyondAll = 1e200;

  static constexpr int halvings = 14; // to less than 1e-4 of a step

  const PictureTerms& m_terms;
  const FieldSampler<T>& m_field;
  FramedRay m_ray;
  RaySpan m_span;
  double m_offset;
  int m_count = 1;
  double m_dt = 0.0;
};

} // namespace limn
