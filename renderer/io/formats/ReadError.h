// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Error.h"

#include <filesystem>
#include <string>

namespace limn {

/// Throws the one sentence of a file that cannot be read. `reason` continues "Cannot read FILE: " and
/// `wayOut` is an instruction without a full stop. Control characters that a damaged header put into the
/// reason become question marks.
[[noreturn]] inline void failReading(const std::filesystem::path& file, std::string reason,
                                     const std::string& wayOut) {
  for (char& c : reason)
    c = (c >= 0 && c < ' ') || c == 0x7f ? '?' : c;
  throw Error(Error::Kind::input, "Cannot read " + file.string() + ": " + reason + "; " + wayOut + ".");
}

/// The way out where a file ends early or its header lies.
inline constexpr const char* copyAgain = "copy or export the file again";

} // namespace limn
