// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/EllipseVoxels.h"
#include "planes/GreyWindows.h"
#include "scene/volume/Phantom.h"
#include "widgets/MeasureText.h"
#include "widgets/planes/PlaneContent.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

namespace limn::test {

/// Gives whoever shows slices what became of what it asked for, as the session does.
template <class Widget>
class PlaneHost {
public:
  template <class... Arguments>
  explicit PlaneHost(const PlaneContent& shown, Arguments&&... arguments)
      : content(shown), widget(std::forward<Arguments>(arguments)...) {
    QObject::connect(&widget, &Widget::settingsEdited, [this](const PlaneSettings& settings) {
      content.settings = settings;
      ++edits;
      widget.setContent(content);
    });
    QObject::connect(&widget, &Widget::measurementsEdited, [this](const MeasurementsEdited& edited) {
      content.measured = measuredIn(content.volume.get(), edited.measurements);
      content.inHand = edited.inHand;
      gestures.push_back(edited.gesture.id);
      widget.setContent(content);
    });
    widget.setContent(content);
  }

  std::vector<Measurement> measurements() const { return measurementsOf(content.measured); }
  PlaneSettings& settings() { return content.settings; }

  /// Other settings from elsewhere.
  void show(const PlaneSettings& settings) {
    content.settings = settings;
    widget.setContent(content);
  }

  PlaneContent content;
  Widget widget;
  int edits = 0;
  std::vector<std::uint64_t> gestures; ///< of what was measured
};

/// A volume on the axes of the patient whose value tells the place: x + 100 y + 10 000 z of the voxel.
inline std::shared_ptr<const Volume> countingVolume(const glm::ivec3& dims, const glm::dvec3& spacingMm) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = spacingMm;
  std::vector<float> stored;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        stored.push_back(static_cast<float>(i + 100 * j + 10000 * k));
  return std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
}

inline PlaneContent contentOf(const std::shared_ptr<const Volume>& volume) {
  PlaneContent content;
  content.volume = volume;
  content.firstWindow = fullWindow(volume->range());
  return content;
}

/// Turns the wheel over a widget, as the window system tells it; a notch is 120.
inline void turnWheel(QWidget& widget, const QPointF& at, int turn, Qt::KeyboardModifiers modifiers = {}) {
  QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, turn}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&widget, &event);
}

/// Drags with real mouse events in five steps.
inline void drag(QWidget& widget, const QPoint& from, const QPoint& to,
                 Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers modifiers = {},
                 bool releases = true) {
  QTest::mousePress(&widget, button, modifiers, from);
  for (int step = 1; step <= 5; ++step) {
    const QPointF at = QPointF(from) + (QPointF(to) - QPointF(from)) * step / 5.0;
    QMouseEvent move(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, button, modifiers);
    QApplication::sendEvent(&widget, &move);
  }
  if (releases)
    QTest::mouseRelease(&widget, button, modifiers, to);
}

} // namespace limn::test
