// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/accuracy/PointUse.h"
#include "widgets/controls/FoldingSection.h"

class QLabel;
class QPushButton;

namespace limn {

class AccuracyChart;
class ChartWindow;
class ChoiceRow;
class WorkRow;

/// How a measured report relates to what is on screen.
enum class MeasuredFor { thisPicture, otherCamera, earlierPicture };

/// Measures error and time of the picture on screen, and shows them as a chart.
class MeasuredSection : public FoldingSection {
  Q_OBJECT

public:
  explicit MeasuredSection(QWidget* parent = nullptr);

  /// Null where nothing was measured.
  void setMeasured(const MeasuredAccuracy* measured);
  void setRelation(MeasuredFor relation);
  void setCurrent(std::optional<std::size_t> point);

  /// Whether there is a picture to measure, and nothing else that is at work.
  void setCanMeasure(bool can);

  QWidget* chart() const;

  /// Makes the chart so high, within what can be read, that the whole section is seen in `height` pixels.
  void fitInto(int height);

  /// How far it is.
  WorkRow* work() const { return m_work; }

signals:
  void measureRequested();
  void saveRequested();
  void pointPicked(std::size_t point);

private:
  void addButtons();
  void setApart(bool isApart); ///< the chart, into a window of its own or back
  void addMeasureChoice();
  void connectApart();
  void showSummary();

  AccuracyReport m_report;
  glm::ivec2 m_timedSize{0};
  MeasuredFor m_relation = MeasuredFor::thisPicture;
  QPushButton* m_measure;
  QPushButton* m_save;
  QPushButton* m_apart;
  WorkRow* m_work;
  QLabel* m_summary;
  AccuracyChart* m_chart;
  ChartWindow* m_window;
  ChoiceRow* m_choice = nullptr;
};

} // namespace limn
