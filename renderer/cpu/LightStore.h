// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"
#include "scene/Scene.h"
#include "scene/basics/Effort.h"

#include <deque>
#include <memory>

namespace limn::cpu {

/// What light passes alike, whatever its colours and names: of functions, and of a kept region.
TransferFunction withoutColors(TransferFunction function);
Region withoutColors(Region keep);

/// Whether the scene's picture looks light up on nodes; others find it along paths, which meet voxels of a
/// volume on disk in no order, many times each: those of volumes in memory do, and look fine nodes up while
/// something moves only where these are there.
bool looksUpLight(const Scene& scene);

/// How the picture of these terms, whose `travel` is not set yet, asks what is known of its light; where
/// nothing is, it is found along paths: as many as its error may be, or as light at rest has (LightDetail).
TravelTerms travelIn(const LightVolumes& light, const Scene& scene, const PictureTerms& terms);

/// What comes of light that travels (DEFINITION section 11), found on grids of nodes and kept for pictures to
/// come: two looks that take turns, each fine and coarse.
class LightStore {
public:
  /// How the picture of these terms, whose `travel` alone is not set yet, finds it. Where the scene asks for
  /// a grid, over the box that shows, its nodes are found now unless they are there; fine ones that are there
  /// stand in for coarse ones. Throws Cancelled.
  TravelTerms update(const Scene& scene, const PictureTerms& terms, const IndexBox& shows,
                     const Effort& effort);

  /// What it takes, bytes.
  std::size_t ownBytes() const;

private:
  // All that decides what comes of light, but for the light.
  struct Key {
    std::shared_ptr<const Volume> volume;
    TransferFunction function;
    std::optional<GradientOpacity> gradientOpacity;
    CoefficientRange opacity;
    GradientCurve curve;
    float perReference = 0.0f;
    double smoothingMm = 0.0; // of gradients
    Region keep;
    CropBox crop;
    Projection projection = Projection::composite;
    double isovalue = 0.0;
    bool isCoarse = false;
    LightNodes nodes;
    glm::dvec3 towardsLight{0.0}; // 0: of ambient light
    double size = 0.0;            // softness, or reach
    bool operator==(const Key&) const = default;
  };

  struct Keys {
    Key direct, ambient;
  };

  template <class Light>
  struct Found {
    Key key;
    std::shared_ptr<const Light> light;
  };

  template <class Light>
  using Kept = std::deque<Found<Light>>; // the newest first

  template <class Light, class Find>
  static std::shared_ptr<const Light> of(Kept<Light>& kept, const Key& key, const Find& find);

  static Keys keysOf(const Scene& scene, const PictureTerms& terms, const IndexBox& shows, bool isCoarse);
  bool hasAll(const Keys& keys, EffectSet effects) const;

  Kept<DirectLight> m_direct;
  Kept<AmbientLight> m_ambient;
};

} // namespace limn::cpu
