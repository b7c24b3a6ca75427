// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace limn {

/// Whether a file holds looks, of Limn or another program: by its ending and by what is in it. Never throws.
bool holdsLooks(const QString& path);

/// The filters of a dialog that asks for looks.
QStringList readLookFilters();

/// The filters of a dialog that asks where to write one, a kind each: first the kind with the ending `first`
/// (".itf"), if there is one, then Limn's own.
QStringList writtenLookFilters(const QString& first);

} // namespace limn
