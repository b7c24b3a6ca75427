// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/RayProfile.h"
#include "widgets/plot/PlotTransform.h"
#include "widgets/ray/ProfileText.h"
#include "widgets/theme/Theme.h"

#include <QWidget>

#include <array>

class QLabel;
class QPainter;
class QPushButton;

namespace limn {

/// The lanes of a plot from top to bottom: value, opacity, contribution. Each has a line of text above it.
std::array<QRectF, 3> lanesOf(const QRectF& plot);

/// The chart of one ray: value, opacity and contribution over the depth. Pointer and keys read depths and
/// choose one: ← → (Shift: ten times as far), Home and End, H (half of the light), Enter or a click chooses;
/// the wheel, + and − zoom, F or a double click shows all of the ray.
class ProfileChart : public QWidget {
  Q_OBJECT

public:
  explicit ProfileChart(QWidget* parent = nullptr);

  /// Shows a ray, all of it where its length is another; none: the chart is empty. `crosshairMm` is the depth
  /// of the slices' crosshair, where it lies on the ray.
  void setProfile(const std::optional<RayProfile>& profile, const ProfileNames& names,
                  const std::optional<double>& crosshairMm);

  const std::optional<RayProfile>& profile() const { return m_profile; }

  /// The depth that is read, mm.
  std::optional<double> cursor() const { return m_cursor; }

  /// How depths lie in the chart; there is a profile.
  PlotTransform depths() const;

  QSize sizeHint() const override { return {280, 420}; }
  QSize minimumSizeHint() const override { return {232, 180}; }

signals:
  /// Another depth is read, or none.
  void cursorMoved();
  void depthChosen(double depthMm);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  bool obey(int key, bool isFast);
  void readAt(double depthMm);
  void zoom(double x, double factor);
  void showAll();
  ValueRange whole() const { return {0.0, m_profile->lengthMm}; }

  std::optional<RayProfile> m_profile;
  ProfileNames m_names;
  std::optional<double> m_crosshair;
  std::optional<double> m_cursor;
  ValueRange m_visible{0.0, 1.0}; ///< depths
  bool m_isZoomed = false;
};

/// What one ray of the picture meets: where half of its light comes from, in words, and a chart to read
/// depths of.
class RayPanel : public QWidget {
  Q_OBJECT

public:
  explicit RayPanel(QWidget* parent = nullptr);

  /// Shows a ray; none: a hint how one is chosen. `crosshairMm` as in ProfileChart.
  void setProfile(const std::optional<RayProfile>& profile, const ProfileNames& names,
                  const std::optional<double>& crosshairMm);

  ProfileChart* chart() const { return m_chart; }

signals:
  /// Somebody wants to see a place of the ray, world millimetres.
  void placeChosen(const glm::dvec3& worldMm);
  /// The panel came into view or left it.
  void shown(bool isShown);

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void showReading();

  ProfileNames m_names;
  QLabel* m_summary;
  QPushButton* m_goToHalf;
  ProfileChart* m_chart;
  QLabel* m_reading;
};

} // namespace limn
