// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/HelpBoxes.h"

#include <QMessageBox>

namespace limn {
namespace {

void showBox(QWidget* parent, const QString& title, const QString& text) {
  auto* box = new QMessageBox(QMessageBox::NoIcon, title, text, QMessageBox::Close, parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowModality(Qt::NonModal);
  box->show();
}

} // namespace

void showShortcuts(QWidget* parent) {
  const QString text = QObject::tr(
      "<h3>Picture</h3><table cellspacing=6>"
      "<tr><td>Left drag</td><td>rotate</td></tr><tr><td>Middle drag, Shift+left drag</td><td>pan</td></tr>"
      "<tr><td>Right drag, wheel, + −</td><td>zoom</td></tr><tr><td>Ctrl+left drag</td><td>roll</td></tr>"
      "<tr><td>Alt+left drag, W</td><td>window and level; with Ctrl: opacity; Esc cancels</td></tr>"
      "<tr><td>Shift+move, Shift+click</td><td>value under the pointer, pin it in the curve</td></tr>"
      "<tr><td>A P L S I, End PgDn Home (Shift: opposite)</td><td>standard views</td></tr>"
      "<tr><td>R</td><td>reset the camera</td></tr><tr><td>Space</td><td>swap the two sides while "
      "held</td></tr>"
      "<tr><td>B, drag a handle</td><td>crop box; double click a handle: that face uncut</td></tr>"
      "<tr><td>0, 1 … 9</td><td>full range, presets</td></tr><tr><td>F11, double click</td><td>picture and "
      "curve only</td></tr></table>"
      "<h3>Curve</h3><table cellspacing=6>"
      "<tr><td>Click the curve, double click</td><td>add a point</td></tr>"
      "<tr><td>Drag a point</td><td>move; Shift locks an axis, Alt is fine</td></tr>"
      "<tr><td>Middle click, Del</td><td>delete</td></tr><tr><td>Double click a point</td><td>colour and "
      "numbers</td></tr>"
      "<tr><td>Drag the handle</td><td>shift the curve; Alt: width</td></tr>"
      "<tr><td>Wheel, Shift+wheel</td><td>zoom, pan the value axis</td></tr>"
      "<tr><td>Tab, arrows, Enter</td><td>walk the points, move, type numbers</td></tr></table>");
  showBox(parent, QObject::tr("Mouse and keys"), text);
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
