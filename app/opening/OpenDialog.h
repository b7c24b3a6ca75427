// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace limn {

class Settings;

/// What a dialog asks for.
struct OpenQuestion {
  QString title;
  bool isFolder = false;
  QStringList filters = {}; ///< "Everything (*.nii *.nrrd)"; of files
  bool isMany = false;      ///< several files may be chosen
};

/// Asks for a file or folder to open, beginning where the last dialog ended, and remembers where this one
/// ends. Empty where nobody wants to open anything.
QString askWhatToOpen(QWidget* parent, const OpenQuestion& question, Settings& settings);

/// The same where the question may be answered by several.
QStringList askForPaths(QWidget* parent, const OpenQuestion& question, Settings& settings);

} // namespace limn
