// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/DialSection.h"

#include "scene/effects/EffectPlan.h"
#include "widgets/ValueText.h"
#include "widgets/accuracy/PointUse.h"
#include "widgets/accuracy/StopSlider.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/WorkRow.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

constexpr std::array<double, 4> movingMs{16.0, 33.0, 40.0, 100.0};
constexpr int defaultMoving = 2;

QString stopName(const OperatingPoint& point) {
  if (point.toleranceLevels)
    return DialSection::tr("exact");
  const double parts = 1.0 / point.stepVoxels;
  return parts > 1.0 ? QStringLiteral("1/%1").arg(plainNumber(parts, 0)) : plainNumber(point.stepVoxels, 1);
}

// The stops halve the step, so logarithms lie evenly between them; beyond the smallest step lies the exact
// end, and between the two what is exact to more levels than that end.
double placeOf(const Quality& quality, const std::vector<OperatingPoint>& stops) {
  if (stops.empty())
    return 0.0;
  const double last = static_cast<double>(stops.size()) - 1.0;
  if (quality.toleranceLevels) {
    const double least = stops.back().toleranceLevels.value_or(*quality.toleranceLevels);
    return last - std::clamp(0.125 * std::log2(*quality.toleranceLevels / least), 0.0, 0.5);
  }
  const double place = std::log2(stops.front().stepVoxels / quality.stepVoxels);
  const bool hasExact = stops.back().toleranceLevels.has_value();
  return std::clamp(place, 0.0, hasExact ? last - 0.5 : last);
}

// How a picture was drawn: a tolerance is what its steps are meant for, and not what came of them.
QString drawnText(const OperatingPoint& point) {
  return point.toleranceLevels ? DialSection::tr("steps by error") : pointText(point);
}

// A picture that is closer to the exact one than it was asked to be; the status bar has the same number. What
// was measured is of one direction and of a smaller picture, so that what is told of this one goes first.
QString onScreenText(const OperatingPoint& onScreen, const OperatingPoint& asked,
                     const MeasuredAccuracy* measured, bool isSameView, const QString& told) {
  const std::optional<std::size_t> index =
      measured && isSameView && told.isEmpty() ? indexOf(onScreen, measured->report.points) : std::nullopt;
  if (index && onScreen == asked)
    return {};
  if (index)
    return DialSection::tr("Refined on screen to %1, within %2.")
        .arg(drawnText(onScreen),
             pointErrorText(measured->report.points[*index], measured->report.reference));
  const QString picture = onScreen == asked
                              ? DialSection::tr("The picture on screen")
                              : DialSection::tr("Refined on screen to %1").arg(drawnText(onScreen));
  return told.isEmpty() ? (onScreen == asked ? QString() : picture + QLatin1Char('.'))
                        : DialSection::tr("%1: %2.", "a picture: how far it is off").arg(picture, told);
}

// Whether another position is sooner there and closer to the exact picture.
bool isBeaten(const OperatingPoint& point, const std::vector<OperatingPoint>& stops,
              const AccuracyReport& report) {
  const std::optional<std::size_t> own = indexOf(point, report.points);
  if (!own || !report.reference.converged)
    return false;
  const double least = leastP99_9(report.reference);
  const MeasuredPoint& measured = report.points[*own];
  return std::ranges::any_of(stops, [&](const OperatingPoint& stop) {
    const std::optional<std::size_t> index = indexOf(stop, report.points);
    return index && report.points[*index].ms.median < measured.ms.median &&
           std::max(least, report.points[*index].error.p99_9) < std::max(least, measured.error.p99_9);
  });
}

// "2", "2 or 1", "2, 1 or 1/8".
QString listed(QStringList names) {
  if (names.size() < 2)
    return names.join(QString());
  const QString last = names.takeLast();
  return DialSection::tr("%1 or %2", "a list, and the last of it")
      .arg(names.join(QStringLiteral(", ")), last);
}

QLabel* endLabel(const QString& text) {
  auto* label = new QLabel(text);
  label->setForegroundRole(QPalette::PlaceholderText);
  return label;
}

} // namespace

DialSection::DialSection(QWidget* parent)
    : FoldingSection(tr("Faster or closer to exact"), parent), m_scale(new QWidget), m_dial(new StopSlider),
      m_sentence(new QLabel), m_note(new QLabel), m_work(new WorkRow(tr("Finding the steps"))) {
  auto* block = new QVBoxLayout(m_scale);
  block->setContentsMargins(0, 0, 0, 0);
  block->setSpacing(4);
  block->addWidget(new QLabel(tr("Picture at rest")));
  auto* ends = new QHBoxLayout;
  ends->addWidget(endLabel(tr("Faster")));
  ends->addStretch(1);
  ends->addWidget(endLabel(tr("Exact")));
  block->addLayout(ends);
  block->addWidget(m_dial);
  contents()->addWidget(m_scale);
  m_dial->setAccessibleName(tr("Faster or closer to exact"));
  m_dial->setToolTip(
      tr("<p>How far apart the samples along a ray lie while nothing moves: to the left the picture is there "
         "sooner, to the right it is closer to the exact one; at the end samples are spent where the picture "
         "needs them to be within half a level of 255.</p><p>From 2 voxels to exact, default 1/2. "
         "The figures are the error of 999 in 1000 colour values, in levels of 255, and the time of a "
         "picture, both measured here.</p>"));
  m_sentence->setObjectName(QStringLiteral("sentence"));
  m_sentence->setWordWrap(true);
  auto* text = new QVBoxLayout;
  text->setSpacing(4);
  text->addWidget(m_sentence);
  m_note->setObjectName(QStringLiteral("note"));
  m_note->setWordWrap(true);
  m_note->setForegroundRole(QPalette::PlaceholderText);
  text->addWidget(m_note);
  contents()->addLayout(text);
  contents()->addWidget(m_work);
  QStringList choices;
  for (const double ms : movingMs)
    choices << tr("at most %1 ms").arg(ms);
  m_moving = new ChoiceRow(tr("While moving"),
                           tr("How long a picture may take while you turn or drag: with less time it gets "
                              "coarser and follows the hand more closely."),
                           choices, defaultMoving);
  contents()->addWidget(m_moving);
  connect(m_moving, &ChoiceRow::indexEdited, this,
          [this](int index) { emit movingMsPicked(movingMs[static_cast<std::size_t>(index)]); });
  connect(m_dial, &StopSlider::stopPicked, this,
          [this](int stop) { emit pointPicked(m_points[static_cast<std::size_t>(stop)]); });
  show(Scene{}, nullptr, std::nullopt);
}

void DialSection::show(const Scene& scene, const MeasuredAccuracy* measured,
                       const std::optional<OperatingPoint>& onScreen, const QString& told) {
  const double steepest = measured ? measured->steepestPerMm : 0.0;
  m_points = dialPoints(scene, steepest);
  m_dial->setPlace(placeOf(scene.quality, m_points));
  m_dial->setEnabled(scene.volume != nullptr);
  m_scale->setVisible(!m_points.empty());
  QString sentence = sentenceFor(scene, measured);
  const bool isSameView = measured && measured->scene.camera == scene.camera;
  if (measured && !isSameView)
    sentence += QLatin1Char(' ') + tr("It was measured from another direction.");
  const std::optional<OperatingPoint> asked = pointOf(scene, steepest);
  if (const QString text =
          onScreen && asked ? onScreenText(*onScreen, *asked, measured, isSameView, told) : QString();
      !text.isEmpty())
    sentence += QLatin1Char(' ') + text;
  m_sentence->setText(sentence);
  m_dial->setAccessibleDescription(m_sentence->text());
  showStops(measured, isSameView);
  m_note->setText(noteFor(scene, measured));
}

// Each position is what would be drawn there: where that averages the curve between samples the chart has the
// same step without, under the same number.
QString DialSection::noteFor(const Scene& scene, const MeasuredAccuracy* measured) const {
  QStringList averaged, beaten, parts;
  qsizetype steps = 0;
  for (const OperatingPoint& point : m_points) {
    steps += point.toleranceLevels ? 0 : 1;
    if (point.preintegrated)
      averaged << stopName(point);
    if (measured && isBeaten(point, m_points, measured->report))
      beaten << stopName(point);
  }
  if (!averaged.isEmpty())
    parts
        << (averaged.size() == steps
                ? tr("Tissue that is thinner than a step is not missed (\"curve averaged\" in the chart).")
                : tr("Tissue that is thinner than a step is not missed with a step of %1 (\"curve averaged\" "
                     "in the chart).")
                      .arg(listed(averaged)));
  if (!beaten.isEmpty())
    parts << tr("Rather than %1 choose a position that is both faster and closer to the exact picture.")
                 .arg(listed(beaten));
  if (measured && steps > 0)
    parts << tr("Levels and times of the steps are those of the picture before it is refined.");
  const bool refines = !scene.quality.toleranceLevels && !m_points.empty();
  if (refines && hasTravellingLight(scene))
    parts << tr(
        "From there it refines while nothing moves, but shadows and occlusion come from few paths or "
        "a grid of light, which smaller steps do not make finer: where they show, the picture may stay "
        "\"not exact\". With \"exact\" the processor follows more paths, which takes some minutes.");
  else if (refines)
    parts << tr("From there it refines while nothing moves.");
  parts << tr("A level is the smallest step of brightness on a screen, of 255.");
  return parts.join(QLatin1Char(' '));
}

void DialSection::showStops(const MeasuredAccuracy* measured, bool isSameView) {
  std::vector<SliderStop> stops;
  for (const OperatingPoint& point : m_points) {
    SliderStop stop{stopName(point), {}, false};
    const std::optional<std::size_t> index =
        measured ? indexOf(point, measured->report.points) : std::nullopt;
    if (index) {
      const MeasuredPoint& found = measured->report.points[*index];
      const ReferenceFacts& reference = measured->report.reference;
      const bool isKnown = reference.converged;
      stop.figures = {isKnown ? promisedLevels(std::max(found.error.p99_9, leastP99_9(reference))) : tr("?"),
                      plainNumber(found.ms.median, found.ms.median < 10.0 ? 1 : 0)};
      stop.isDim = !isSameView || isBeaten(point, m_points, measured->report);
    }
    stops.push_back(stop);
  }
  m_dial->setStops(stops,
                   measured ? QStringList{tr("step"), tr("levels"), tr("ms")} : QStringList{tr("step")});
}

QString DialSection::sentenceFor(const Scene& scene, const MeasuredAccuracy* measured) const {
  if (!scene.volume)
    return tr("Open a volume to choose.");
  if (isPhysical(scene))
    return tr(
        "Physical light gets twice and twice as many paths while nothing moves. How many a saved picture "
        "has stands among the properties.");
  const std::optional<OperatingPoint> point = pointOf(scene, measured ? measured->steepestPerMm : 0.0);
  if (!point)
    return tr("With blurred steps (jitter) no error is measured.");
  const std::optional<std::size_t> index = measured ? indexOf(*point, measured->report.points) : std::nullopt;
  if (index)
    return pointSentence(measured->report.points[*index], measured->report.reference);
  OperatingPoint plain;
  plain.stepVoxels = point->stepVoxels;
  plain.toleranceLevels = point->toleranceLevels;
  const QString name =
      plain.toleranceLevels ? tr("Steps meant to be %1").arg(pointText(plain)) : pointText(plain);
  return tr("%1: not measured for this picture.").arg(name.left(1).toUpper() + name.mid(1));
}

void DialSection::setMovingMs(double ms) {
  const auto nearest = std::ranges::min_element(
      movingMs, [ms](double a, double b) { return std::abs(a - ms) < std::abs(b - ms); });
  m_moving->setIndex(static_cast<int>(nearest - movingMs.begin()));
}

} // namespace limn
