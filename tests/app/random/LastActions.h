// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace limn::test {

/// Keeps what was done last, and prints it to stderr where the process dies, or where it does nothing for two
/// minutes and so ends itself.
void watchForDeath(unsigned seed);

/// Notes an action, before it is done.
void noteAction(const QString& action);

/// The last actions, one a line, the latest at the end.
std::string lastActions();

} // namespace limn::test
