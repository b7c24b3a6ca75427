// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace limn {

/// A word that is looked for in the guide: as it was written, and what else the guide may call it.
using GuideWord = QStringList;

/// The words of a question or a phrase as they are written, without what questions are made of ("why is my");
/// all of them where nothing else is left.
QStringList tellingWordsOf(const QString& text);

/// The same words as the guide may have them: lower case, those with a hyphen apart.
QList<GuideWord> guideWordsOf(const QString& text);

/// Where a text holds a name of a word.
struct HeldName {
  qsizetype at = -1; ///< -1: nowhere
  qsizetype length = 0;
};

/// The first name of a word that a text holds, whatever its case. One of up to four letters stands at the
/// beginning of a word.
HeldName heldName(const QString& text, const GuideWord& word);

/// Whether a piece of the guide tells of all these words: one or more in its text, the others there or in the
/// headings above it. It never tells of none.
bool tellsOf(const QString& piece, const QStringList& headings, const QList<GuideWord>& words);

} // namespace limn
