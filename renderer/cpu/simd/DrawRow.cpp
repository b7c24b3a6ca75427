// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/simd/DrawRow.h"

// Highway compiles what follows once for each instruction set, this file included by itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/simd/DrawRow.cpp"
#include <hwy/foreach_target.h>
// The order matters.
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "cpu/simd/Projections-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// Highway's dispatch asks for them; requireInstructionSet() refuses such processors.
void drawRowHere(const PictureTerms&, int, int, int, glm::vec4*) {}
std::int64_t drawSharesHere(const PictureTerms&, int, int, int, const RowHits&, glm::vec4*) {
  return 0;
}
void findHitsHere(const PictureTerms&, int, int, int, float*) {}
std::int64_t findScalarsHere(const PictureTerms&, int, int, int, glm::dvec2*) {
  return 0;
}
void classifyScalarsHere(const PictureTerms&, const glm::dvec2*, std::size_t, glm::vec4*) {}

#else

template <VoxelSource::Kind kind>
struct Pixels {
  using Result = void;

  static void of(const PictureTerms& terms, int y, int fromX, int toX, glm::vec4* out) {
    const bool isPreintegrated = terms.effects.has(Effect::preintegration);
    for (int x = fromX; x < toX; x += lanes()) {
      Rays rays(terms, x, toX, y);
      if (terms.empty.distances && !terms.looksAtLeaps)
        leapToFirst(terms.empty, isPreintegrated, rays);
      for (int lane = 0; lane < std::min(lanes(), toX - x); ++lane) {
        glm::vec4 pixel(0.0f);
        // Cells may show between the last sample and the exit.
        if (terms.fineness ? rays.isSeen(lane) : rays.hasSamples(lane)) {
          const Ray ray = rays.ray(lane);
          pixel = Marcher<kind>(terms, ray).pixel();
        }
        *out++ = pixel;
      }
    }
  }
};

template <VoxelSource::Kind kind>
struct Shares {
  using Result = std::int64_t;

  static std::int64_t of(const PictureTerms& terms, int y, int fromX, int toX, const RowHits& hits,
                         glm::vec4* out) {
    const bool isPreintegrated = terms.effects.has(Effect::preintegration);
    std::int64_t samples = 0;
    for (int x = fromX; x < toX; x += lanes()) {
      Rays rays(terms, x, toX, y);
      if (terms.empty.distances)
        leapToFirst(terms.empty, isPreintegrated, rays);
      for (int lane = 0; lane < std::min(lanes(), toX - x); ++lane) {
        const int pixel = x + lane - fromX;
        out[pixel] = glm::vec4(0.0f);
        if (!rays.isSeen(lane))
          continue;
        const Ray ray = rays.ray(lane);
        samples += ray.ownTo - ray.ownFrom;
        const Marcher<kind> marcher(terms, ray);
        out[pixel] = hits.own ? marcher.share(hits.own[pixel], hits.nearest[pixel]) : marcher.pixel();
      }
    }
    return samples;
  }
};

template <VoxelSource::Kind kind>
struct Hits {
  using Result = void;

  // Rays do not leap to what shows: one that the brick hits where it enters or leaves need not have any.
  static void of(const PictureTerms& terms, int y, int fromX, int toX, float* out) {
    for (int x = fromX; x < toX; x += lanes()) {
      const Rays rays(terms, x, toX, y);
      for (int lane = 0; lane < std::min(lanes(), toX - x); ++lane) {
        float& hit = out[x + lane - fromX];
        hit = std::numeric_limits<float>::infinity();
        if (!rays.isSeen(lane))
          continue;
        const Ray ray = rays.ray(lane);
        hit = Marcher<kind>(terms, ray).hit();
      }
    }
  }
};

template <VoxelSource::Kind kind>
struct Scalars {
  using Result = std::int64_t;

  static std::int64_t of(const PictureTerms& terms, int y, int fromX, int toX, glm::dvec2* out) {
    std::int64_t samples = 0;
    for (int x = fromX; x < toX; x += lanes()) {
      const Rays rays(terms, x, toX, y);
      for (int lane = 0; lane < std::min(lanes(), toX - x); ++lane) {
        if (!rays.isSeen(lane))
          continue;
        const Ray ray = rays.ray(lane);
        samples += ray.ownTo - ray.ownFrom;
        out[x + lane - fromX] = Marcher<kind>(terms, ray).scalars();
      }
    }
    return samples;
  }
};

// The work for voxels of the kind that the picture has.
template <template <VoxelSource::Kind> class Work, class... Arguments>
typename Work<VoxelSource::Kind::byte>::Result forKind(const PictureTerms& terms, Arguments&&... arguments) {
  switch (terms.voxels.kind) {
  case VoxelSource::Kind::byte:
    return Work<VoxelSource::Kind::byte>::of(terms, arguments...);
  case VoxelSource::Kind::signedByte:
    return Work<VoxelSource::Kind::signedByte>::of(terms, arguments...);
  case VoxelSource::Kind::half:
    return Work<VoxelSource::Kind::half>::of(terms, arguments...);
  case VoxelSource::Kind::signedHalf:
    return Work<VoxelSource::Kind::signedHalf>::of(terms, arguments...);
  case VoxelSource::Kind::single:
    break;
  }
  return Work<VoxelSource::Kind::single>::of(terms, arguments...);
}

void drawRowHere(const PictureTerms& terms, int y, int fromX, int toX, glm::vec4* out) {
  forKind<Pixels>(terms, y, fromX, toX, out);
}

std::int64_t drawSharesHere(const PictureTerms& terms, int y, int fromX, int toX, const RowHits& hits,
                            glm::vec4* out) {
  return forKind<Shares>(terms, y, fromX, toX, hits, out);
}

void findHitsHere(const PictureTerms& terms, int y, int fromX, int toX, float* out) {
  forKind<Hits>(terms, y, fromX, toX, out);
}

std::int64_t findScalarsHere(const PictureTerms& terms, int y, int fromX, int toX, glm::dvec2* out) {
  return forKind<Scalars>(terms, y, fromX, toX, out);
}

void classifyScalarsHere(const PictureTerms& terms, const glm::dvec2* scalars, std::size_t pixels,
                         glm::vec4* out) {
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    out[pixel] = classifiedOnce(terms, scalars[pixel]);
}

#endif

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "cpu/simd/InstructionSet.h"

namespace limn::cpu {

HWY_EXPORT(drawRowHere);
HWY_EXPORT(drawSharesHere);
HWY_EXPORT(findHitsHere);
HWY_EXPORT(findScalarsHere);
HWY_EXPORT(classifyScalarsHere);

void drawRow(const PictureTerms& terms, int y, int fromX, int toX, glm::vec4* out) {
  requireInstructionSet();
  HWY_DYNAMIC_DISPATCH(drawRowHere)(terms, y, fromX, toX, out);
}

std::int64_t drawShares(const PictureTerms& terms, int y, int fromX, int toX, const RowHits& hits,
                        glm::vec4* out) {
  requireInstructionSet();
  return HWY_DYNAMIC_DISPATCH(drawSharesHere)(terms, y, fromX, toX, hits, out);
}

void findHits(const PictureTerms& terms, int y, int fromX, int toX, float* out) {
  requireInstructionSet();
  HWY_DYNAMIC_DISPATCH(findHitsHere)(terms, y, fromX, toX, out);
}

std::int64_t findScalars(const PictureTerms& terms, int y, int fromX, int toX, glm::dvec2* out) {
  requireInstructionSet();
  return HWY_DYNAMIC_DISPATCH(findScalarsHere)(terms, y, fromX, toX, out);
}

void classifyScalars(const PictureTerms& terms, const glm::dvec2* scalars, std::size_t pixels,
                     glm::vec4* out) {
  requireInstructionSet();
  HWY_DYNAMIC_DISPATCH(classifyScalarsHere)(terms, scalars, pixels, out);
}

} // namespace limn::cpu

#endif
