// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/RayProfile.h"
#include "widgets/ray/ProfileText.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace limn {

class ProfileChart;

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
