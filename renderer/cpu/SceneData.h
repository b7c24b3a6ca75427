// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/LightStore.h"
#include "cpu/LookStore.h"
#include "cpu/RegionStore.h"
#include "cpu/VoxelStore.h"
#include "cpu/paths/Majorants.h"
#include "cpu/paths/PathTerms.h"
#include "cpu/rays/PictureTerms.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/GradientField.h"
#include "scene/regions/BlockWeights.h"
#include "scene/steps/EmptySpace.h"

namespace limn::cpu {

/// What pictures need to know of all voxels beside the volume's range, where several processes found it.
struct WholeFacts {
  FoundModuli moduli;
  std::optional<double> percent; ///< of the percentile among the moduli
  double steepestPerMm = 0.0;
};

/// The blocks of a grid that samples of a brick can meet, and what they are widened by.
BlockBox blocksMet(const Grid& grid, const IndexBox& brick, double stepVoxels);

/// What the rays of a scene read. Keeps what it made of one scene for the next; makes anew what differs and
/// nothing else.
class SceneData {
public:
  /// `roundsPlaces`: voxels are floats and mixed as CpuRenderer::Weights says.
  /// `samplesFirst`: as CpuRenderer::Tolerance says.
  explicit SceneData(int threads, bool skipsEmptySpace, bool roundsPlaces = false, bool samplesFirst = false)
      : m_threads(threads), m_skipsEmptySpace(skipsEmptySpace), m_roundsPlaces(roundsPlaces),
        m_samplesFirst(samplesFirst) {}

  /// Only what rays read in this box is made ready from now on; absent: everything.
  void setBrick(const std::optional<IndexBox>& brick) { m_brick = brick; }

  /// What is not to be found of the volume's voxels from now on, because it is known.
  void setWhole(const std::optional<WholeFacts>& whole) { m_whole = whole; }

  /// Reads the volume and tabulates the functions of the scene that is drawn from now on. Asks `isCancelled`,
  /// which may be empty, at least every 10 ms. Throws Error; Cancelled, and then goes on from where it was.
  void update(const Scene& scene, const std::function<bool()>& isCancelled = {});

  /// Reads the volume alone, smooths it where the scene asks for that, and tells how far it is. Throws
  /// Cancelled.
  void makeReady(const Scene& scene, const Effort& effort);

  /// Facts on which the effects of the scene of the last update depend.
  SceneFacts facts(const Scene& scene);

  /// The steepness of the volume of the last update; measured once.
  double steepestPerMm();

  /// The terms of a picture of the scene of the last update. Points into this. Where light travels that is
  /// looked up on nodes, `light` stands for what would be found. Throws Cancelled.
  PictureTerms terms(const Scene& scene, const glm::ivec2& size, EffectSet effects,
                     const std::function<bool()>& isCancelled = {}, const LightVolumes* light = nullptr);

  /// What random paths share in the picture of these terms (DEFINITION section 12); the scene is a medium
  /// (cpu/paths/PathScene). Points into this. Throws Cancelled.
  PathTerms pathTerms(const Scene& scene, const PictureTerms& terms,
                      const std::function<bool()>& isCancelled = {});

  /// Of the picture whose terms were last asked for; meaningful where its lighting reads the gradient.
  const GradientScale& gradientScale() const { return m_gradientScale; }

  /// What it keeps of the volume in memory beside the volume itself, MB (10⁶ bytes).
  double memoryMb() const;

private:
  // What decides where nothing can be seen.
  struct EmptySpaceKey {
    TransferFunction function;
    Projection projection = Projection::composite;
    double isovalue = 0.0;
    Region keep;
    bool operator==(const EmptySpaceKey&) const = default;
  };

  void updateVolume(const Scene& scene, const Effort& effort);
  BlockBox partOf(const Scene& scene) const;
  void updateEmptySpace(const Scene& scene, const Effort& effort);
  IndexBox visibleBox(const Scene& scene) const;

  int m_threads;
  bool m_skipsEmptySpace;
  bool m_roundsPlaces;
  bool m_samplesFirst;
  std::optional<IndexBox> m_brick;
  std::optional<WholeFacts> m_whole;
  std::shared_ptr<const Volume> m_volume;
  std::optional<VoxelStore> m_voxels;
  RegionStore m_region;
  LookStore m_looks;
  LightStore m_light;
  std::optional<double> m_steepness;
  GradientField m_gradients;
  GradientScale m_gradientScale;

  std::optional<TransferFunction> m_functionKept;
  PiecewiseTable m_function;
  FewSegments m_segments; // of the function
  std::optional<GradientOpacity> m_gradientOpacityKept;
  PiecewiseTable m_gradientCurve;

  std::optional<EmptySpaceKey> m_emptySpaceKept;
  EmptySpaceMap m_empty;

  // What decides how much light anything in a block meets at most.
  struct PathsKey {
    MajorantKey majorants;
    Region keep;
    bool operator==(const PathsKey&) const = default;
  };
  std::optional<PathsKey> m_pathsKept;
  LabelLooks m_pathLooks;
  Majorants m_majorants;
};

} // namespace limn::cpu
