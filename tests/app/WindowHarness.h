// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/MainWindow.h"
#include "engine/DrawingEngine.h"
#include "support/TemporaryFolder.h"
#include "support/Waiting.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/panels/ViewPanels.h"
#include "widgets/view/pictures/PictureLoop.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QOpenGLWidget>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include <gtest/gtest.h>

#include <memory>

namespace limn::test {

/// The program's window on settings, presets and files of a folder of its own.
class WindowHarness : public testing::Test {
protected:
  /// `engine` draws: the processor, quicker than OpenGL without a card, unless a test is about a driver
  /// (`OpenGlWindow`) or about the choice, which depends on the machine.
  explicit WindowHarness(std::optional<Engine> engine = Engine::cpu) {
    QCoreApplication::setOrganizationName(QStringLiteral("limn"));
    QCoreApplication::setApplicationName(QStringLiteral("limn"));
    const UserFolders folders = UserFolders::below(folder.path());
    Settings(folders.settings).setEngine(engine);
    window = std::make_unique<MainWindow>(folders);
    window->resize(900, 640);
    // As somebody who asks for both models: in a window as small as this one there would be one.
    setLayout(CompareLayout::sideBySide);
    // Pictures rest at the scene's own step unless a test is about what comes after.
    window->view().setRefinesAtRest(false);
    window->show();
  }

  void SetUp() override {
    ASSERT_TRUE(test::waitUntilExposed(*window));
    // Shortcuts are those of the active window. Asked again, because a display without a window manager may
    // give the keyboard to nobody when the window before goes.
    ASSERT_TRUE(test::waitUntil([this] {
      if (!window->isActiveWindow())
        window->activateWindow();
      return window->isActiveWindow();
    }));
  }

  QString pathTo(const char* name) const { return QString::fromStdString((folder.path() / name).string()); }
  Session& session() const { return *window->findChild<Session*>(); }
  const Scene& scene() const { return session().scene(); }
  QUndoStack& undo() { return session().undoStack(); }
  CompareView& view() { return window->view(); }
  CurvePanel& curves() const { return *window->findChild<CurvePanel*>(); }
  SavingController& saving() const { return *window->findChild<SavingController*>(); }
  void setLayout(CompareLayout layout) { window->findChild<ComparisonController*>()->setLayout(layout); }
  /// The widget with the OpenGL context, while the driver draws.
  QOpenGLWidget& canvas() { return *view().findChild<QOpenGLWidget*>(); }
  /// What draws with the driver, while it does.
  PictureLoop& loop() { return *view().findChild<PictureLoop*>(); }
  int compiledPrograms() { return loop().pictures()->engine().compiledPrograms(); }

  /// Waits until nothing loads and every picture is complete.
  [[nodiscard]] bool rest() {
    return test::waitUntil([this] { return !window->loader().isLoading() && view().pictureState().resting; });
  }

  /// Waits until nothing is left for the driver to do at rest either.
  [[nodiscard]] bool idle() {
    return test::waitUntil([this] { return !window->loader().isLoading() && loop().isIdle(); });
  }

  [[nodiscard]] bool open(const QString& source) {
    window->openSource(source);
    return test::waitUntil([this] { return !window->loader().isLoading(); });
  }

  /// Opens it as a single picture.
  [[nodiscard]] bool openAlone(const QString& source) {
    if (!open(source))
      return false;
    setLayout(CompareLayout::single);
    return true;
  }

  /// Whether a label of the window says this.
  bool labelSays(const QString& text) const {
    for (const QLabel* label : window->findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(text))
        return true;
    return false;
  }

  /// Drags the first visible point of the curve that is neither transparent nor opaque 25 pixels down.
  void dragAPoint() {
    TransferFunctionCanvas& canvas = *curves().valueEditor()->canvas();
    const PlotTransform plot = canvas.transform();
    for (const ControlPoint& point : canvas.transferFunction().points) {
      if (point.opacity < 0.2 || point.value < plot.visible.lowest || point.value > plot.visible.highest)
        continue;
      const QPointF at(xOfValue(plot, point.value), yOfOpacity(plot, point.opacity));
      const QPoint from = canvas.mapTo(window.get(), at).toPoint();
      QWindow* handle = window->windowHandle();
      QTest::mousePress(handle, Qt::LeftButton, {}, from);
      for (int step = 1; step <= 5; ++step)
        QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, from + QPoint(0, 5 * step));
      QTest::mouseRelease(handle, Qt::LeftButton, {}, from + QPoint(0, 25));
      QCoreApplication::processEvents();
      return;
    }
    FAIL() << "no point to drag";
  }

  /// Once a dialog of this kind asks, answers it.
  template <class Dialog, class Answer>
  void onceAsked(Answer&& answer) {
    auto* look = new QTimer(window.get());
    QObject::connect(look, &QTimer::timeout, look, [look, answer] {
      auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      if (!dialog)
        return;
      look->stop();
      look->deleteLater();
      answer(*dialog);
    });
    look->start(10);
  }

  /// Answers the next dialog for a file.
  void typeName(const QString& path) {
    onceAsked<QFileDialog>([path](QFileDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      ASSERT_NE(name, nullptr);
      name->setText(path);
      QTest::keyClick(name, Qt::Key_Return);
    });
  }

  /// Clicks the button of the tool bar that carries this text.
  void clickTool(const QString& text) {
    QToolBar* bar = window->findChild<QToolBar*>();
    for (QAction* action : bar->actions())
      if (action->iconText() == text || action->text() == text)
        return QTest::mouseClick(bar->widgetForAction(action), Qt::LeftButton);
    FAIL() << "no button " << text.toStdString();
  }

  QAction* action(const QString& text) const {
    for (QAction* one : window->findChildren<QAction*>())
      if (one->text() == text)
        return one;
    return nullptr;
  }

  MessageBar& messages() const { return *window->findChild<MessageBar*>(QStringLiteral("messageBar")); }
  bool isLoadingShown() { return window->findChild<LoadingPanel*>()->isVisible(); }

  TemporaryFolder folder;
  std::unique_ptr<MainWindow> window;
};

/// The same, drawn with OpenGL.
class OpenGlWindow : public WindowHarness {
protected:
  OpenGlWindow() : WindowHarness(Engine::rayCaster) {}
};

} // namespace limn::test
