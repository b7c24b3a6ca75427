// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

#include <string>
#include <vector>

namespace limn {

/// Adds a sentence that is not yet among them.
void tell(std::vector<Message>& changes, const Message& sentence);

/// Sentences as scripts read them: {"changes": [{"what": "…"}]}.
std::string changesJson(const std::vector<Message>& changes);

} // namespace limn
