// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/SceneData.h"
#include "engine/PixelRect.h"
#include "scene/basics/Image.h"
#include "scene/steps/RayFrame.h"

#include <optional>
#include <vector>

namespace limn {

/// The box of a volume that a crop leaves, divided by planes across its axes into bricks of nearly equal
/// size. Bricks are half open boxes in centred index coordinates; faces on the end of the whole box lie
/// infinitely far, so that every sample of a ray lies in exactly one brick.
class Bricks {
public:
  /// `count` ≥ 1 bricks; where there are more of them than slices, bricks are thinner than a voxel. A volume
  /// `inSlices` is divided between its slices, where each brick has enough of them that what bricks need
  /// around them stays little.
  Bricks(const Grid& grid, const CropBox& crop, int count, bool inSlices = false);

  int count() const { return static_cast<int>(m_boxes.size()); }
  const IndexBox& box(int brick) const { return m_boxes[static_cast<std::size_t>(brick)]; }

  /// All bricks, so ordered that no ray of the picture enters one before another that stands in front of it.
  /// Such an order exists for every camera, one within the box or on a face as well: on each plane the side
  /// of the eye comes first.
  std::vector<int> frontToBack(const RayFrame& frame) const;

private:
  // Bricks first … first + count - 1; those below the plane are the first `below` of them.
  struct Split {
    int first, below, count;
    int axis;
    double plane;
  };

  // Across `axis`, or the longest of each.
  void divide(const IndexBox& inner, const IndexBox& outer, int first, int count, std::optional<int> across);

  std::vector<IndexBox> m_boxes;
  std::vector<Split> m_splits; // each before those of its parts
};

/// The voxels of a grid whose centres lie in a brick: each is one brick's. May be empty.
VoxelBox ownVoxels(const Grid& grid, const IndexBox& brick);

/// The voxels that a picture may read of a brick, with steps of `stepVoxels` at most: its own, too, and the
/// neighbours of those.
VoxelBox voxelsRead(const Grid& grid, const IndexBox& brick, double stepVoxels);

/// What is done with the shares of the bricks of a picture (README.md).
enum class Folding {
  over,    ///< pixels: those of bricks in front over those behind
  largest, ///< scalars: the larger of either component
  sum      ///< scalars: the sum of either component
};

/// One pixel of a brick where one scalar is classified for all of a ray: {the largest, {minus the smallest,
/// or {the sum of the scalars kept, normalised; then 1 where any were kept, or how many. Where none is, the
/// extremes are -∞.
using ScalarShare = glm::dvec2;

/// What a brick has found of the picture's surface.
struct SurfaceHits {
  std::vector<float> own;     ///< by this brick, in steps behind the first sample; +∞ where there is none
  std::vector<float> nearest; ///< of all bricks
};

/// Draws what one brick of a volume adds to a picture. The rays are those of the whole picture, and each of
/// their samples is taken by the brick in which it lies, a pre-integrated step by that of its sample. What
/// it keeps of the volume beside the voxels is for the brick and one step around it alone.
class BrickRenderer {
public:
  /// `threads` of the processor, 0: all. Throws as CpuRenderer does.
  explicit BrickRenderer(int threads = 0);

  /// What all of the volume holds, from now on; of volumes of which parts are held it must be known before
  /// begin(), others are looked at where it is absent.
  void setWhole(const std::optional<cpu::WholeFacts>& whole) { m_data.setWhole(whole); }

  /// Sets up a picture; everything below is of it. Throws Error, Cancelled.
  void begin(const Scene& scene, const glm::ivec2& size, const IndexBox& brick,
             const std::function<bool()>& isCancelled = {});

  Folding folding() const;
  bool hasSurface() const; ///< hits() must be known of all bricks before share() is asked

  /// All of these take a tile of the picture and give a value for each of its pixels, row by row.
  std::vector<float> hits(const PixelRect& tile);

  /// Premultiplied RGBA of the brick's part of the rays alone; of a surface where the brick has the nearest
  /// hit. `hits` is read where there is a surface.
  Image share(const PixelRect& tile, const SurfaceHits& hits = {});

  std::vector<ScalarShare> scalars(const PixelRect& tile);

  /// The picture of folded scalars.
  Image classified(const PixelRect& tile, const std::vector<ScalarShare>& folded) const;

  /// How many samples of the picture's rays were its own so far, those stepped over included.
  std::int64_t samples() const { return m_samples; }

  /// What it keeps beside the volume, MB (10⁶ bytes).
  double memoryMb() const { return m_data.memoryMb(); }
  double steepestPerMm() { return m_data.steepestPerMm(); }
  const EffectPlan& plan() const { return m_plan; }

  /// One sentence where rays get fewer samples than asked for, otherwise empty.
  const Message& limitation() const { return m_limitation; }

private:
  int m_threads;
  cpu::SceneData m_data;
  EffectPlan m_plan;
  cpu::PictureTerms m_terms;
  PixelRect m_covered;
  std::function<bool()> m_isCancelled;
  std::int64_t m_samples = 0;
  Message m_limitation;
};

/// The pixels of `front` over those of `back`, into `back`.
void foldOver(const glm::vec4* front, glm::vec4* back, std::size_t pixels);

/// The picture of a scene, drawn brick by brick in this process and folded as ranks would fold it. Every
/// brick ends its rays for itself: with early termination at e each leaves out at most the share 1 - e of
/// what shines through it. Throws Error.
Image drawInBricks(const Scene& scene, const glm::ivec2& size, int bricks, int threads = 0);

} // namespace limn
