// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace limn {

/// Throws Error (input), one sentence that says what it is instead, where a text is sound JSON but no scene
/// or session: a preset or settings of Limn, or a file of another program. What is half a scene passes, and
/// so does what is no JSON: their own readers say what is wrong. `name` is how errors call it.
void refuseForeignJson(std::string_view text, const std::string& name);

} // namespace limn
