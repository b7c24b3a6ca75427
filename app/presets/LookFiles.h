// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace limn {

/// Whether a file holds looks, of Limn or another program: by its ending and by what is in it. Never throws.
bool holdsLooks(const QString& path);

/// Filters of dialogs: of all files that are read, and of those that are written, the usual kind first.
QStringList readLookFilters();
QStringList writtenLookFilters();

} // namespace limn
