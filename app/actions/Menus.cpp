// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/Menus.h"

#include "app/actions/Actions.h"
#include "app/actions/MenuButton.h"
#include "app/actions/ModelMenus.h"

#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>

namespace limn {
namespace {

ChangingMenus makeFileMenu(QMenuBar& bar, const Actions& actions) {
  ChangingMenus menus;
  menus.file = bar.addMenu(QObject::tr("&File"));
  menus.file->addActions({actions.openFile, actions.openFolder, actions.openSample, actions.openLabels});
  menus.recentSources = menus.file->addMenu(QObject::tr("Open &recent"));
  menus.recentSources->setObjectName(QStringLiteral("recentSources"));
  menus.unsavedSessions = menus.file->addMenu(QObject::tr("Open &unsaved session"));
  menus.unsavedSessions->setObjectName(QStringLiteral("unsavedSessions"));
  menus.unsavedSessions->setToolTip(QObject::tr("Sessions that were left with unsaved changes."));
  menus.file->addSeparator();
  menus.file->addActions({actions.saveSession, actions.saveSessionAs, actions.saveScene, actions.savePicture,
                          actions.saveFigure, actions.saveTurntable, actions.exportSurface,
                          actions.saveDicom});
  menus.file->addSeparator();
  menus.file->addActions({actions.closeVolume, actions.quit});
  menus.file->setToolTipsVisible(true);
  return menus;
}

void makeEditMenu(QMenuBar& bar, const Actions& actions) {
  QMenu* menu = bar.addMenu(QObject::tr("&Edit"));
  menu->addActions({actions.undo, actions.redo});
  menu->addSeparator();
  menu->addAction(actions.copyPicture);
  menu->addSeparator();
  menu->addAction(actions.settings);
}

/// What the tool bar offers, too.
struct SharedMenus {
  QMenu* recent;
  QMenu* views;
  ModelMenus* models;
};

/// Fills in the menus of views and models.
void makeViewMenu(QMenuBar& bar, const Actions& actions, const QList<QAction*>& panels, SharedMenus& shared) {
  QMenu* menu = bar.addMenu(QObject::tr("&View"));
  menu->addActions(actions.layouts->actions());
  menu->addSeparator();
  menu->addMenu(QObject::tr("&Slices"))->addActions(actions.planeLayouts->actions());
  shared.models = new ModelMenus(actions.models, *menu);
  menu->addMenu(QObject::tr("Left dra&g"))->addActions(actions.tools->actions());
  QMenu* views = shared.views = menu->addMenu(QObject::tr("&Look from"));
  views->addActions(actions.views->actions());
  views->addSeparator();
  views->addAction(actions.resetCamera);
  views->addAction(actions.setOrientation);
  menu->addActions({actions.orthographic, actions.cropBox, actions.bodyOnly});
  menu->addSeparator();
  menu->addActions(panels);
  menu->addAction(actions.pictureAndCurveOnly);
  menu->addMenu(QObject::tr("&Keyboard focus"))->addActions({actions.nextPanel, actions.previousPanel});
}

void makeToolBar(QMainWindow& window, Actions& actions, const SharedMenus& shared) {
  QToolBar* bar = window.addToolBar(QObject::tr("Tools"));
  bar->setObjectName(QStringLiteral("toolBar"));
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  // Qt's own button for what has no room.
  if (auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button")))
    more->setAccessibleName(QObject::tr("More tools"));
  QToolButton* open = addMenuButton(*bar, shared.recent, QToolButton::MenuButtonPopup);
  open->setObjectName(QStringLiteral("openButton"));
  open->setDefaultAction(actions.openFile);
  bar->addWidget(open);
  bar->addSeparator();
  bar->addActions({actions.undo, actions.redo});
  bar->addSeparator();
  bar->addActions(actions.tools->actions());
  bar->addSeparator();
  bar->addActions(actions.layouts->actions());
  bar->addSeparator();
  bar->addActions(actions.planeLayouts->actions());
  bar->addSeparator();
  bar->addAction(actions.cropBox);
  QToolButton* look = addMenuButton(*bar, shared.views, QToolButton::InstantPopup);
  look->setText(QObject::tr("Look from"));
  actions.icons.give(*look, QStringLiteral("compass"));
  QObject::connect(actions.resetCamera, &QAction::enabledChanged, look,
                   &QWidget::setEnabled); // without a volume
  bar->addWidget(look);
  bar->addSeparator();
  shared.models->addTo(*bar); // last: they come, go and change their width with the layout, and move nothing
  auto* stretch = new QWidget(bar);
  stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(stretch);
  bar->addAction(actions.savePicture);
}

} // namespace

ChangingMenus makeMenus(QMainWindow& window, Actions& actions, const QList<QAction*>& panels) {
  QMenuBar& bar = *window.menuBar();
  ChangingMenus menus = makeFileMenu(bar, actions);
  makeEditMenu(bar, actions);
  SharedMenus shared{menus.recentSources, nullptr, nullptr};
  makeViewMenu(bar, actions, panels, shared);
  menus.models = shared.models;
  QMenu* presets = bar.addMenu(QObject::tr("&Preset"));
  presets->addActions({actions.findPreset, actions.savePreset, actions.earlierLook, actions.suggest});
  presets->addSeparator();
  presets->addActions({actions.importLooks, actions.exportLook});
  presets->addSeparator();
  presets->addActions({actions.takeSnapshot, actions.compareSnapshot, actions.compareModels});
  bar.addMenu(QObject::tr("&Help"))
      ->addActions({actions.guide, actions.tour, actions.shortcuts, actions.stability, actions.about});
  makeToolBar(window, actions, shared);
  return menus;
}

} // namespace limn
