// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/simd/InstructionSet.h"

#include "scene/basics/Error.h"

#include <hwy/targets.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace limn::cpu {
namespace {

struct Level {
  const char* word;
  const char* name;
  std::int64_t target; ///< Highway's bit: better sets have lower ones
};

#if HWY_ARCH_X86
constexpr Level levels[] = {
    {"avx512", "AVX-512", HWY_AVX3}, {"avx2", "AVX2", HWY_AVX2}, {"sse4", "SSE4", HWY_SSE4}};
#else
constexpr Level levels[] = {{"neon", "NEON", HWY_NEON}};
#endif

// Where one set alone is compiled it needs no look at the processor.
bool isHere(const Level& level) {
  return (HWY_SUPPORTED_TARGETS & level.target) != 0;
}

// The best level that the processor has; null below SSE4.
const Level* bestLevel() {
  const auto best = std::ranges::find_if(levels, isHere);
  return best == std::end(levels) ? nullptr : best;
}

std::string wordsOfLevels() {
  std::string words;
  for (const Level& level : levels)
    words += (words.empty() ? "" : ", ") + std::string(level.word);
  return words;
}

std::string chosenLevel() {
  const Level* best = bestLevel();
  if (!best)
    throw Error(Error::Kind::other,
                Message::tr("The CPU engine needs a processor with SSE4; draw with OpenGL on this one."));
  const char* wanted = std::getenv("LIMN_CPU_TARGET");
  if (!wanted || *wanted == '\0')
    return best->name;
  for (const Level& level : levels)
    if (std::string(wanted) == level.word) {
      if (!isHere(level))
        throw Error(Error::Kind::usage,
                    Message::tr("LIMN_CPU_TARGET is \"%1\", which this processor does not have; unset it.")
                        .arg(wanted));
      // Better sets have lower bits.
      hwy::DisableTargets(level.target - 1);
      return level.name;
    }
  throw Error(
      Error::Kind::usage,
      Message::tr("LIMN_CPU_TARGET is \"%1\"; use one of %2, or unset it.").arg(wanted).arg(wordsOfLevels()));
}

} // namespace

std::string instructionSetName() {
  static const std::string name = chosenLevel();
  return name;
}

void requireInstructionSet() {
  instructionSetName();
}

} // namespace limn::cpu
