// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetMenu.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>

namespace limn {
namespace {

void addFolders(QMenu& menu, const PresetInHand& preset, const PresetDeeds& deeds) {
  QMenu* folders = menu.addMenu(QObject::tr("Move to folder"));
  const auto add = [&](const QString& text, const std::string& folder) {
    QAction* action = folders->addAction(
        text, folders, [move = deeds.moveTo, folder] { move(QString::fromStdString(folder)); });
    action->setCheckable(true);
    action->setChecked(folder == preset.folder);
  };
  add(QObject::tr("My presets"), {});
  for (const std::string& folder : preset.allFolders)
    add(QString::fromStdString(folder), folder);
  folders->addSeparator();
  folders->addAction(QObject::tr("New folder…"), folders, deeds.moveToNewFolder);
}

} // namespace

QMenu* makePresetMenu(const PresetInHand& preset, const PresetDeeds& deeds, QWidget* parent) {
  auto* menu = new QMenu(parent);
  menu->addAction(preset.isModified ? QObject::tr("Reset to this preset") : QObject::tr("Use"), menu,
                  deeds.use);
  menu->addAction(QObject::tr("Compare with the picture"), menu, deeds.compare);
  menu->addAction(preset.isFavourite ? QObject::tr("Remove from favourites")
                                     : QObject::tr("Add to favourites"),
                  menu, deeds.toggleFavourite);
  menu->addSeparator();
  menu->addAction(QObject::tr("Duplicate…"), menu, deeds.duplicate);
  menu->addAction(QObject::tr("Export…"), menu, deeds.exportIt);
  if (preset.isOwn) {
    menu->addAction(QObject::tr("Rename…"), menu, deeds.rename);
    menu->addAction(QObject::tr("Note…"), menu, deeds.editNote);
    addFolders(*menu, preset, deeds);
    menu->addAction(QObject::tr("Delete"), menu, deeds.remove);
  }
  menu->addSeparator();
  menu->addAction(QObject::tr("Copy name"), menu,
                  [name = preset.name] { QApplication::clipboard()->setText(name); });
  return menu;
}

} // namespace limn
