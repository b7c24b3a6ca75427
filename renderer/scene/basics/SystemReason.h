// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

namespace limn {

/// Why the system refused something, by its number (errno), as the reason within a sentence: "Permission
/// denied". What is said in the user's language is what files and folders usually are refused for; the rest
/// is as the system has it.
Message systemReason(int error);

} // namespace limn
