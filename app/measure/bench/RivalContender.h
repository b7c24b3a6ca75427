// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/measure/bench/Contender.h"

#include <string>
#include <vector>

namespace limn {

/// How to start a program that draws with another library.
struct RivalCommand {
  std::filesystem::path program;
  std::vector<std::string> arguments; ///< the mapper and how to read the volume
};

/// A renderer of another library in a process of its own, which lives as long as this object, so that its
/// pictures alternate with ours. It is told on stdin `first N` or `draw N` and N bytes of scene JSON (whose
/// volume is `volumePath`), `peak`, or `save PATH`, and answers each with a line: `ok` and its numbers (ms
/// and ms of processor, or MB), or `error` and a sentence. Its first line is `ok` and its renderer string.
/// Throws Error where it cannot be started or draws nothing.
std::unique_ptr<Contender> rivalContender(const std::string& name, const RivalCommand& command,
                                          const std::string& volumePath);

} // namespace limn
