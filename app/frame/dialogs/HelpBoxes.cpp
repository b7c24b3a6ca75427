// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/dialogs/HelpBoxes.h"

#include "app/window/ActionList.h"
#include "widgets/theme/Icons.h"

#include <QDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QList>
#include <QMessageBox>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>

namespace limn {

namespace {

// Keys that stand for one thing each, apart, as they are called here: "A · P".
QString keys(std::initializer_list<const char*> names) {
  QStringList apart;
  for (const char* name : names)
    apart << QKeySequence(QLatin1String(name), QKeySequence::PortableText).toString(QKeySequence::NativeText);
  return apart.join(QStringLiteral(" · "));
}

QList<HelpRow> pictureRows() {
  return {
      {{}, QObject::tr("Picture")},
      {QObject::tr("Left drag"), QObject::tr("rotate, or what the chosen tool does")},
      {keys({"[", "M", "Z", "W"}), QObject::tr("tools: rotate, pan, zoom, window and level")},
      {QObject::tr("Esc"), QObject::tr("cancel a drag; otherwise rotate again")},
      {QObject::tr("Middle drag, Shift+left drag"), QObject::tr("pan")},
      {QObject::tr("Right drag, wheel, + −"), QObject::tr("zoom")},
      {QObject::tr("Ctrl+left drag"), QObject::tr("roll")},
      {QObject::tr("Alt+left drag"), QObject::tr("window and level; with Ctrl: opacity")},
      {QObject::tr("Arrows"), QObject::tr("rotate")},
      {QObject::tr("Shift+move"), QObject::tr("value under the pointer; View ▸ Ray: along the ray below it")},
      {QObject::tr("Shift+click"),
       QObject::tr("keep that value: buttons make its tissue more or less opaque")},
      {keys({"A", "P", "L", "S", "I"}), QObject::tr("look from front, back, left, above, below")},
      {keys({"End", "PgDown", "Home"}), QObject::tr("look from front, left, above; Shift: the opposite")},
      {QObject::tr("R"), QObject::tr("reset the camera")},
      {QObject::tr("Space"), QObject::tr("swap the two sides while held")},
      {QObject::tr("B, drag a handle"), QObject::tr("crop box; double click a handle: that face uncut")},
      {QObject::tr("0, 1 … 9"), QObject::tr("full range, presets")},
      {QObject::tr("F11, double click"), QObject::tr("picture and curve only; F11 or Esc: all again")},
      {{}, QObject::tr("Window")},
      {QObject::tr("F6, Shift+F6"), QObject::tr("the keyboard goes to the next panel, the one before")},
      {QObject::tr("Ctrl+F"), QObject::tr("find a preset; Enter uses it and goes on to the picture")},
      {{}, QObject::tr("Presets")},
      {QObject::tr("Point at one, arrows"), QObject::tr("see it for a while; a click or Enter uses it")},
      {QObject::tr("F, F2, Del"), QObject::tr("favourite; rename, delete one of your own")},
      {QObject::tr("Ctrl+L"), QObject::tr("the look of the volume that was open before")},
      {QObject::tr("Ctrl+B, Ctrl+Shift+B"), QObject::tr("remember a look, compare it with now")},
  };
}

QList<HelpRow> sliceRows() {
  return {
      {{}, QObject::tr("Slices")},
      {QObject::tr("Left drag"), QObject::tr("crosshair, or what the chosen tool does")},
      {QObject::tr("Wheel, PgUp PgDn"), QObject::tr("through the slices; Shift+keys: ten at a time")},
      {QObject::tr("Right drag, Alt+left drag"), QObject::tr("window and level")},
      {QObject::tr("0, 1 2 3 4"), QObject::tr("full range; soft tissue, lung, bone, brain")},
      {QObject::tr("Middle drag, Shift+left drag"), QObject::tr("pan")},
      {QObject::tr("Ctrl+wheel, + −, F"), QObject::tr("zoom, show all of the slice")},
      {keys({"C", "W", "D"}), QObject::tr("tools: crosshair, window and level, distance")},
      {QObject::tr("Esc"), QObject::tr("the crosshair again")},
      {QObject::tr("Arrows, Home"), QObject::tr("move the crosshair; to the middle")},
      {QObject::tr("Del"), QObject::tr("remove the distance")},
      {QObject::tr("Double click"), QObject::tr("one slice large, and back")},
      {QObject::tr("Shift+click the picture"), QObject::tr("the crosshair goes to that place")},
  };
}

QList<HelpRow> curveRows() {
  return {
      {{}, QObject::tr("Curve")},
      {QObject::tr("Click the curve, double click"), QObject::tr("add a point")},
      {QObject::tr("Drag a point"), QObject::tr("move; Shift locks an axis, Alt moves finely")},
      {QObject::tr("Middle click, Del"), QObject::tr("delete")},
      {QObject::tr("Rest on a point, H"), QObject::tr("what it governs lights up in slices and picture")},
      {QObject::tr("Double click a point"), QObject::tr("colour and numbers")},
      {QObject::tr("Drag the handle"), QObject::tr("shift the curve; Alt: width")},
      {QObject::tr("Wheel, Shift+wheel"), QObject::tr("zoom, pan the value axis")},
      {QObject::tr("Tab, arrows, Enter"), QObject::tr("walk the points, move, type numbers")},
      {QObject::tr("N, Ins"), QObject::tr("add a point beside the one in hand")},
      {QObject::tr("Menu key"), QObject::tr("colour and numbers, delete, show all values")},
      {QObject::tr("Ctrl with + − 0 ← →"), QObject::tr("zoom the value axis, show all of it, pan")},
  };
}

// As the menus have them, so that both always say the same.
QList<HelpRow> menuRows(const ActionList& actions) {
  QList<HelpRow> rows{{{}, QObject::tr("Menus")}};
  for (const char* name :
       {"openFile", "openFolder", "saveSession", "savePicture", "saveFigure", "copyPicture", "undo", "redo",
        "findPreset", "settings", "guide", "closeVolume", "quit"}) {
    const QAction& action = actions.find(name);
    // Undo also says what it would undo.
    QString does = action.objectName() == QLatin1String("undo")   ? QObject::tr("Undo")
                   : action.objectName() == QLatin1String("redo") ? QObject::tr("Redo")
                                                                  : action.text();
    does.remove(QLatin1Char('&')).remove(QChar(0x2026));
    rows << HelpRow{action.shortcut().toString(QKeySequence::NativeText), does};
  }
  return rows;
}

} // namespace

HelpRows helpRows(const ActionList& actions) {
  return {pictureRows(), sliceRows(), curveRows(), menuRows(actions)};
}

namespace {

// One grid for all that stands below each other, so that its columns do, too.
void addRows(QGridLayout& grid, const QList<HelpRow>& rows) {
  for (const HelpRow& row : rows) {
    const int line = grid.rowCount();
    auto* effect = new QLabel(row.effect);
    if (row.gesture.isEmpty()) {
      QFont bold = effect->font();
      bold.setWeight(QFont::DemiBold);
      effect->setFont(bold);
      effect->setContentsMargins(0, line > 1 ? 12 : 0, 0, 2);
      grid.addWidget(effect, line, 0, 1, 2);
      continue;
    }
    effect->setForegroundRole(QPalette::PlaceholderText);
    grid.addWidget(new QLabel(row.gesture), line, 0);
    grid.addWidget(effect, line, 1);
  }
}

QGridLayout* columnOf(const QList<QList<HelpRow>>& groups) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(20);
  grid->setVerticalSpacing(3);
  grid->setColumnStretch(1, 1);
  for (const QList<HelpRow>& rows : groups)
    addRows(*grid, rows);
  grid->setRowStretch(grid->rowCount(), 1);
  return grid;
}

} // namespace

// Side by side, because one below the other they are higher than a small screen.
void showShortcuts(const ActionList& actions, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Mouse and keys"));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(40);
  const HelpRows rows = helpRows(actions);
  columns->addLayout(columnOf({rows.picture, rows.curve}), 1);
  columns->addLayout(columnOf({rows.slices, rows.menus}), 1);
  auto* close = new QPushButton(QObject::tr("Close"), dialog);
  QObject::connect(close, &QPushButton::clicked, dialog, &QDialog::close);
  auto* all = new QVBoxLayout(dialog);
  all->setContentsMargins(16, 12, 16, 12);
  all->setSpacing(12);
  all->addLayout(columns);
  all->addWidget(close, 0, Qt::AlignRight);
  dialog->show();
}

void showAbout(QWidget* parent) {
  const QString text =
      QObject::tr("<h3>Limn %1</h3><p>Shows CT and MR volumes in three dimensions: you shape which tissue is "
                  "seen, in which colour and how solid, and compare ways of lighting it side by "
                  "side.</p><p><b>Not for diagnosis.</b></p><p>Free software under the GNU General Public "
                  "License, version 3 or later.</p>")
          .arg(QStringLiteral(LIMN_VERSION));
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, QObject::tr("About Limn"), text, QMessageBox::Close, parent);
  box->setIconPixmap(programIcon().pixmap(QSize(64, 64), parent->devicePixelRatioF()));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowModality(Qt::NonModal);
  box->show();
}

} // namespace limn
