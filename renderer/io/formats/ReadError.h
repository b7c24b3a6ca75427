// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/PlainText.h"
#include "scene/Error.h"

#include <filesystem>
#include <string>

namespace limn {

/// Throws the one sentence of a file that cannot be read. `reason` continues "Cannot read FILE: " and
/// `wayOut` is an instruction without a full stop. What a damaged header put into the reason
/// becomes plain text of some length.
[[noreturn]] inline void failReading(const std::filesystem::path& file, const std::string& reason,
                                     const std::string& wayOut) {
  constexpr std::size_t longestReason = 300;
  throw Error(Error::Kind::input, "Cannot read " + plainText(file.string()) + ": " +
                                      plainText(reason, longestReason) + "; " + wayOut + ".");
}

/// The way out where a file ends early or its header lies.
inline constexpr const char* copyAgain = "copy or export the file again";

} // namespace limn
