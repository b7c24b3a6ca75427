// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace limn {

/// The transfer functions that a picture's labels have (DEFINITION section 10), by small numbers.
struct LabelLooks {
  /// The scene's own first, without points where all labels that show have another; one alone: no other one
  /// shows.
  std::vector<TransferFunction> functions;
  std::vector<std::uint8_t> ofLabel; ///< the function of each label, by its place in the list

  bool areAny() const { return functions.size() > 1; }
  bool operator==(const LabelLooks&) const = default;
};

/// The looks that count in a picture of the scene: none but the scene's own function unless a label that some
/// voxel has, and that weighs more than 0, has another one, and samples are classified one by one.
LabelLooks labelLooks(const Scene& scene);

/// The region whose label at this place in the list has this look, or the scene's where there is none; the
/// cut that made a piece knows it, too. Throws as withLooks.
Region withLookOf(const Region& region, std::size_t place, const std::optional<TransferFunction>& look);

/// The same opacities in one colour: with what the look of a label or a piece begins.
TransferFunction inOneColor(TransferFunction function, const glm::dvec3& color);

/// Whether labelLooks has any but the scene's own.
bool hasLabelLooks(const Scene& scene);

/// The function of a voxel, by its position in the stored array.
const TransferFunction& functionAt(const LabelLooks& looks, const Region& region, std::size_t voxel);

/// What of a place belongs to the voxels of one look.
struct LookShare {
  std::size_t look = 0; ///< among LabelLooks::functions
  double share = 0.0;   ///< s_q, > 0
  double weight = 0.0;  ///< W_q, the mean weight of those voxels by the same shares
};

/// The shares of the looks at a place; they sum to 1.
struct LookShares {
  std::array<LookShare, 8> all;
  std::size_t count = 0;
  std::span<const LookShare> used() const { return {all.data(), count}; }
};

/// The shares at a continuous voxel index: trilinear between voxel centres, clamped to the edge beyond the
/// outermost centres, as weightAt. `looks` are any of this region.
LookShares lookSharesAt(const LabelLooks& looks, const Region& region, const glm::dvec3& index);

/// The look of all eight voxels of the cell that holds a continuous voxel index, clamped as above; absent
/// where they have several.
std::optional<std::size_t> lookOfCell(const LabelLooks& looks, const Region& region, const glm::dvec3& index);

/// Values in ascending order between which each of several functions is one line, and where each is there.
struct LookSegments {
  std::vector<double> values; ///< all different
  /// For each gap, the one below the first value first, and in it for each function: its first point above.
  std::vector<std::vector<std::size_t>> segments;
};

LookSegments lookSegments(const std::vector<TransferFunction>& functions);

/// The same functions, each with points at the values of all, as many at each: the same knots.
std::vector<TransferFunction> withCommonPoints(const std::vector<TransferFunction>& functions);

/// One function with the points of all, which shows a gap between two of them where one of the functions
/// does. Its colours mean nothing, and neither does its unit distance.
TransferFunction unionOf(const std::vector<TransferFunction>& functions);

} // namespace limn
