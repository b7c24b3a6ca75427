// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorMap.h"

#include <QImage>
#include <QWidget>

namespace limn {

/// Lies over a view and colours one picture of it by its errors, with a legend in levels. Takes no mouse.
class ErrorMapOverlay : public QWidget {
  Q_OBJECT

public:
  /// Hidden until there is a map.
  explicit ErrorMapOverlay(QWidget* view);

  /// `picture`: where the picture lies in the view, logical pixels.
  void showMap(const ErrorMap& map, const QRectF& picture);

  /// Where the legend stands, logical pixels.
  QRectF legendRect() const;

signals:
  /// The view got another size, so that the map no longer fits; it is hidden.
  void outgrown();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QImage m_image;
  QRectF m_picture;
};

} // namespace limn
