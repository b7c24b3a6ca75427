// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace limn {

/// A text that came out of a file, fit to stand in a sentence: control characters become question marks, and
/// it ends after `most` bytes.
std::string plainText(std::string text, std::size_t most = std::string::npos);

} // namespace limn
