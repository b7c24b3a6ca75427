// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/accuracy/PointUse.h"
#include "widgets/controls/FoldingSection.h"

class QLabel;
class QPushButton;

namespace limn {

class NumberField;

/// What a wish got among measured points.
struct WishAnswer {
  std::optional<std::size_t> point; ///< the best that keeps it; absent where none does
  QString sentence;
};

/// The fastest point of the window with an error of at most `levels` (99.9th percentile), or the most
/// accurate one that takes at most `ms`; where none does, the sentence names what comes closest.
WishAnswer wishForLevels(const AccuracyReport& report, double levels);
WishAnswer wishForMs(const AccuracyReport& report, double ms);

/// Chooses the quality by a wish: at most so much error, or at most so much time.
class WishSection : public FoldingSection {
  Q_OBJECT

public:
  explicit WishSection(QWidget* parent = nullptr);

  /// What can be chosen from; null where nothing that holds was measured, which a wish then has done first
  /// where it can be.
  void setMeasured(const MeasuredAccuracy* measured, bool canMeasure);

  /// What the last wish got.
  void showAnswer(const QString& sentence);

signals:
  void levelsWished(double levels);
  void msWished(double ms);

private:
  QPushButton* addWish(const QString& name, NumberField* field, const QString& toolTip);

  NumberField* m_levels;
  NumberField* m_ms;
  QPushButton* m_useLevels;
  QPushButton* m_useMs;
  QLabel* m_answer;
};

} // namespace limn
