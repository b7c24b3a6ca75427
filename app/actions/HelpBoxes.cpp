// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/HelpBoxes.h"

#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QList>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {
namespace {

void showBox(QWidget* parent, const QString& title, const QString& text) {
  auto* box = new QMessageBox(QMessageBox::NoIcon, title, text, QMessageBox::Close, parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowModality(Qt::NonModal);
  box->show();
}

struct HelpRow {
  QString gesture; ///< empty: `effect` is a heading
  QString effect;
};

QList<HelpRow> pictureRows() {
  return {
      {{}, QObject::tr("Picture")},
      {QObject::tr("Left drag"), QObject::tr("rotate, or what the chosen tool does")},
      {QObject::tr("[ M Z W"), QObject::tr("tools: rotate, pan, zoom, window and level")},
      {QObject::tr("Esc"), QObject::tr("cancel a drag; otherwise rotate again")},
      {QObject::tr("Middle drag, Shift+left drag"), QObject::tr("pan")},
      {QObject::tr("Right drag, wheel, + −"), QObject::tr("zoom")},
      {QObject::tr("Ctrl+left drag"), QObject::tr("roll")},
      {QObject::tr("Alt+left drag"), QObject::tr("window and level; with Ctrl: opacity")},
      {QObject::tr("Arrows"), QObject::tr("rotate")},
      {QObject::tr("Shift+move, Shift+click"),
       QObject::tr("value under the pointer, pin it in the curve: less or more of it")},
      {QObject::tr("Shift+move, View ▸ Ray"), QObject::tr("value, opacity and light along the ray below it")},
      {QObject::tr("A P L S I, End PgDn Home"), QObject::tr("standard views; with Shift the opposite ones")},
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
      {QObject::tr("Ctrl+B, Ctrl+Shift+B"), QObject::tr("remember a look, compare it with now")},
  };
}

QList<HelpRow> otherRows() {
  return {
      {{}, QObject::tr("Slices")},
      {QObject::tr("Left drag"), QObject::tr("crosshair, or what the chosen tool does")},
      {QObject::tr("Wheel, PgUp PgDn"), QObject::tr("through the slices; Shift+keys: ten at a time")},
      {QObject::tr("Right drag, Alt+left drag"), QObject::tr("window and level")},
      {QObject::tr("0, 1 2 3 4"), QObject::tr("full range; soft tissue, lung, bone, brain")},
      {QObject::tr("Middle drag, Shift+left drag"), QObject::tr("pan")},
      {QObject::tr("Ctrl+wheel, + −, F"), QObject::tr("zoom, show all of the slice")},
      {QObject::tr("C W D, Esc"),
       QObject::tr("tools: crosshair, window and level, distance; the crosshair again")},
      {QObject::tr("Arrows, Home"), QObject::tr("move the crosshair; to the middle")},
      {QObject::tr("Del"), QObject::tr("remove the distance")},
      {QObject::tr("Double click"), QObject::tr("one slice large, and back")},
      {QObject::tr("Shift+click the picture"), QObject::tr("the crosshair goes to that place")},
      {{}, QObject::tr("Curve")},
      {QObject::tr("Click the curve, double click"), QObject::tr("add a point")},
      {QObject::tr("Drag a point"), QObject::tr("move; Shift locks an axis, Alt is fine")},
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

// One table, so that its columns stand under each other.
QString tableOf(const QList<HelpRow>& rows) {
  QString html = QStringLiteral("<table cellspacing=6>");
  for (const HelpRow& row : rows)
    html += row.gesture.isEmpty()
                ? QStringLiteral("<tr><td colspan=2><h3>%1</h3></td></tr>").arg(row.effect)
                : QStringLiteral("<tr><td>%1</td><td>%2</td></tr>").arg(row.gesture, row.effect);
  return html + QStringLiteral("</table>");
}

} // namespace

// Side by side, because one below the other they are higher than a small screen.
void showShortcuts(QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Mouse and keys"));
  auto* tables = new QHBoxLayout;
  tables->setSpacing(24);
  for (const QList<HelpRow>& rows : {pictureRows(), otherRows()})
    tables->addWidget(new QLabel(tableOf(rows), dialog), 1, Qt::AlignTop);
  auto* close = new QPushButton(QObject::tr("Close"), dialog);
  QObject::connect(close, &QPushButton::clicked, dialog, &QDialog::close);
  auto* column = new QVBoxLayout(dialog);
  column->addLayout(tables);
  column->addWidget(close, 0, Qt::AlignRight);
  dialog->show();
}

void showAbout(QWidget* parent) {
  const QString text = QObject::tr("<h3>Limn %1</h3><p>Transfer functions for CT and MR volumes, classic and "
                                   "gradient-enhanced Blinn-Phong side by "
                                   "side.</p><p><b>Not for diagnosis.</b></p><p>Free software under the GNU "
                                   "General Public License, version 3 or "
                                   "later.</p>")
                           .arg(QStringLiteral(LIMN_VERSION));
  showBox(parent, QObject::tr("About Limn"), text);
}

} // namespace limn
