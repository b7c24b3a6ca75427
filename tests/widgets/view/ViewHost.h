// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "raycaster/RayCasterEngine.h"
#include "scene/volume/Phantom.h"
#include "support/Waiting.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/pictures/PictureLoop.h"

#include <QOpenGLWidget>
#include <QTest>
#include <QWindow>

#include <gtest/gtest.h>

#include <vector>

namespace limn::test {

/// A compare view in a window of its own that does what the main window does: it answers what the view asks
/// for with the scene that results. Records what was asked.
class ViewHost {
public:
  /// Pictures rest at the scene's own step unless a test is about what comes after.
  explicit ViewHost(const QSize& size = {400, 240}, MakeEngine processor = {},
                    Engine engine = Engine::rayCaster)
      : view({makeRayCasterEngine, std::move(processor), {}}, engine) {
    view.resize(size);
    view.setRefinesAtRest(false);
    const auto moveTo = [this](const Camera& camera) {
      ++cameraEdits;
      scene.camera = camera;
      view.setScene(scene);
    };
    QObject::connect(&view, &CompareView::cameraEdited, moveTo);
    QObject::connect(&view, &CompareView::cameraFitted, moveTo);
    QObject::connect(&view.input(), &ViewInput::functionEdited,
                     [this](const TransferFunction& function, const Gesture& gesture) {
                       gestures.push_back(gesture);
                       scene.transferFunction = function;
                       view.setScene(scene);
                     });
    QObject::connect(&view.input(), &ViewInput::probed,
                     [this](const std::optional<Probe>& p) { probes.push_back(p); });
    QObject::connect(&view, &CompareView::errorOccurred,
                     [this](const QString& text) { errors.push_back(text); });
  }

  /// Shows a coarse phantom with a skin, muscle and bone function.
  void showPhantom(double spacingMm = 6.0) {
    scene.volume = phantomVolume({spacingMm, 0.0, 1});
    scene.camera = defaultCamera(scene.volume->grid());
    scene.transferFunction.points = {{-300, {0.9, 0.6, 0.5}, 0.0},
                                     {-50, {0.9, 0.6, 0.5}, 0.03},
                                     {300, {1.0, 0.95, 0.85}, 0.5},
                                     {1500, {1.0, 1.0, 1.0}, 0.9}};
    view.setScene(scene);
  }

  /// Shows the window; a test cannot go on without.
  [[nodiscard]] bool show() {
    view.show();
    return test::waitUntilExposed(view);
  }

  /// Waits until every picture is complete.
  [[nodiscard]] bool rest() {
    return test::waitUntil([this] { return view.pictureState().resting; });
  }

  PictureLoop& loop() const { return *view.findChild<PictureLoop*>(); }
  bool isIdle() const { return loop().isIdle(); }
  int compiledPrograms() const { return loop().pictures()->engine().compiledPrograms(); }
  bool drawsOnProcessor() const { return view.pictureState().driverHasFailed; }

  /// The widget with the OpenGL context, while the driver draws.
  QOpenGLWidget& canvas() const { return *view.findChild<QOpenGLWidget*>(); }
  /// What is seen, without panels.
  QImage grabFramebuffer() const { return canvas().grabFramebuffer(); }

  void press(const QPoint& at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(view.windowHandle(), button, keys, at);
  }
  void move(const QPoint& to, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseEvent(QTest::MouseMove, view.windowHandle(), Qt::NoButton, keys, to);
    QCoreApplication::processEvents();
  }
  void release(const QPoint& at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseRelease(view.windowHandle(), button, keys, at);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers keys = {}) {
    press(from, button, keys);
    move((from + to) / 2, keys);
    move(to, keys);
    release(to, button, keys);
  }

  CompareView view;
  Scene scene;
  int cameraEdits = 0;
  std::vector<Gesture> gestures;
  std::vector<std::optional<Probe>> probes;
  std::vector<QString> errors;
};

} // namespace limn::test
