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

// Highway's dispatch asks for it; requireInstructionSet() refuses such processors.
void drawRowHere(const PictureTerms&, int, int, int, glm::vec4*) {}

#else

template <VoxelSource::Kind kind>
void drawRowOf(const PictureTerms& terms, int y, int fromX, int toX, glm::vec4* out) {
  const bool isPreintegrated = terms.effects.has(Effect::preintegration);
  for (int x = fromX; x < toX; x += lanes()) {
    Rays rays(terms, x, toX, y);
    // Error-controlled steps walk from block to block themselves.
    if (terms.empty.distances && !terms.local)
      leapToFirst(terms.empty, isPreintegrated, rays);
    for (int lane = 0; lane < std::min(lanes(), toX - x); ++lane) {
      glm::vec4 pixel(0.0f);
      if (rays.hasSamples(lane)) {
        const Ray ray = rays.ray(lane);
        pixel = Marcher<kind>(terms, ray).pixel();
      }
      *out++ = pixel;
    }
  }
}

void drawRowHere(const PictureTerms& terms, int y, int fromX, int toX, glm::vec4* out) {
  switch (terms.voxels.kind) {
  case VoxelSource::Kind::byte:
    return drawRowOf<VoxelSource::Kind::byte>(terms, y, fromX, toX, out);
  case VoxelSource::Kind::signedByte:
    return drawRowOf<VoxelSource::Kind::signedByte>(terms, y, fromX, toX, out);
  case VoxelSource::Kind::half:
    return drawRowOf<VoxelSource::Kind::half>(terms, y, fromX, toX, out);
  case VoxelSource::Kind::signedHalf:
    return drawRowOf<VoxelSource::Kind::signedHalf>(terms, y, fromX, toX, out);
  case VoxelSource::Kind::single:
    return drawRowOf<VoxelSource::Kind::single>(terms, y, fromX, toX, out);
  }
}

#endif

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "cpu/simd/InstructionSet.h"

namespace limn::cpu {

HWY_EXPORT(drawRowHere);

void drawRow(const PictureTerms& terms, int y, int fromX, int toX, glm::vec4* out) {
  requireInstructionSet();
  HWY_DYNAMIC_DISPATCH(drawRowHere)(terms, y, fromX, toX, out);
}

} // namespace limn::cpu

#endif
