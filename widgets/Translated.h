// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace limn {

/// What tr() is to a class, for functions that belong to none: mark texts with QT_TRANSLATE_NOOP("limn", …).
inline QString translated(const char* text) {
  return QCoreApplication::translate("limn", text);
}

} // namespace limn
