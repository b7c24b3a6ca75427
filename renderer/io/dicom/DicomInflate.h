// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <istream>
#include <memory>
#include <string>

namespace limn {

/// Inflates the rest of a stream (raw deflate, transfer syntax 1.2.840.10008.1.2.1.99) into memory, at most
/// 2 GiB. A stream that ends early gives what could be inflated. Throws Error (input) naming `file` where the
/// bytes are not deflated data or too many.
std::unique_ptr<std::istream> inflated(std::istream& in, const std::string& file);

} // namespace limn
