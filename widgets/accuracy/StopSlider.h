// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractSlider>
#include <QStringList>

#include <vector>

namespace limn {

/// A position of a StopSlider: its name below the track and, below that, a figure for each row.
struct SliderStop {
  QString name;
  QStringList figures; ///< as many as there are rows, or none where there is nothing to say
  bool isDim = false;  ///< its figures count for little here
  bool operator==(const SliderStop&) const = default;
};

/// A slider with a few positions, each labelled. A press brings the handle to the nearest one; arrow keys,
/// Home and End move it, and the wheel does where the slider is focused. The handle can stand between two
/// positions when what it shows is none of them.
class StopSlider : public QAbstractSlider {
  Q_OBJECT

public:
  explicit StopSlider(QWidget* parent = nullptr);

  /// At least two stops. `captions` says what the names are, then what each row of figures is.
  void setStops(const std::vector<SliderStop>& stops, const QStringList& captions);

  /// Where the handle stands: 0 the first stop, 1 the second.
  void setPlace(double place);
  double place() const { return m_place; }

  /// Where a stop or a place between two stands, in widget coordinates.
  QPointF centreAt(double place) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

signals:
  /// The user chose a stop.
  void stopPicked(int stop);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  double captionWidth() const;
  double textHeight() const;
  void pickAt(double x);
  void paintTexts(QPainter& painter) const;

  std::vector<SliderStop> m_stops;
  QStringList m_captions;
  double m_place = 0.0;
};

} // namespace limn
