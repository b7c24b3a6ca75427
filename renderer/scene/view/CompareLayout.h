// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace limn {

/// How pictures stand beside each other: one with the scene's own model; two beside each other; two over
/// each other with a movable border; the amplified difference of two.
enum class CompareLayout { single, sideBySide, wipe, difference };

/// All of them, in the order in which they are offered.
inline constexpr std::array compareLayouts{CompareLayout::single, CompareLayout::sideBySide,
                                           CompareLayout::wipe, CompareLayout::difference};

/// How many pictures a layout has: 1 or 2.
inline int pictureCount(CompareLayout layout) {
  return layout == CompareLayout::single ? 1 : 2;
}

/// How many times `difference` shows the difference, right minus left, of the colour's part that differs
/// most: black where both are equal, up to one colour where the left is brighter and up to another where the
/// right is. Blue and orange are told apart by eyes of every kind.
inline constexpr double differenceGain = 4.0;
inline constexpr glm::dvec3 leftBrighterColor{0.30, 0.62, 1.0};
inline constexpr glm::dvec3 rightBrighterColor{1.0, 0.62, 0.16};

/// The word for a layout in session files.
inline const char* nameOf(CompareLayout layout) {
  constexpr std::array names{"single", "side_by_side", "wipe", "difference"};
  return names[static_cast<std::size_t>(layout)];
}

} // namespace limn
