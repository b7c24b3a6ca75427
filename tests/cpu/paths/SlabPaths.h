// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/SceneData.h"
#include "cpu/paths/PathScene.h"
#include "cpu/paths/PathTracer.h"
#include "cpu/paths/Tone.h"
#include "scene/light/Shading.h"
#include "stability/scenes/SimpleScenes.h"

#include <cmath>

namespace limn::test {

/// The mean of numbers and how sure it is.
struct Tally {
  double sum = 0.0, squares = 0.0;
  long count = 0;
  void add(double x) {
    sum += x;
    squares += x * x;
    ++count;
  }
  double mean() const { return sum / static_cast<double>(count); }
  double error() const {
    const auto n = static_cast<double>(count);
    return std::sqrt(std::max(squares / n - mean() * mean(), 0.0) / (n - 1.0));
  }
  /// How many of its own standard errors it lies from what is expected.
  double z(double expected) const { return (mean() - expected) / error(); }
};

/// Tissue of one albedo between two planes square to z, seen from above: 1 mm thick, and so much wider that
/// no path sees its sides.
inline Scene slabScene(double albedo, double depth, double anisotropy) {
  Scene scene;
  scene.volume = volumeOf(centredGrid({3, 3, 1}, {1000.0, 1000.0, 1.0}), [](int, int, int) { return 7.0; });
  scene.transferFunction = constantFunction(-std::expm1(-1.0), glm::dvec3(cpu::encoded(albedo)), 1.0 / depth);
  scene.camera.projection = Camera::Projection::orthographic;
  scene.camera.position = {0.0, 0.0, 100.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.camera.heightMm = 1.0;
  scene.quality.earlyTermination = 1.0;
  scene.shading.model = ShadingModel::physical;
  scene.shading.knee.reset();
  PhysicalLight& light = scene.shading.physical;
  light.anisotropy = anisotropy;
  light.surface = 0.0;
  light.keyIrradiance = 0.0;
  light.keyRadiusDeg = 0.0;
  light.sky = {1.0, 1.0};
  return scene;
}

/// What paths of a scene read, with what they point into.
struct PathsOf {
  Scene medium;
  cpu::SceneData data{1, true};
  cpu::PictureTerms terms;
  cpu::PathTerms paths;

  explicit PathsOf(const Scene& scene, const glm::ivec2& size = {1, 1}) : medium(cpu::mediumOf(scene)) {
    data.update(medium);
    const EffectSet effects = requiredEffects(medium, data.facts(medium)).effects.with(Effect::exponentMap);
    terms = data.terms(medium, size, effects);
    paths = data.pathTerms(medium, terms);
  }
  PathsOf(const PathsOf&) = delete;
};

/// The half of the sky above or below the slab.
struct HalfSky {
  bool isAbove = true;
  float operator()(const glm::vec3& from) const { return (from.z > 0.0f) == isAbove ? 1.0f : 0.0f; }
};

/// What of the light of a half sky comes to the camera through collisions, seen along the slab's normal or,
/// `isDiffuse`, from all sides by the cosine. Light and camera may change places, so this is what the slab
/// sends up (or down) of light along its normal, or of diffuse light.
inline Tally slabLight(const PathsOf& slab, bool isAbove, bool isDiffuse, long paths, std::uint32_t seed) {
  const HalfSky sky{isAbove};
  const cpu::PathTracer<float, HalfSky> tracer(slab.paths, sky);
  Tally tally;
  for (long n = 0; n < paths; ++n) {
    cpu::PathRandom random(seed, isAbove ? 1u : 2u, isDiffuse ? 1u : 2u, static_cast<std::uint32_t>(n));
    cpu::PathStart start{{1.0f, 1.0f, slab.paths.upper.z}, {0.0f, 0.0f, -1.0f}, 0.0f};
    if (isDiffuse)
      start.direction = cpu::turnedFrom({0.0f, 0.0f, -1.0f}, std::sqrt(1.0f - random.next()), random);
    start.length = cpu::lengthInBox(slab.paths, start.place, start.direction);
    const auto radiance = tracer.radiance(start, random);
    tally.add(radiance ? double(radiance->r) : 0.0);
  }
  return tally;
}

/// One row of what is known of slabs: reflected and transmitted of light along the normal, and of diffuse
/// light, what goes through without a collision included. Found twice by adding-doubling (van de Hulst,
/// Multiple Light Scattering, 1980, has some of them); matched refractive index, black surroundings.
struct SlabRow {
  double albedo, depth, anisotropy;
  double reflected, transmitted, diffuseReflected, diffuseTransmitted;
};
inline constexpr SlabRow slabRows[] = {
    {1.0, 1.0, 0.0, 0.341329, 0.658671, 0.446594, 0.553406},
    {0.9, 1.0, 0.0, 0.267410, 0.591625, 0.352712, 0.474746},
    {0.8, 1.0, 0.0, 0.210847, 0.541400, 0.280152, 0.416245},
    {0.5, 1.0, 0.0, 0.099119, 0.446058, 0.134165, 0.306709},
    {1.0, 4.0, 0.0, 0.690926, 0.309074, 0.754029, 0.245971},
    {0.9, 10.0, 0.0, 0.414935, 0.005612, 0.478016, 0.003856},
    {0.9, 1.0, 0.5, 0.129793, 0.739091, 0.227953, 0.598548},
    {0.9, 2.0, 0.75, 0.097395, 0.660958, 0.191090, 0.501816},
    {1.0, 10.0, 0.75, 0.568975, 0.431025, 0.660444, 0.339556},
};

/// 2 E₃(τ): what of diffuse light goes through a slab without a collision. By Simpson's rule over the cosine.
inline double straightDiffuse(double depth) {
  constexpr int steps = 20000;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double mu = static_cast<double>(i) / steps;
    const double f = mu > 0.0 ? 2.0 * mu * std::exp(-depth / mu) : 0.0;
    sum += (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * f;
  }
  return sum / (3.0 * steps);
}

/// The largest |z| over all rows; each with its own numbers.
inline double largestSlabZ(long paths, double albedoFactor = 1.0) {
  double largest = 0.0;
  std::uint32_t seed = 1;
  for (const SlabRow& row : slabRows) {
    if (row.albedo * albedoFactor > 1.0)
      continue;
    const PathsOf slab(slabScene(row.albedo * albedoFactor, row.depth, row.anisotropy));
    const double straight = std::exp(-row.depth);
    const double straightOfDiffuse = straightDiffuse(row.depth);
    const double z[] = {
        slabLight(slab, true, false, paths, seed).z(row.reflected),
        slabLight(slab, false, false, paths, seed).z(row.transmitted - straight),
        slabLight(slab, true, true, paths, seed).z(row.diffuseReflected),
        slabLight(slab, false, true, paths, seed).z(row.diffuseTransmitted - straightOfDiffuse),
    };
    std::printf("a %.1f, depth %4.1f, g %.2f: z %+.2f %+.2f %+.2f %+.2f\n", row.albedo, row.depth,
                row.anisotropy, z[0], z[1], z[2], z[3]);
    for (const double one : z)
      largest = std::max(largest, std::abs(one));
    ++seed;
  }
  return largest;
}

} // namespace limn::test
