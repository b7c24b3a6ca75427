// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDrag.h"

#include <QWidget>

#include <array>
#include <functional>
#include <vector>

class QAction;
class QComboBox;
class QToolButton;

namespace limn {

class NumberField;

/// The row above the slices: tools (those that measure share a button with a menu), grey window, slab, tint.
/// It shows settings and asks for others.
class PlaneBar : public QWidget {
  Q_OBJECT

public:
  explicit PlaneBar(QWidget* parent = nullptr);

  void setContent(const PlaneContent& content);
  void setTool(PlaneTool tool);

  /// A button for something that is done elsewhere.
  void addButton(QAction& action);

  /// How high it is at a width: groups of controls stand beside each other and, where that has no room, in
  /// rows below, each as wide as it needs.
  int heightAt(int width) const;

signals:
  void settingsEdited(const limn::PlaneSettings& settings);
  void measurementsEdited(const limn::MeasurementsEdited& edited);
  void toolRequested(limn::PlaneTool tool);

protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QWidget* makeToolGroup();
  QWidget* makeGreyGroup();
  QWidget* makeWindowsGroup();
  QWidget* makeSlabGroup();
  QWidget* makeLastGroup();
  QToolButton* makeMeasureButton();
  QToolButton* makeMoreButton();
  void fillWindowMenu();
  std::vector<QRect> placesAt(int width) const; ///< of the groups
  void arrange();
  void edit(const std::function<void(PlaneSettings&)>& change);
  void showIcons();

  PlaneContent m_content;
  std::array<QWidget*, 5> m_groups{};
  std::array<QToolButton*, 2> m_tools{}; ///< crosshair and window/level, the first of PlaneTool
  QToolButton* m_measure = nullptr;      ///< the tool that measured last, the others in its menu
  PlaneTool m_measureTool = PlaneTool::distance;
  QToolButton* m_windows = nullptr;
  NumberField* m_width = nullptr;
  NumberField* m_centre = nullptr;
  NumberField* m_thickness = nullptr;
  QComboBox* m_mode = nullptr;
  QToolButton* m_tint = nullptr;
};

} // namespace limn
