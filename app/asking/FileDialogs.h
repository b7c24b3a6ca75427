// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace limn {

class Settings;

/// Whether a file holds looks, of Limn or another program: by its ending and by what is in it. Never throws.
bool holdsLooks(const QString& path);

/// The filters of a dialog that asks for looks.
QStringList readLookFilters();

/// The filters of a dialog that asks where to write one, a kind each: first the kind with the ending `first`
/// (".itf"), if there is one, then Limn's own.
QStringList writtenLookFilters(const QString& first);

/// What a dialog asks for.
struct OpenQuestion {
  QString title;
  bool isFolder = false;
  QStringList filters = {}; ///< "Everything (*.nii *.nrrd)"; of files
  bool isMany = false;      ///< several files may be chosen
};

/// Asks for a file or folder to open, beginning where the last one lay that could be opened. Empty where
/// nobody wants to open anything.
QString askWhatToOpen(QWidget* parent, const OpenQuestion& question, const Settings& settings);

/// The same where the question may be answered by several.
QStringList askForPaths(QWidget* parent, const OpenQuestion& question, const Settings& settings);

/// The next such dialog begins where this lies: it could be opened, which a folder of what is refused is not
/// remembered for.
void rememberFolderOf(const QString& opened, Settings& settings);

/// What is asked when something is to be saved. Filters read "Chart (*.png)", the usual one first.
struct SaveQuestion {
  QString title;
  QString suggested; ///< a name, or a whole path
  QStringList filters;
  QString usualFolder = {}; ///< for a name, before any dialog has ended in another one
  bool isPicture = false;   ///< begins where the last picture was saved, at first among the user's pictures
};

/// The path with the first ending of `chosen`, unless one is typed: one that the filters offer, or where they
/// offer several, anything that looks like one (letters alone), which whoever writes may refuse.
QString withEnding(const QString& path, const QStringList& filters, const QString& chosen);

/// A path in the same folder at which nothing lies yet: "head.limn.json" → "head 2.limn.json", →
/// "head 3.limn.json".
QString freePathBeside(const QString& path);

/// Asks where to save, from the folder where the last dialog ended, until the file is new or may be replaced.
/// The path has its ending; empty where nobody wants to save.
QString askWhereToSave(QWidget* parent, const SaveQuestion& question, Settings& settings);

} // namespace limn
