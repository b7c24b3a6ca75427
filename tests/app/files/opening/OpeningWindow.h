// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/WindowHarness.h"
#include "app/core/sources/SceneSource.h"
#include "support/FileBytes.h"

#include <filesystem>

namespace limn::test {

/// The window, small volumes to open in it, and what it asks and says of them.
class OpeningWindow : public WindowHarness {
protected:
  // A small volume in a folder of its own; returns its path.
  QString smallVolume(const char* inFolder, const char* voxels = "0 100 200 300 400 500 600 700") {
    const std::filesystem::path place = folder.path() / inFolder;
    std::filesystem::create_directories(place);
    writeBytes(place / "small.nrrd",
               "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\nspace "
               "directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: ascii\n\n" +
                   std::string(voxels) + "\n");
    return QString::fromStdString((place / "small.nrrd").string());
  }

  void saveSessionWith(const QString& labels, const QString& file) {
    ASSERT_TRUE(open(smallVolume("a")));
    typeName(labels);
    window->findChild<QAction*>(QStringLiteral("openLabels"))->trigger();
    ASSERT_TRUE(waitUntil([this] { return scene().keep.kind == Region::Kind::labels; }));
    saving().writeSession(file);
  }

  /// Clicks what the message offers.
  void choose(const char* answer) {
    for (QToolButton* button : messages().findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == QString::fromUtf8(answer))
        return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << "no button " << answer << " beside: " << messages().sentence().toStdString();
  }

  QString savedPicture() {
    EXPECT_TRUE(rest());
    const QString path = pathTo("elsewhere/picture.png");
    std::filesystem::create_directories(folder.path() / "elsewhere");
    saving().writePicture(path);
    return path;
  }

  /// The field for a name in a dialog for files, once it has the keyboard, as where people type: into one
  /// without it Qt writes what is selected. Null where the keyboard does not come.
  static QLineEdit* nameIn(QFileDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit")); // as Qt calls it
    const bool isReady = name && waitUntilExposed(dialog) && waitUntil([&dialog] {
                           if (!dialog.isActiveWindow())
                             dialog.activateWindow();
                           return dialog.isActiveWindow();
                         });
    if (!isReady)
      return nullptr;
    name->setFocus();
    return name;
  }

  QString folderOfNextDialog() {
    auto asked = std::make_shared<QString>();
    onceAsked<QFileDialog>([asked](QFileDialog& dialog) {
      *asked = dialog.directory().absolutePath();
      dialog.reject();
    });
    // Without a window manager nobody gives the keys back when the dialog before this one ends.
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
    QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
    return *asked;
  }
};

} // namespace limn::test
