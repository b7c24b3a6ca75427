// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace limn::cpu {

/// Chooses, once, the instructions that rays are computed with: the best that the processor has, or the lower
/// level that the environment variable LIMN_CPU_TARGET names (sse4, avx2 or avx512; neon on arm64), for
/// tests. Throws Error (usage) where it names something else or more than the processor has.
void requireInstructionSet();

/// The level chosen, for people: "AVX2". Throws as requireInstructionSet does.
std::string instructionSetName();

} // namespace limn::cpu
