// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <istream>
#include <memory>
#include <string>

namespace limn {

/// The rest of a stream inflated (raw deflate, transfer syntax 1.2.840.10008.1.2.1.99), as a stream that can
/// be sought and knows its length. It inflates as it is read, so it takes no more memory however much is
/// packed; moving back starts anew. A stream that ends early gives what could be inflated. Throws Error
/// (input) naming `file` where the bytes are not deflated data or inflate to more than 1 GiB.
std::unique_ptr<std::istream> inflated(std::unique_ptr<std::istream> in, const std::string& file);

} // namespace limn
