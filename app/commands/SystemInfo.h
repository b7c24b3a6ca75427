// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

/// Prints versions, renderer string and limits to stdout; no names of people, folders or files.
void printSystemInfo();

} // namespace limn
