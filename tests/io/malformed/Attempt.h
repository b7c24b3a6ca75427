// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Corpus.h"

#include "support/Sanitizers.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>

namespace limn::test {

/// Longest time that reading may take, in seconds: of a processor, and on the clock of a quiet machine.
inline constexpr int longestSeconds = isSanitised ? 200 : 20;

/// What running in a process of its own came to.
struct ChildEnd {
  std::string said;            ///< what the child wrote
  bool isWell = false;         ///< it ended by itself
  std::string how;             ///< e.g. "killed by signal 11"
  double seconds = 0.0;        ///< wall clock
  std::uint64_t peakBytes = 0; ///< largest resident memory, libraries included
};

/// Runs `work` in a forked child, which is stopped after `seconds` of processor time, and where it only waits
/// after ten times as long; `work` writes by `say`. The caller must have started no thread.
ChildEnd inChild(const std::function<void(const std::function<void(const std::string&)>& say)>& work,
                 int seconds = longestSeconds);

/// How opening one path ended.
struct Attempt {
  bool isWell = false; ///< a volume or a refusal
  bool isVolume = false;
  std::string trouble; ///< of an attempt that is not well: crash, hang, stray exception
  std::string refusal;
  std::vector<std::string> warnings;
  glm::ivec3 dims{0};
  bool hasGoodVoxels = false;
  std::uint64_t decodedBytes = 0; ///< of the volume
  double seconds = 0.0;
  std::uint64_t peakBytes = 0;
};

/// Opens `path` with readVolume in a child.
Attempt attempt(const std::filesystem::path& path);

/// Whether a text is one sentence: a full stop at its end and none before a capital, no line end or other
/// control character, of a length that a person reads.
bool isOneSentence(const std::string& text);

/// How the attempts at all inputs of a format ended, and what of that must not be.
struct FormatReport {
  std::string format;
  struct Row {
    std::string flaw;
    Outcome outcome;
  };
  std::vector<Row> rows;
  std::vector<std::string> failures; ///< one line each
  double worstSeconds = 0.0;
  std::uint64_t worstExtraBytes = 0; ///< peak beyond that of the format's sound files
};

/// Tries all inputs of a format, its sound files first.
FormatReport triedFormat(const Format& format);

/// Opens `count` mutations of the sound files of a format, seeded by `seed`; those of one file in one child.
FormatReport triedMutations(const Format& format, int count, std::uint32_t seed);

} // namespace limn::test
