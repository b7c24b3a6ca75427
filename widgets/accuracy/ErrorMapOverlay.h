// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ImageError.h"

#include <QColor>
#include <QImage>
#include <QWidget>

#include <array>

namespace limn {

/// The labelled errors of the scale, levels; the last stands for everything beyond.
inline constexpr std::array<double, 6> errorScaleTicks{0.0, 0.5, 1.0, 2.0, 5.0, 10.0};

/// The place of an error on the scale, 0..1: logarithmic from half a level on, linear below.
double errorScalePlace(double levels);

/// The colour at a place of the scale: from dark violet over red to light yellow, lightness rising evenly
/// (Ottosson, "A perceptual color space for image processing", 2020: Oklab), so that it is also read without
/// colour vision.
QColor errorScaleColor(double place);

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
