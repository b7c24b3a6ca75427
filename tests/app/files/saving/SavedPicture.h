// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/WindowHarness.h"
#include "app/core/drawing/PictureMaker.h"
#include "io/ImageFile.h"

#include <QImage>
#include <QPushButton>

namespace limn::test {

/// A picture of the view on its way into a file, as it is asked for.
class SavedPicture : public OpenGlWindow {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    setLayout(CompareLayout::single);
    ASSERT_TRUE(open(QStringLiteral("phantom:4")));
    ASSERT_TRUE(rest());
  }

  // The head is small in the middle: of what no ray meets, a large picture is drawn at once.
  void lookFromAfar() {
    session().setCamera(zoomed(scene().camera, 0.1));
    ASSERT_TRUE(rest());
  }

  QImage saved(const char* name, const PictureOptions& options) {
    saving().writePicture(pathTo(name), options);
    return written(name);
  }

  // The picture once it lies in its file and the window knows it, which it does a moment later.
  QImage written(const char* name) {
    EXPECT_TRUE(
        test::waitUntil([&] { return !stopButton().isVisible() && isWholePicture(folder.path() / name); }));
    return QImage(pathTo(name));
  }

  static void dismiss(const MessageBar& bar) {
    for (QToolButton* button : bar.findChildren<QToolButton*>())
      if (button->text() == QStringLiteral("Dismiss"))
        return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << "no button to dismiss it";
  }

  // The picture of a scene as the command line writes it.
  QImage drawn(const Scene& scene, const glm::ivec2& size) {
    canvas().doneCurrent(); // makes room for the command line's context
    const Image picture = makePictures({scene}, size, Engine::rayCaster, 1).front().image;
    writeImage(folder.path() / "drawn.png", picture, scene.image.background, {});
    return QImage(pathTo("drawn.png"));
  }

  QToolButton& stopButton() { return *window->findChild<QToolButton*>(QStringLiteral("stopWaiting")); }
};

} // namespace limn::test
