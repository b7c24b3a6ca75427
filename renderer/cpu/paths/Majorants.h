// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/function/TransferFunction.h"
#include "scene/regions/BlockLooks.h"
#include "scene/regions/BlockWeights.h"
#include "scene/steps/BlockRanges.h"
#include "scene/volume/Volume.h"

#include <vector>

namespace limn::cpu {

/// What bounds the extinction in a block of cells, beside the scalars that it holds.
struct MajorantKey {
  std::vector<TransferFunction> functions; ///< of all looks, the scene's own first
  double mostFactor = 1.0;                 ///< that the gradient may multiply an opacity by, 0..1
  double lengthMm = 1.0;                   ///< per which extinctions are told
  ValueRange range;
  bool operator==(const MajorantKey&) const = default;
};

/// For each block of cells an extinction that no place in it exceeds: what free ways of light are drawn with.
class Majorants {
public:
  /// `looks` (one function: not read) and `weights` (may be empty) are of the blocks. Throws Cancelled; what
  /// Room does.
  void find(const MajorantKey& key, const BlockRanges& ranges, const BlockLooks& looks,
            const BlockWeights& weights, const std::shared_ptr<Room>& room, const Effort& effort);

  const float* data() const { return m_ofBlocks.data(); }
  std::size_t bytes() const { return m_ofBlocks.size() * sizeof(float); }

private:
  RoomVector<float> m_ofBlocks;
};

} // namespace limn::cpu
