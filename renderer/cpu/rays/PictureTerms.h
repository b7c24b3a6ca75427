// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/effects/EffectSet.h"
#include "scene/function/PiecewiseTable.h"
#include "scene/light/LightGrid.h"
#include "scene/light/LightingTerms.h"
#include "scene/regions/BlockLooks.h"
#include "scene/steps/RayFrame.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace limn::cpu {

/// Voxels as the rays read them: 8 and 16 bits as stored, everything else as floats normalised over the
/// volume's range (scene/function/PiecewiseTable: normalisedValue).
struct VoxelSource {
  enum class Kind { byte, signedByte, half, signedHalf, single };
  Kind kind = Kind::byte;
  const unsigned char* begin = nullptr; ///< where voxel (0, 0, 0) is, or would be were it among these
  std::int64_t bytes = 0;               ///< from there to the end of the voxels
  float scale = 1.0f;                   ///< normalised scalar = scale · voxel + shift
  float shift = 0.0f;
  glm::ivec3 first{0};       ///< of the voxels; others are never read, whatever index is asked for
  glm::ivec3 dims{1};        ///< how many there are from the first on
  std::int64_t strideY = 0;  ///< bytes to the next row, 0 where there is one row
  std::int64_t strideZ = 0;  ///< bytes to the next slice, likewise
  bool roundsPlaces = false; ///< floats are mixed by a card's weights (CpuRenderer::Weights)
};

/// All voxels of a grid, one behind the other, x fastest; not the kind's bytes but `scale` times them count.
VoxelSource sourceOf(const void* voxels, VoxelSource::Kind kind, const glm::ivec3& dims, float scale = 1.0f);

/// Blocks of one kind: for each block of 4³ cells the distance in blocks to the nearest of another, 0 in
/// those (scene/steps/EmptySpace).
struct BlocksAlike {
  const std::uint8_t* distances = nullptr; ///< null: it is not known of any
  glm::ivec3 blocks{0};
  glm::ivec3 first{0}; ///< the block of the first distance
};

/// The segments of a function that has few (scene/function/PiecewiseTable), column by column: registers hold
/// a column, and picking from one takes no memory.
struct FewSegments {
  static constexpr int most = 16;
  static constexpr int perRegister = 8;
  int count = 0; ///< 0: the function has more than `most`
  alignas(64) float starts[most] = {};
  float ends[most] = {};
  float values[4][most] = {}; ///< colour and opacity at the start
  float slopes[4][most] = {}; ///< per unit of the argument
};

/// Column by column what the table holds row by row; without segments where they are not few.
FewSegments fewSegments(const PiecewiseTable& table);

/// The looks that labels have of their own (scene/LabelLooks).
struct LookTerms {
  /// One function and how many of its unit distances are in a length.
  struct Look {
    const PiecewiseTable* table = nullptr;
    const FewSegments* segments = nullptr;
    float perUnit = 1.0f;
  };
  std::vector<Look> all;                    ///< the scene's own first; none: no label has another
  VoxelSource voxels;                       ///< the look of each voxel, bytes
  const std::uint8_t* ofCells = nullptr;    ///< of each cell, by its voxel of smallest indices (cellLooks)
  const PiecewiseTable* together = nullptr; ///< one function whose pieces are those of all
  const FewSegments* segmentsTogether = nullptr;
};

/// How what comes of light that travels is found (DEFINITION section 11): from the nodes of a grid or
/// along paths from a ray's samples. Read where an effect needs it.
struct TravelTerms {
  using Directions = std::shared_ptr<const std::vector<glm::vec3>>;
  /// From voxel indices to nodes.
  struct ToNodes {
    glm::vec3 perIndex{0.0f}, shift{0.0f};
  };
  LightVolumes found;
  ToNodes toDirect, toAmbient;
  LightLook look;
  LayerLengths layers{};   ///< of what dims ambient light near a sample
  Directions towardsLight; ///< over the light, grid axes
  Directions byCosine;     ///< around a normal, the third axis
  Directions onSphere;     ///< as many
  int spread = 0;          ///< so many paths a pixel are spread over a ray's samples; 0: there are nodes
  float from = 1.5f;       ///< δ, lengths
  float reach = 0.0f;      ///< of occlusion, lengths
  float step = 0.5f;       ///< along a path at most, lengths
  float farStep = 0.5f;    ///< the same where it has left what is near
};

/// Everything that the rays of a picture share, in the units of the rays: lengths in smallest spacings,
/// scalars normalised over the volume's range, gradients in ranges per smallest spacing. Points to what its
/// owner (SceneData) keeps.
struct PictureTerms {
  EffectSet effects;
  VoxelSource voxels;
  VoxelSource smoothed; ///< normalised; whose gradients count where an effect smooths normals
  VoxelSource region;   ///< weights of the kept region, bytes or halves; read where an effect needs it
  BlocksAlike empty;    ///< in which nothing shows
  BlocksAlike whole;    ///< of which the region keeps everything
  LookTerms looks;      ///< read where an effect needs them
  const PiecewiseTable* function = nullptr; ///< the scene's, or where labels have looks, of all together
  const FewSegments* segments = nullptr;    ///< of the same function
  const PiecewiseTable* gradientCurve = nullptr;
  LightingTerms light;
  TravelTerms travel;
  int mostSamples = limn::mostSamples; ///< of a ray, in equal steps
  std::optional<double> fineness;      ///< of error-controlled steps; absent: equal steps
  bool samplesFirst = false;           ///< equal steps first, cells where those do not do
  bool looksAtLeaps = false;           ///< each, as something may show between samples in which nothing does
  bool isExact = false;                ///< scalars and surfaces are found cell by cell, too

  RayFrame frame;
  glm::ivec2 size{0};
  IndexBox box;                  ///< of the crop, centred index
  IndexBox visibleBox;           ///< outside which nothing shows
  std::optional<IndexBox> brick; ///< the part of the box whose samples are taken; absent: all of it
  glm::dvec3 centre{0.0};
  double lengthMm = 1.0; ///< the unit of lengths
  double stepLengths = 1.0;
  glm::dvec3 spacing{1.0};      ///< in unit lengths
  float perUnitDistance = 1.0f; ///< unit distances in a length; 1 where labels have looks with their own
  float lastTransmittance = 0.0f;

  glm::vec3 gradientScale{0.0f}; ///< from a difference of voxels, or of smoothed ones, over two to the unit
  float flatModulus = 0.0f;
  float perReference = 0.0f; ///< 1/gref, 0 where gref is 0
  float curve = 0.0f;        ///< gamma or b
  glm::dvec3 towardsLight{0.0};
  CutPlanes cut;

  glm::vec3 fogColor{0.0f};
  float fogStart = 0.0f, fogEnd = 0.0f; ///< from the anchor plane
  float fogDensity = 0.0f;

  float isovalue = 0.0f;
  glm::vec3 isoColor{0.0f};
};

/// One ray in equal steps, as its samples read it. Sample i lies `offset + i` steps behind the entry; the
/// samples of [from, to) are those that may show.
struct Ray {
  glm::ivec2 pixel{0};
  int count = 0; ///< N of DEFINITION section 7
  int from = 0, to = 0;
  int ownFrom = 0, ownTo = 0; ///< the samples of [ownFrom, ownTo) lie in the brick that is drawn
  float offset = 0.5f;
  glm::vec3 first{0.0f}, stride{0.0f};         ///< voxel index of sample 0, per step
  glm::vec3 firstIndex{0.0f};                  ///< centred index of sample 0
  float firstDepth = 0.0f, strideDepth = 0.0f; ///< distance from the eye less that of the anchor plane
  float units = 0.0f;                          ///< a step in unit distances
  glm::vec3 toViewer{0.0f}, toLight{0.0f}, halfway{0.0f};
  RaySpan span; ///< mm
};

/// The same ray with steps of one unit of length, sample 0 at its entry: for samples at lengths of their own.
Ray inLengths(const PictureTerms& terms, const Ray& ray);

/// The part of the ray of a pixel in the brick that is drawn, mm; all of the span where there is none.
RaySpan partInBrick(const PictureTerms& terms, const FramedRay& ray, const RaySpan& span);

} // namespace limn::cpu
