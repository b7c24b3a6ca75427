// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDrag.h"

#include <QWidget>

#include <array>

namespace limn {

class PlaneBar;
class PlaneView;

/// The picture and the slices beside it, as the settings lay them out: the picture alone, four equal places,
/// or one slice large with the picture and the other two in a column at its right. Without a volume there is
/// the picture alone.
class PlaneDeck : public QWidget {
  Q_OBJECT

public:
  /// Takes the picture, any widget, as its child.
  explicit PlaneDeck(QWidget& picture, QWidget* parent = nullptr);

  void setContent(const PlaneContent& content);

  PlaneView* view(PatientPlane plane) const { return m_views[static_cast<std::size_t>(plane)]; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

signals:
  void settingsEdited(const limn::PlaneSettings& settings);
  void distanceEdited(const std::optional<limn::MeasuredDistance>& before); ///< as PlaneView says it

protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void setTool(PlaneTool tool);
  PlaneLayout shownLayout() const;
  void arrange();

  QWidget& m_picture;
  PlaneBar* m_bar;
  std::array<PlaneView*, 3> m_views{};
  PlaneContent m_content;
};

/// Where picture and slices lie in a place of this size, logical pixels: the picture first, then the planes
/// in their order; empty where something is not shown.
std::array<QRect, 4> placesOf(const PlaneSettings& settings, const QRect& room);

} // namespace limn
