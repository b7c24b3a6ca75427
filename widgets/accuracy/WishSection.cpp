// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/WishSection.h"

#include "accuracy/sweep/FigureText.h"
#include "widgets/ValueText.h"
#include "widgets/accuracy/PointUse.h"
#include "widgets/controls/NumberField.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

// Those that the window can draw; a copy, because the choice below is made by renderer/accuracy.
std::vector<MeasuredPoint> pointsOfTheWindow(const AccuracyReport& report) {
  std::vector<MeasuredPoint> points;
  std::copy_if(report.points.begin(), report.points.end(), std::back_inserter(points),
               [](const MeasuredPoint& point) { return isOfTheWindow(point.point); });
  return points;
}

// Paths go on while nothing moves: there is nothing to choose, but it is told what to expect.
QString expectationOf(const PathsNeeded& needed) {
  return WishSection::tr(
             "By the law of chance: %1 paths a pixel, %2 s, within %3 levels. The picture goes on "
             "by itself while nothing moves.")
      .arg(std::llround(std::ceil(needed.paths)))
      .arg(plainNumber(1e-3 * needed.ms, 1), promisedLevels(needed.levels));
}

// `best` keeps the wish, `closest` is what to tell where nothing does.
WishAnswer answerOf(const AccuracyReport& report, const MeasuredPoint* best, const MeasuredPoint* closest,
                    const QString& missed) {
  if (best)
    return {indexOf(best->point, report.points),
            WishSection::tr("Chosen: %1").arg(pointSentence(*best, report.reference))};
  if (!closest)
    return {std::nullopt, WishSection::tr("Nothing is measured yet.")};
  return {std::nullopt, missed.arg(pointSentence(*closest, report.reference))};
}

} // namespace

WishAnswer wishForLevels(const AccuracyReport& report, double levels) {
  if (const auto needed = pathsWithinLevels(report.points, levels))
    return {std::nullopt, expectationOf(*needed)};
  if (!report.reference.converged)
    return {std::nullopt,
            WishSection::tr("The exact picture has not converged, so no error is known. A limit "
                            "of time can be kept.")};
  const std::vector<MeasuredPoint> points = pointsOfTheWindow(report);
  const auto closest = std::ranges::min_element(
      points, [](const MeasuredPoint& a, const MeasuredPoint& b) { return a.error.p99_9 < b.error.p99_9; });
  // What cannot be told from none is only known to be less than that.
  const MeasuredPoint* best =
      levels >= leastP99_9(report.reference) ? fastestWithin(points, levels) : nullptr;
  return answerOf(report, best, closest == points.end() ? nullptr : &*closest,
                  WishSection::tr("No measured picture is that close. Closest: %1"));
}

WishAnswer wishForMs(const AccuracyReport& report, double ms) {
  if (const auto needed = pathsWithinMs(report.points, ms))
    return {std::nullopt, expectationOf(*needed)};
  const std::vector<MeasuredPoint> points = pointsOfTheWindow(report);
  const auto fastest = std::ranges::min_element(
      points, [](const MeasuredPoint& a, const MeasuredPoint& b) { return a.ms.median < b.ms.median; });
  const MeasuredPoint* best = mostAccurateWithin(points, ms);
  return answerOf(report, best, fastest == points.end() ? nullptr : &*fastest,
                  WishSection::tr("No measured picture is that fast. Fastest: %1"));
}

WishSection::WishSection(QWidget* parent)
    : FoldingSection(tr("Choose by limit"), parent), m_levels(new NumberField(0.01, 100.0, 2)),
      m_ms(new NumberField(1.0, 100000.0, 0)), m_answer(new QLabel) {
  m_useLevels = addWish(tr("Error at most, levels"), m_levels,
                        tr("<p>Takes the fastest measured picture of which 999 in 1000 colour values are at "
                           "most so many levels of 255 off.</p><p>Range 0.01 – 100, default 1.</p>"));
  m_useMs = addWish(
      tr("Time at most, ms"), m_ms,
      tr("<p>Takes the most exact measured picture that is drawn in at most so many milliseconds, at the "
         "size at which it was measured.</p><p>Range 1 – 100000, default 33.</p>"));
  m_levels->setNumber(1.0);
  m_ms->setNumber(33.0);
  m_answer->setObjectName(QStringLiteral("answer"));
  m_answer->setWordWrap(true);
  contents()->addWidget(m_answer);
  connect(m_useLevels, &QPushButton::clicked, this, [this] { emit levelsWished(m_levels->number()); });
  connect(m_useMs, &QPushButton::clicked, this, [this] { emit msWished(m_ms->number()); });
  setMeasured(nullptr, false);
}

QPushButton* WishSection::addWish(const QString& name, NumberField* field, const QString& toolTip) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  auto* label = new QLabel(name);
  auto* button = new QPushButton(tr("Use"));
  label->setBuddy(field);
  label->setWordWrap(true); // rather than make the panel wider
  label->setToolTip(toolTip);
  field->setToolTip(toolTip);
  field->setAccessibleName(name);
  field->setFixedWidth(72);
  button->setToolTip(toolTip);
  button->setAccessibleName(tr("Use: %1").arg(name));
  row->addWidget(label, 1);
  row->addWidget(field);
  row->addWidget(button);
  contents()->addLayout(row);
  return button;
}

void WishSection::setMeasured(const MeasuredAccuracy* measured, bool canMeasure) {
  const bool isMeasured = measured && !measured->report.points.empty();
  const QString first = canMeasure ? tr("Measures this picture first: the choice is among what was measured.")
                                   : tr("Open a volume, or wait until the measuring is done.");
  for (const auto& [button, field] : {std::pair(m_useLevels, m_levels), {m_useMs, m_ms}}) {
    button->setEnabled(isMeasured || canMeasure);
    button->setToolTip(isMeasured ? field->toolTip() : first);
  }
  showAnswer({});
}

void WishSection::showAnswer(const QString& sentence) {
  m_answer->setText(sentence);
  m_answer->setVisible(!sentence.isEmpty());
}

} // namespace limn
