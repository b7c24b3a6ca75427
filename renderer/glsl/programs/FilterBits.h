// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glsl/decisions/Decisions.h"
#include "scene/effects/EffectPlan.h"

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// How finely the driver of the current context weighs the texels between which it filters: so many bits has
/// the fraction. Graphics cards commonly have 8 (NVIDIA's programming guide states it, AMD's driver reports
/// it), and a value between voxels is then off by up to 1/512 of what the cell changes by along an axis,
/// which no smaller step mends. Measured by a ramp between two texels, drawn at 2^`mostFilterBits` places;
/// that many where each got a value of its own. Of the decisions those about weights count. Leaves the state
/// of the context as it was. Throws Error (openGl).
int filterBits(const Decisions& decisions = {});

/// The same from what a driver made of a ramp from 0 to 1 at that many places.
int filterBitsOf(const std::vector<float>& values);

/// "at least 12 bits", "8 bits: values between voxels are off by up to 1/512 of a cell's change".
std::string filterText(int bits);

/// The bits of one context, measured when they are first asked for.
class FilterBits {
public:
  explicit FilterBits(const Decisions& decisions = {}) : m_decisions(decisions) {}

  int measured() {
    if (!m_bits)
      m_bits = filterBits(m_decisions);
    return *m_bits;
  }

private:
  Decisions m_decisions;
  std::optional<int> m_bits;
};

} // namespace limn
