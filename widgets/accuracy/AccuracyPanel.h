// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"
#include "widgets/accuracy/PointUse.h"
#include "widgets/controls/FoldingSection.h"

#include <functional>

namespace limn {

class DialSection;
class MapSection;
class MeasuredSection;
struct WishAnswer;
class WishSection;

/// What works on a worker thread for the panel.
enum class AccuracyWork { none, findingSteps, measuring, comparing };

/// How close the picture is to the exact one and what that costs: a dial, wishes, the measured chart, and a
/// map of where it differs.
class AccuracyPanel : public SectionPanel {
  Q_OBJECT

public:
  explicit AccuracyPanel(QWidget* parent = nullptr);

  /// The scene of the picture on screen that is measured. Takes the map back where it is another one.
  void setScene(const Scene& scene);
  void setMovingMs(double ms);

  /// The quality with which that picture stands on screen once it rests, refined or not, and what is told of
  /// its error there ("estimated within 0.7 of 255 levels"), but for what was measured; absent before.
  void setOnScreen(const std::optional<Quality>& quality, const QString& told = {});

  /// What was measured, as last told; absent before.
  void setMeasured(const MeasuredAccuracy& measured);
  const std::optional<MeasuredAccuracy>& measured() const { return m_measured; }

  void setWork(AccuracyWork work);
  void showProgress(double fraction, const QString& doing);
  AccuracyWork work() const { return m_work; }

  /// Why a map cannot be shown, or an empty text.
  void setMapUnavailable(const QString& reason);
  void setCompared(const std::optional<ComparedPicture>& compared);
  /// Says why a comparison ended before there was a map.
  void sayComparisonEnded(const QString& sentence);

  QSize sizeHint() const override { return {320, 600}; }

protected:
  void resizeEvent(QResizeEvent* event) override;

signals:
  void qualityEdited(const limn::Quality& quality, const limn::Gesture& gesture);
  /// The user wants a tolerance, for which the steps are still to be found.
  void toleranceWished(const limn::Quality& quality, const limn::Gesture& gesture);
  void movingMsPicked(double ms);
  void measureRequested();
  void mapRequested(bool on);
  void cancelRequested();
  void saveRequested();

private:
  void connectSections();
  void useStep(const OperatingPoint& point);
  void use(const OperatingPoint& point);
  void ask(const Quality& quality, const QString& undoText);
  using Wish = std::function<WishAnswer(const AccuracyReport& report)>;
  void wish(const Wish& wanted);
  void offerWishes();
  void answer(const WishAnswer& answer);
  void showScene();
  void bringIntoView(QWidget* part);
  const MeasuredAccuracy* holding() const;
  double steepestPerMm() const;

  Scene m_scene;
  std::optional<Quality> m_onScreen;
  QString m_told; ///< of that picture's error
  std::optional<MeasuredAccuracy> m_measured;
  std::optional<OperatingPoint> m_answered; ///< what a wish chose, while its answer stands
  Wish m_wanted;                            ///< to be answered once it is measured
  AccuracyWork m_work = AccuracyWork::none;
  QString m_mapUnavailable;
  DialSection* m_dial;
  WishSection* m_wish;
  MeasuredSection* m_chart;
  MapSection* m_map;
};

} // namespace limn
