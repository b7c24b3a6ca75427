// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

#include <QString>

#include <exception>

namespace limn {

/// A message in the language of the window, its numbers in the user's locale. Where the language lacks the
/// pattern, it stands in English.
QString translated(const Message& message);

/// A label of the window as it stands within a sentence: "Front–Back" becomes "front–back", acronyms stay,
/// and so does everything where the language writes its nouns with a capital.
QString inSentence(const QString& label);

/// What went wrong in that language, where it is an Error; otherwise what the library says that failed.
QString translated(const std::exception& failure);

} // namespace limn
