// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/AccuracyPanel.h"

#include "widgets/accuracy/DialSection.h"
#include "widgets/accuracy/MapSection.h"
#include "widgets/accuracy/MeasuredSection.h"
#include "widgets/accuracy/PointUse.h"
#include "widgets/accuracy/WishSection.h"
#include "widgets/controls/WorkRow.h"

#include <QCoreApplication>
#include <QEvent>
#include <QScrollBar>
#include <QTimer>

#include <utility>

namespace limn {

AccuracyPanel::AccuracyPanel(QWidget* parent)
    : SectionPanel(parent), m_dial(new DialSection), m_wish(new WishSection), m_chart(new MeasuredSection),
      m_map(new MapSection) {
  stack({m_dial, m_wish, m_chart, m_map});
  connectSections();
  setAccessibleName(tr("Accuracy"));
  showScene();
  offerWishes();
}

void AccuracyPanel::connectSections() {
  connect(m_dial, &DialSection::pointPicked, this, &AccuracyPanel::useStep);
  connect(m_dial, &DialSection::movingMsPicked, this, &AccuracyPanel::movingMsPicked);
  connect(m_wish, &WishSection::levelsWished, this, [this](double levels) {
    wish([levels](const AccuracyReport& report) { return wishForLevels(report, levels); });
  });
  connect(m_wish, &WishSection::msWished, this,
          [this](double ms) { wish([ms](const AccuracyReport& report) { return wishForMs(report, ms); }); });
  connect(m_chart, &MeasuredSection::measureRequested, this, &AccuracyPanel::measureRequested);
  connect(m_chart, &MeasuredSection::saveRequested, this, &AccuracyPanel::saveRequested);
  connect(m_chart, &MeasuredSection::pointPicked, this,
          [this](std::size_t point) { use(m_measured->report.points[point].point); });
  connect(m_map, &MapSection::mapRequested, this, &AccuracyPanel::mapRequested);
  for (const WorkRow* work : {m_dial->work(), m_chart->work(), m_map->work()})
    connect(work, &WorkRow::cancelled, this, &AccuracyPanel::cancelRequested);
  connect(m_chart->work(), &WorkRow::cancelled, this, [this] {
    m_wanted = nullptr;
    offerWishes();
  });
}

// What nobody has measured is measured first.
void AccuracyPanel::wish(const Wish& wanted) {
  if (const MeasuredAccuracy* holds = holding(); holds && !holds->report.points.empty())
    return answer(wanted(holds->report));
  emit measureRequested();
  m_wanted = wanted;
  m_wish->showAnswer(tr("Measuring first; the best picture that keeps this is then used."));
}

void AccuracyPanel::offerWishes() {
  m_wish->setMeasured(holding(), m_scene.volume && m_work == AccuracyWork::none);
}

void AccuracyPanel::setScene(const Scene& scene) {
  const bool isOther = scene != m_scene;
  m_scene = scene;
  // Numbers of another volume are no reason to keep that in memory.
  if (m_measured && m_measured->scene.volume != scene.volume)
    m_measured->scene.volume.reset();
  showScene();
  if (isOther) {
    setCompared(std::nullopt);
    // An answer stands until something else than it is in use.
    if (!m_answered || !holding() || pointOf(scene, steepestPerMm()) != m_answered) {
      m_answered.reset();
      m_wanted = nullptr;
      offerWishes();
    }
  }
}

void AccuracyPanel::setMovingMs(double ms) {
  m_dial->setMovingMs(ms);
}

void AccuracyPanel::setOnScreen(const std::optional<Quality>& quality, const QString& told) {
  const bool isOther = quality != m_onScreen || told != m_told;
  m_onScreen = quality;
  m_told = told;
  if (isOther)
    showScene();
}

void AccuracyPanel::setMeasured(const MeasuredAccuracy& measured) {
  m_measured = measured;
  m_chart->setMeasured(&*m_measured);
  offerWishes();
  showScene();
  m_chart->fitInto(viewport()->height());
  bringIntoView(m_chart->chart());
  if (const Wish wanted = std::exchange(m_wanted, nullptr); wanted && holding())
    answer(wanted(m_measured->report));
}

void AccuracyPanel::setWork(AccuracyWork work) {
  if (work == AccuracyWork::comparing || m_work == AccuracyWork::comparing)
    m_map->setComparing(work == AccuracyWork::comparing);
  m_work = work;
  if (work != AccuracyWork::measuring && work != AccuracyWork::none)
    m_wanted = nullptr; // something else takes its place
  if (!m_answered && !m_wanted)
    offerWishes();
  showProgress(0.0, tr("Preparing…"));
  showScene();
  if (work == AccuracyWork::measuring)
    bringIntoView(m_chart);
  if (work == AccuracyWork::comparing)
    bringIntoView(m_map);
}

void AccuracyPanel::showProgress(double fraction, const QString& doing) {
  const auto progressOf = [&](AccuracyWork kind) {
    return m_work == kind ? std::optional(fraction) : std::nullopt;
  };
  m_dial->work()->showProgress(progressOf(AccuracyWork::findingSteps), doing);
  m_chart->work()->showProgress(progressOf(AccuracyWork::measuring), doing);
  m_map->work()->showProgress(progressOf(AccuracyWork::comparing), doing);
}

void AccuracyPanel::setMapUnavailable(const QString& reason) {
  m_mapUnavailable = reason;
  showScene();
}

void AccuracyPanel::setCompared(const std::optional<ComparedPicture>& compared) {
  m_map->setCompared(compared ? &*compared : nullptr);
  if (compared)
    bringIntoView(m_map);
}

void AccuracyPanel::sayComparisonEnded(const QString& sentence) {
  m_map->sayEnded(sentence);
}

void AccuracyPanel::resizeEvent(QResizeEvent* event) {
  SectionPanel::resizeEvent(event);
  m_chart->fitInto(viewport()->height());
}

// What was begun or found is seen from its heading on, once all has its place: nothing is cut above it.
void AccuracyPanel::bringIntoView(QWidget* section) {
  QTimer::singleShot(0, section, [this, section] {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    const int top = section->mapTo(widget(), QPoint()).y();
    const int shown = verticalScrollBar()->value();
    if (top < shown || top + section->height() > shown + viewport()->height())
      verticalScrollBar()->setValue(top);
  });
}

void AccuracyPanel::showScene() {
  const MeasuredAccuracy* holds = holding();
  Scene onScreen = m_scene;
  onScreen.quality = m_onScreen.value_or(m_scene.quality);
  m_dial->show(m_scene, holds, m_onScreen ? pointOf(onScreen, steepestPerMm()) : std::nullopt, m_told);
  const std::optional<OperatingPoint> point = pointOf(m_scene, steepestPerMm());
  m_chart->setCurrent(holds && point ? indexOf(*point, holds->report.points) : std::nullopt);
  if (m_measured)
    m_chart->setRelation(!holds                                       ? MeasuredFor::earlierPicture
                         : m_measured->scene.camera != m_scene.camera ? MeasuredFor::otherCamera
                                                                      : MeasuredFor::thisPicture);
  m_chart->setCanMeasure(m_scene.volume && m_work == AccuracyWork::none);
  m_map->setUnavailable(!m_scene.volume                     ? tr("Open a volume first.")
                        : m_work == AccuracyWork::measuring ? tr("Wait until the measuring is done.")
                                                            : m_mapUnavailable);
}

// The measured accuracy where it holds for what is shown.
const MeasuredAccuracy* AccuracyPanel::holding() const {
  return m_scene.volume && m_measured && holdsFor(m_measured->scene, m_scene) ? &*m_measured : nullptr;
}

double AccuracyPanel::steepestPerMm() const {
  const MeasuredAccuracy* holds = holding();
  return holds ? holds->steepestPerMm : 0.0;
}

// The dial changes the step and leaves how it is taken as it is.
void AccuracyPanel::useStep(const OperatingPoint& point) {
  OperatingPoint plain = point;
  plain.preintegrated = false;
  Quality quality = qualityAt(point, m_scene, steepestPerMm());
  quality.preintegrated = m_scene.quality.preintegrated;
  ask(quality, tr("use %1").arg(pointText(plain)));
}

void AccuracyPanel::use(const OperatingPoint& point) {
  if (isOfTheWindow(point))
    ask(qualityAt(point, m_scene, steepestPerMm()), tr("use %1").arg(pointText(point)));
}

void AccuracyPanel::ask(const Quality& quality, const QString& undoText) {
  if (quality.toleranceLevels)
    emit toleranceWished(quality, {nextGestureId(), undoText, true});
  else
    emit qualityEdited(quality, {nextGestureId(), undoText, true});
}

void AccuracyPanel::answer(const WishAnswer& answer) {
  m_answered.reset();
  if (answer.point)
    m_answered = m_measured->report.points[*answer.point].point;
  m_wish->showAnswer(answer.sentence);
  if (m_answered)
    use(OperatingPoint(*m_answered));
}

} // namespace limn
