// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace limn {

/// A DICOM UID that no other object has: a random UUID below 2.25 (PS3.5, B.2). It tells neither the computer
/// nor the time at which it was made.
std::string newUid();

} // namespace limn
