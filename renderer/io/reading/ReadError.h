// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Error.h"

#include <filesystem>
#include <string>

namespace limn {

/// A text that came out of a file, fit to stand in a sentence: control characters become question marks, and
/// it ends after `most` bytes.
std::string plainText(std::string text, std::size_t most = std::string::npos);

/// A message of which every part that came out of a file is such a text.
Message plainMessage(const Message& message, std::size_t most = std::string::npos);

/// Throws Error (input) with the one sentence of a file that cannot be read. `reason` continues "Cannot read
/// FILE: " and `wayOut` is an instruction without a full stop. What a damaged header put into the reason
/// becomes plain text of some length.
[[noreturn]] void failReading(const std::filesystem::path& file, const Message& reason,
                              const Message& wayOut);

/// Throws an error of the same kind whose sentence says which file was being read.
[[noreturn]] void failReading(const std::filesystem::path& file, const Error& cause);

/// Runs a step whose sentences speak of a series or volume, and adds the name of what was opened.
template <class Step>
auto naming(const std::filesystem::path& file, Step&& step) {
  try {
    return step();
  } catch (const Error& error) {
    failReading(file, error);
  }
}

/// The way out where a file ends early or its header lies.
inline const Message copyAgain = Message::tr("copy or export the file again");

} // namespace limn
