// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/WindowHarness.h"
#include "app/files/exports/ExportDialog.h"
#include "app/files/saving/PictureDialog.h"
#include "widgets/controls/NumberField.h"

#include <QComboBox>
#include <QLabel>

#include <set>
#include <utility>

namespace limn::test {

/// Expects that Alt and a letter does one thing in a dialog, as it stands.
inline void expectOneKeyEach(const QDialog& dialog) {
  QStringList texts;
  for (const auto* button : dialog.findChildren<QAbstractButton*>())
    if (!button->isHidden())
      texts << button->text();
  for (const auto* label : dialog.findChildren<QLabel*>())
    if (label->buddy() && !label->buddy()->isHidden())
      texts << label->text();
  std::set<QKeySequence> keys;
  for (const QString& text : texts) {
    const QKeySequence key = QKeySequence::mnemonic(text);
    EXPECT_TRUE(key.isEmpty() || keys.insert(key).second)
        << dialog.windowTitle().toStdString() << ": " << text.toStdString();
  }
  EXPECT_TRUE(keys.contains(QKeySequence(Qt::ALT | Qt::Key_S))) << "one saves";
}

/// The same of what asks how a picture is saved, in each of its sizes that have a field of their own.
inline void expectOneKeyEachOfSizes(PictureDialog& dialog) {
  for (const PictureOptions::Size size : {PictureOptions::Size::print, PictureOptions::Size::pixels}) {
    dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"))->setCurrentIndex(static_cast<int>(size));
    expectOneKeyEach(dialog);
  }
}

/// Asks for a picture of so many pixels, by hand: opens the lock of the shape and types both.
inline void askForPixels(PictureDialog& dialog, const char* width, const char* height) {
  auto* size = dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"));
  size->setCurrentIndex(static_cast<int>(PictureOptions::Size::pixels));
  auto* lock = dialog.findChild<QToolButton*>(QStringLiteral("pictureShape"));
  if (lock->isChecked())
    QTest::mouseClick(lock, Qt::LeftButton);
  for (const auto& [name, text] : {std::pair("pictureWidthPixels", width), {"pictureHeightPixels", height}}) {
    auto* field = dialog.findChild<NumberField*>(QLatin1String(name));
    field->selectAll();
    QTest::keyClicks(field, QLatin1String(text));
    field->commit();
  }
}

/// The same of the dialogs for figures and turntables, which are opened for it.
inline void expectOneKeyEachOfExports(QMainWindow& window) {
  for (const char* name : {"saveFigure", "saveTurntable"})
    window.findChild<QAction*>(QLatin1String(name))->trigger();
  for (const ExportDialog* dialog : window.findChildren<ExportDialog*>())
    expectOneKeyEach(*dialog);
}

} // namespace limn::test
