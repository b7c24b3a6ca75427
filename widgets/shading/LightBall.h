// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"

#include <QWidget>

#include <glm/glm.hpp>

namespace limn {

/// A ball that is lit as the picture is: one drags the lamp around it. Arrow keys move it, too; a double
/// click puts it back before the viewer.
class LightBall : public QWidget {
  Q_OBJECT

public:
  explicit LightBall(QWidget* parent = nullptr);

  /// Where the lamp stands, as seen from the viewer: unit vector to the right, upwards and towards the
  /// viewer.
  void setPlace(const glm::dvec3& place);
  const glm::dvec3& place() const { return m_place; }

  /// The share of light that reaches what faces away from the lamp, 0..1.
  void setAmbient(double share);

  /// Disables it and says why in its tool tip; an empty reason enables it.
  void setUnavailable(const QString& reason);

  QSize sizeHint() const override { return {96, 96}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

signals:
  void placeEdited(const glm::dvec3& place, const limn::Gesture& gesture);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QRectF ballRect() const;
  QImage ballImage(const QSize& pixels) const;
  void moveTo(const QPointF& position);
  void edit(const glm::dvec3& place, std::uint64_t gestureId);

  glm::dvec3 m_place{0.0, 0.0, 1.0};
  double m_ambient = 0.25;
  std::uint64_t m_gestureId = 0;
  std::uint64_t m_lastKeyMs = 0;
};

} // namespace limn
