// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"

#include <span>

namespace limn::cpu {

// Both find what comes of light to some nodes of a grid, given by their numbers (x fastest), and write the
// codes that scene/light/LightGrid.h tells of into `out`, which has one for every node of the grid.
// Directions, steps and reach are those of `terms.travel`.

/// Of the light that has a direction.
void findDirect(const PictureTerms& terms, const LightNodes& nodes, std::span<const std::int32_t> numbers,
                std::uint8_t* out);

/// Of ambient light.
void findAmbient(const PictureTerms& terms, const LightNodes& nodes, std::span<const std::int32_t> numbers,
                 std::array<std::uint8_t, 4>* out);

} // namespace limn::cpu
