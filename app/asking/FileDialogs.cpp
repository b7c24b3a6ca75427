// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/asking/FileDialogs.h"

#include "app/document/Settings.h"
#include "io/looks/Look.h"
#include "io/scenefile/SceneFile.h"
#include "io/scenefile/SessionFile.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"

#include <QDir>
#include <QFileDialog>
#include <QFileIconProvider>
#include <QFileInfo>
#include <QHeaderView>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeDatabase>
#include <QObject>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QSplitter>
#include <QStandardPaths>
#include <QTemporaryFile>
#include <QTreeView>

#include <algorithm>

namespace limn {
namespace {

constexpr qint64 largestFile = 16 << 20; // bytes; readTextFile takes no more

QString patterns(const LookFormat& format) {
  QStringList endings;
  for (const std::string& ending : format.endings)
    endings << QStringLiteral("*%1").arg(QString::fromStdString(ending));
  return endings.join(QLatin1Char(' '));
}

// Icons and kinds by a file's name: Qt's own opens every file that a dialog lists to guess what it is, and
// one on a share that does not answer, or a device, would block the window.
class NamedKinds : public QFileIconProvider {
public:
  QIcon icon(const QFileInfo& file) const override {
    return QFileIconProvider::icon(file.isDir() ? Folder : File);
  }
  QString type(const QFileInfo& file) const override {
    return file.isDir() ? QObject::tr("Folder")
                        : QMimeDatabase().mimeTypeForFile(file, QMimeDatabase::MatchExtension).comment();
  }
};

// Whether a file can be made in a folder, tried: rights do not tell of every file system.
bool takesFiles(const QString& folder) {
  return QTemporaryFile(QDir(folder).filePath(QStringLiteral(".limn-XXXXXX"))).open();
}

// Gives a dialog for files room for whole dates and for the places at its left; nothing where the platform
// draws the dialog itself.
void giveRoom(QFileDialog& dialog) {
  static NamedKinds kinds;
  dialog.setIconProvider(&kinds);
  auto* files = dialog.findChild<QTreeView*>(QStringLiteral("treeView")); // as Qt calls it
  auto* splitter = dialog.findChild<QSplitter*>();
  if (!files || !splitter)
    return;
  files->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  files->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  dialog.resize(QSize(860, 520).boundedTo(dialog.screen()->availableSize()));
  splitter->setSizes({160, 680});
  const bool isSave = dialog.acceptMode() == QFileDialog::AcceptSave;
  dialog.setLabelText(QFileDialog::LookIn, isSave ? QObject::tr("Save in:") : QObject::tr("Look in:"));
  if (dialog.fileMode() != QFileDialog::Directory)
    return;
  // Folders have neither size nor kind.
  dialog.setLabelText(QFileDialog::FileName, QObject::tr("Folder:"));
  files->setColumnHidden(1, true);
  if (auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit")))
    name->setPlaceholderText(QObject::tr("the folder shown above; files are not listed"));
  for (const char* part : {"fileTypeLabel", "fileTypeCombo"})
    if (auto* shown = dialog.findChild<QWidget*>(QLatin1String(part)))
      shown->hide();
}

// Lets a typed path say alone what is chosen. While it is typed Qt selects each folder on its way, and one
// whose row in its own folder is that of the next it does not deselect (QItemSelectionModel::isRowSelected
// compares rows, not parents, after a toggle). Such a folder would be opened in place of what the field says.
// In a field without the keyboard Qt writes the name of what is selected instead.
void heedTypedPaths(QFileDialog& dialog) {
  const auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit")); // as Qt calls them
  auto* files = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
  if (!name || !files)
    return;
  QObject::connect(name, &QLineEdit::textChanged, files, [name, files](const QString& typed) {
    if (name->hasFocus() && typed.contains(QLatin1Char('/')))
      files->selectionModel()->clearSelection();
  });
}

} // namespace

bool holdsLooks(const QString& path) {
  const QFileInfo file(path);
  if (!hasLookEnding(file.fileName().toStdString()) || !file.isFile() || file.size() > largestFile)
    return false;
  try {
    const std::string text = readTextFile(path.toStdString());
    const LookFormat* format = lookFormatOf(text);
    return format && !format->isScene && !looksLikeSession(text) && !looksLikeScene(text);
  } catch (const Error&) {
    return false;
  }
}

QStringList readLookFilters() {
  QStringList all;
  for (const LookFormat& format : lookFormats())
    all << patterns(format);
  all.removeDuplicates();
  return {QObject::tr("Looks of Limn and other programs (%1)").arg(all.join(QLatin1Char(' '))),
          QObject::tr("All files (*)")};
}

QStringList writtenLookFilters(const QString& first) {
  QStringList filters;
  for (const LookFormat& format : lookFormats())
    if (format.write && !format.isScene) { // those are saved with a series
      const QString filter = QStringLiteral("%1 (%2)").arg(translated(format.name), patterns(format));
      const bool isFirst = std::ranges::find(format.endings, first.toStdString()) != format.endings.end();
      isFirst ? filters.prepend(filter) : filters.append(filter);
    }
  return filters;
}

QStringList askForPaths(QWidget* parent, const OpenQuestion& question, const Settings& settings) {
  QFileDialog dialog(parent, question.title, settings.dialogFolder());
  dialog.setFileMode(question.isFolder ? QFileDialog::Directory
                     : question.isMany ? QFileDialog::ExistingFiles
                                       : QFileDialog::ExistingFile);
  dialog.setOption(QFileDialog::HideNameFilterDetails); // a list of endings would be cut off
  dialog.setOption(QFileDialog::ShowDirsOnly, question.isFolder);
  if (!question.filters.isEmpty())
    dialog.setNameFilters(question.filters);
  giveRoom(dialog);
  heedTypedPaths(dialog);
  if (dialog.exec() != QDialog::Accepted)
    return {};
  return dialog.selectedFiles();
}

QString askWhatToOpen(QWidget* parent, const OpenQuestion& question, const Settings& settings) {
  return askForPaths(parent, question, settings).value(0);
}

void rememberFolderOf(const QString& opened, Settings& settings) {
  settings.setDialogFolder(QFileInfo(opened).absolutePath());
}

namespace {

// "Chart (*.png *.svg)" → "png", "svg".
QStringList endingsOf(const QString& filter) {
  static const QRegularExpression pattern(QStringLiteral("\\*\\.([\\w.]+)"));
  QStringList endings;
  for (auto matches = pattern.globalMatch(filter); matches.hasNext();)
    endings << matches.next().captured(1);
  return endings;
}

// The longest of these endings that a path has, without its dot: "head.limn.json" → "limn.json".
QString endingAmong(const QStringList& offered, const QString& path) {
  QString found;
  for (const QString& ending : offered)
    if (ending.size() > found.size() && path.endsWith(QLatin1Char('.') + ending, Qt::CaseInsensitive))
      found = ending;
  return found;
}

bool isTyped(const QString& path, const QStringList& offered) {
  const QString ending = QFileInfo(path).suffix();
  const bool isLetters =
      !ending.isEmpty() && std::ranges::all_of(ending, [](QChar character) { return character.isLetter(); });
  return !endingAmong(offered, path).isEmpty() || (offered.size() > 1 && isLetters);
}

// Another kind of file gets another ending.
void followFilter(QFileDialog& dialog, const QStringList& offered) {
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog, offered](const QString& filter) {
    const QFileInfo file(dialog.selectedFiles().value(0));
    const QString former = endingAmong(offered, file.filePath());
    if (!file.isDir() && !former.isEmpty())
      dialog.selectFile(file.filePath().chopped(former.size()) + endingsOf(filter).value(0));
  });
}

bool mayReplace(QWidget* parent, const QString& path) {
  QMessageBox box(QMessageBox::Warning, QObject::tr("Replace the file?"),
                  QObject::tr("%1 exists already. Replace it?").arg(QFileInfo(path).fileName()),
                  QMessageBox::Cancel, parent);
  box.setObjectName(QStringLiteral("replaceFile"));
  const QAbstractButton* replace = box.addButton(QObject::tr("Replace"), QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  return box.clickedButton() == replace;
}

} // namespace

QString withEnding(const QString& path, const QStringList& filters, const QString& chosen) {
  QStringList offered;
  for (const QString& filter : filters)
    offered << endingsOf(filter);
  if (path.isEmpty() || isTyped(path, offered))
    return path;
  return path + (path.endsWith(QLatin1Char('.')) ? QString() : QStringLiteral(".")) +
         endingsOf(chosen.isEmpty() ? filters.value(0) : chosen).value(0);
}

QString freePathBeside(const QString& path) {
  const QFileInfo file(path);
  QString ending = endingAmong({QStringLiteral("limn.json"), file.suffix()}, path);
  if (!ending.isEmpty())
    ending.prepend(QLatin1Char('.'));
  QString stem = file.fileName().chopped(ending.size());
  int number = 2;
  static const QRegularExpression numbered(QStringLiteral("^(.+) (\\d{1,2})$")); // not a year
  if (const QRegularExpressionMatch match = numbered.match(stem); match.hasMatch()) {
    stem = match.captured(1);
    number = match.captured(2).toInt() + 1;
  }
  for (;; ++number) {
    const QString name = stem + QLatin1Char(' ') + QString::number(number) + ending;
    if (const QString free = file.dir().filePath(name); !QFileInfo::exists(free))
      return free;
  }
}

namespace {

// Without a folder for pictures the home folder: an empty one would be that of the program.
QString placeOfPictures() {
  const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  return QFileInfo(pictures).isDir() ? pictures : QDir::homePath();
}

QString folderFor(const SaveQuestion& question, const Settings& settings) {
  const QString last = question.isPicture ? settings.pictureFolder() : settings.saveFolder();
  if (!last.isEmpty())
    return last;
  return question.isPicture ? placeOfPictures() : question.usualFolder;
}

} // namespace

QString askWhereToSave(QWidget* parent, const SaveQuestion& question, Settings& settings) {
  QString suggested = question.suggested;
  const QString folder = folderFor(question, settings);
  if (QFileInfo(suggested).isRelative() && !folder.isEmpty())
    suggested = QDir(folder).filePath(suggested);
  QString filter = question.filters.value(0);
  QStringList offered;
  for (const QString& one : question.filters)
    offered << endingsOf(one);
  for (;;) {
    QFileDialog dialog(parent, question.title, suggested);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setNameFilters(question.filters);
    dialog.selectNameFilter(filter);
    // It would ask for the name as typed, before the ending.
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    followFilter(dialog, offered);
    giveRoom(dialog);
    heedTypedPaths(dialog);
    if (dialog.exec() != QDialog::Accepted)
      return {};
    filter = dialog.selectedNameFilter();
    QString path = withEnding(dialog.selectedFiles().value(0), question.filters, filter);
    if (!QFileInfo::exists(path) || mayReplace(parent, path)) {
      // One that refuses is not where the next dialog should begin.
      if (const QString chosen = QFileInfo(path).absolutePath(); takesFiles(chosen))
        question.isPicture ? settings.setPictureFolder(chosen) : settings.setSaveFolder(chosen);
      return path;
    }
    suggested = path;
  }
}

} // namespace limn
