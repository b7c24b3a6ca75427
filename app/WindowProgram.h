// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/CommandLine.h"

namespace limn {

/// The program's own windows.
Windows programWindows();

} // namespace limn
