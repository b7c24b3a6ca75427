// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"
#include "widgets/accuracy/PointUse.h"
#include "widgets/controls/FoldingSection.h"

class QLabel;

namespace limn {

class ChoiceRow;
class StopSlider;
class WorkRow;

/// Faster or closer to exact: a dial for the picture at rest, each position with its measured error and time,
/// and the time that a picture may take while something moves.
class DialSection : public FoldingSection {
  Q_OBJECT

public:
  explicit DialSection(QWidget* parent = nullptr);

  /// Shows where a scene stands, and at which point its picture on screen does, which may be refined, with
  /// what the status bar tells of that picture's error, but for what was measured; `measured` is null where
  /// nothing that holds for it was measured.
  void show(const Scene& scene, const MeasuredAccuracy* measured,
            const std::optional<OperatingPoint>& onScreen, const QString& told = {});

  /// The time that a picture may take while something moves; the nearest choice is shown.
  void setMovingMs(double ms);

  /// How far the search for steps is.
  WorkRow* work() const { return m_work; }

signals:
  /// The user chose a position of the dial.
  void pointPicked(const limn::OperatingPoint& point);
  void movingMsPicked(double ms);

private:
  void showStops(const MeasuredAccuracy* measured, bool isSameView);
  QString noteFor(const Scene& scene, const MeasuredAccuracy* measured) const;
  QString sentenceFor(const Scene& scene, const MeasuredAccuracy* measured) const;

  std::vector<OperatingPoint> m_points; ///< one per stop
  QWidget* m_scale;                     ///< the dial and its ends, hidden where there is nothing to choose
  StopSlider* m_dial;
  QLabel* m_sentence;
  QLabel* m_note; ///< how the dial's steps are taken, and what a level is
  WorkRow* m_work;
  ChoiceRow* m_moving = nullptr;
};

} // namespace limn
