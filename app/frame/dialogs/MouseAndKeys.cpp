// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/dialogs/MouseAndKeys.h"

#include "app/window/ActionList.h"
#include "widgets/controls/DialogRoom.h"

#include <QAction>
#include <QDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>

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
      {keys({"X", "K", "D", "G", "E", "N"}),
       QObject::tr("tools, in slices, too: cut, piece, distance, angle, ellipse, mark")},
      {QObject::tr("Enter, Backspace"), QObject::tr("close a line of corners, take the last one back")},
      {QObject::tr("Esc"), QObject::tr("cancel a drag; otherwise rotate again")},
      {QObject::tr("Middle drag, Shift+left drag"), QObject::tr("pan")},
      {QObject::tr("Right drag, + −"), QObject::tr("zoom")},
      {QObject::tr("Wheel"), QObject::tr("zoom towards the pointer; range of a picked piece")},
      {QObject::tr("Ctrl+left drag"), QObject::tr("roll")},
      {QObject::tr("Alt+left drag"), QObject::tr("window and level; with Ctrl: opacity")},
      {QObject::tr("Arrows"), QObject::tr("rotate")},
      {QObject::tr("Shift+move"), QObject::tr("value under the pointer; View ▸ Ray: along the ray below it")},
      {QObject::tr("Shift+click"),
       QObject::tr("keep that value: buttons make its tissue more or less opaque")},
      {QObject::tr("Shift+middle click"), QObject::tr("turn about what is seen there, until R")},
      {QObject::tr("Right click, Menu key"), QObject::tr("what can be done with what is seen there")},
      {keys({"A", "P", "L", "S", "I"}) + QObject::tr(" · Alt+1 … 9"),
       QObject::tr("look from front, back, left, above, below; from kept views")},
      {keys({"End", "PgDown", "Home"}), QObject::tr("look from front, left, above; Shift: the opposite")},
      {QObject::tr("Click the cube"), QObject::tr("look from that side; once there: from the opposite one")},
      {QObject::tr("R"), QObject::tr("reset the camera")},
      {QObject::tr("Space"), QObject::tr("swap the two sides while held")},
      {QObject::tr("B, drag a handle"), QObject::tr("crop box; double click a handle: that face uncut")},
      {keys({"O", "Shift+O"}), QObject::tr("cut open to the crosshair: plane, corner; Esc: as it was")},
      {QObject::tr("0, 1 … 9"), QObject::tr("full range, presets")},
      {QObject::tr("F11, double click"), QObject::tr("the picture alone; F11 or Esc: all again")},
      {{}, QObject::tr("Window")},
      {QObject::tr("F6, Shift+F6"), QObject::tr("the keyboard goes to the next panel, the one before")},
      {QObject::tr("Ctrl+F"), QObject::tr("find a preset; Enter uses it and goes on to the picture")},
  };
}

// And presets, which have more room beside those than below the picture.
QList<HelpRow> sliceRows() {
  return {
      {{}, QObject::tr("Slices")},
      {QObject::tr("Left drag"), QObject::tr("crosshair, or what the chosen tool does")},
      {QObject::tr("Wheel, PgUp PgDn"), QObject::tr("through the slices; Shift+keys: ten at a time")},
      {QObject::tr("Right drag, Alt+left drag"), QObject::tr("window and level")},
      {QObject::tr("Right click, Menu key"),
       QObject::tr("what can be done there: take its label in hand, copy the value")},
      {QObject::tr("0, 1 2 3 4"), QObject::tr("full range; soft tissue, lung, bone, brain")},
      {QObject::tr("Middle drag, Shift+left drag"), QObject::tr("pan")},
      {QObject::tr("Ctrl+wheel, + −, F"), QObject::tr("zoom, show all of the slice")},
      {keys({"C", "W", "X", "K"}), QObject::tr("tools: crosshair, window and level, cut, piece")},
      {keys({"D", "G", "E", "N"}), QObject::tr("tools: distance, angle, ellipse, mark; Del: delete")},
      {QObject::tr("Esc"), QObject::tr("the crosshair again")},
      {QObject::tr("Arrows, Home"), QObject::tr("move the crosshair; to the middle")},
      {QObject::tr("Double click"), QObject::tr("one slice large, and back")},
      {QObject::tr("Shift+click the picture"), QObject::tr("the crosshair goes to that place")},
      {{}, QObject::tr("Presets")},
      {QObject::tr("Point at one, arrows"), QObject::tr("see it for a while; a click or Enter uses it")},
      {QObject::tr("F, F2, Del"), QObject::tr("favourite; rename, delete one of your own")},
      {QObject::tr("Ctrl+L"), QObject::tr("the look of the volume that was open before")},
      {QObject::tr("Ctrl+B, Ctrl+Shift+B"), QObject::tr("remember a look, compare it with now")},
  };
}

QList<HelpRow> curveRows() {
  return {
      {{}, QObject::tr("Curve")},
      {QObject::tr("Click the curve, double click"), QObject::tr("add a point")},
      {QObject::tr("Drag a point"), QObject::tr("move; Shift locks an axis, Alt moves finely")},
      {QObject::tr("Ctrl+click points, drag a frame"),
       QObject::tr("select several, to move or change together")},
      {QObject::tr("Middle click, Del"), QObject::tr("delete")},
      {QObject::tr("Rest on a point, H"), QObject::tr("what it governs lights up in slices and picture")},
      {QObject::tr("Double click a point"),
       QObject::tr("colour and numbers, of all that are selected with it")},
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
  for (const char* name : {"openFile", "openFolder", "saveSession", "saveSessionAs", "savePicture",
                           "saveFigure", "copyPicture", "undo", "redo", "cameraBack", "cameraForward",
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

constexpr int widestGesture = 210; // pixels that do not give way

// A line that becomes several where it finds no room.
class FoldingLine : public QLabel {
public:
  explicit FoldingLine(const QString& text) : QLabel(text) {
    setWordWrap(true);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
  }

  QSize sizeHint() const override {
    return fontMetrics().size(Qt::TextSingleLine, text()) + QSize(1, 0); // for parts of a pixel
  }
};

// One grid for all that stands below each other, so that its columns do, too.
void addRows(QGridLayout& grid, const QList<HelpRow>& rows) {
  for (const HelpRow& row : rows) {
    const int line = grid.rowCount();
    if (row.gesture.isEmpty()) {
      auto* heading = new QLabel(row.effect);
      QFont bold = heading->font();
      bold.setWeight(QFont::DemiBold);
      heading->setFont(bold);
      heading->setContentsMargins(0, line > 1 ? 12 : 0, 0, 2);
      grid.addWidget(heading, line, 0, 1, 2);
      continue;
    }
    auto* gesture = new FoldingLine(row.gesture);
    gesture->setMinimumWidth(std::min(gesture->sizeHint().width(), widestGesture));
    auto* effect = new FoldingLine(row.effect);
    effect->setForegroundRole(QPalette::PlaceholderText);
    grid.addWidget(gesture, line, 0);
    grid.addWidget(effect, line, 1);
  }
}

QGridLayout* columnOf(const QList<QList<HelpRow>>& groups) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(20);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  for (const QList<HelpRow>& rows : groups)
    addRows(*grid, rows);
  grid->setRowStretch(grid->rowCount(), 1);
  return grid;
}

} // namespace

// Side by side, because one below the other they are higher than a small screen; on one that is smaller yet
// lines fold, and all scrolls up and down.
void showShortcuts(const ActionList& actions, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Mouse and keys"));
  auto* lists = new QWidget;
  auto* columns = new QHBoxLayout(lists);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(40);
  const HelpRows rows = helpRows(actions);
  columns->addLayout(columnOf({rows.picture, rows.curve}), 1);
  columns->addLayout(columnOf({rows.slices, rows.menus}), 1);
  auto* close = new QPushButton(QObject::tr("Close"), dialog);
  QObject::connect(close, &QPushButton::clicked, dialog, &QDialog::close);
  auto* all = new QVBoxLayout(dialog);
  all->setContentsMargins(16, 12, 16, 12);
  all->setSpacing(12);
  auto* scroll = new WholeScroll(lists);
  scroll->setAccessibleName(dialog->windowTitle());
  all->addWidget(scroll);
  all->addWidget(close, 0, Qt::AlignRight);
  close->setFocus();
  dialog->resize(dialog->sizeHint()); // of what scrolls Qt shows two thirds of a screen at most
  dialog->show();
}

} // namespace limn
