// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/AccuracyController.h"

#include "app/asking/FileDialogs.h"
#include "app/core/drawing/PathAccuracy.h"
#include "app/document/DocumentText.h"
#include "app/window/WindowContext.h"
#include "io/AtomicFile.h"
#include "io/reports/AccuracyPage.h"
#include "io/reports/ReportJson.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "widgets/Translated.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/accuracy/ChartPicture.h"
#include "widgets/accuracy/ErrorMapOverlay.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/Titles.h"
#include "widgets/view/panels/PictureStatusText.h"

#include <QBuffer>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <tuple>
#include <utility>

namespace limn {
namespace {

// What the exact picture depends on: not the step, and not where rays may end.
Scene withoutQuality(Scene scene) {
  scene.quality = {};
  return scene;
}

// One that cannot keep its tolerance comes first: that is to be told.
bool needsFinerSteps(const WithinTolerance& a, const WithinTolerance& b) {
  const auto rank = [](const WithinTolerance& found) {
    const Quality& quality = found.scene.quality;
    return std::tuple(found.holds, -quality.fineness.value_or(0.0), quality.stepVoxels);
  };
  return rank(a) < rank(b);
}

constexpr int mostPixels = 224; ///< each way, of a picture that is measured
constexpr int mostPathsMeasured = 128;
constexpr QSize chartSize(1200, 750);

QByteArray pngOf(const QImage& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG"))
    throw Error(Error::Kind::other, Message::tr("The chart cannot be written as PNG; is there memory left?"));
  return bytes;
}

QByteArray accuracyFile(const AccuracyReport& report, const QString& ending) {
  if (ending == QStringLiteral("csv"))
    return QByteArray::fromStdString(accuracyCsv(report));
  QByteArray chart = pngOf(accuracyChartPicture(report, chartSize, ChartStyle::print));
  if (ending != QStringLiteral("html"))
    return chart;
  // The page carries its chart, so that one file can be passed on.
  const QByteArray address = "data:image/png;base64," + chart.toBase64();
  return QByteArray::fromStdString(accuracyPage(report, address.toStdString()));
}

} // namespace

/// One piece of work on its thread.
class AccuracyMeasurer::Job {
public:
  Job(AccuracyMeasurer& owner, const BackgroundWork::Line& line, std::shared_ptr<const Exact> exact,
      Engine rays)
      : m_owner(owner), m_line(line), m_exact(std::move(exact)),
        m_renderers(0, line.effort.isCancelled, rays) {}

  RealRenderers& renderers() { return m_renderers; }
  Effort effort() const { return {0, m_line.effort.isCancelled, {}}; }

  /// Tells progress from one part of the whole to another.
  ReportProgress progress(double from, double to) {
    return [this, from, to](double fraction, const Message& doing) {
      if (m_line.effort.isCancelled())
        throw Cancelled();
      m_line.report(from + fraction * (to - from), doing);
    };
  }

  /// The exact picture of a scene, drawn unless it was drawn last.
  const ConvergedPicture& exactPicture(const Scene& scene, const glm::ivec2& size, double share) {
    if (m_exact && m_exact->scene == withoutQuality(scene) && m_exact->size == size)
      return m_exact->picture;
    m_exact = std::make_shared<const Exact>(
        Exact{withoutQuality(scene), size,
              convergedPicture(withoutQuality(scene), size, m_renderers.precisely(), progress(0.0, share))});
    m_line.tell([&owner = m_owner, exact = m_exact] { owner.m_exact = exact; });
    return m_exact->picture;
  }

private:
  AccuracyMeasurer& m_owner;
  const BackgroundWork::Line& m_line;
  std::shared_ptr<const Exact> m_exact;
  RealRenderers m_renderers;
};

AccuracyMeasurer::AccuracyMeasurer(QObject* parent) : QObject(parent) {
  connect(&m_work, &BackgroundWork::progressed, this, &AccuracyMeasurer::progressed);
  connect(&m_work, &BackgroundWork::failed, this,
          [this](const QString& why) { emit failed(tr("The accuracy cannot be measured. %1").arg(why)); });
}

void AccuracyMeasurer::forgetOthersThan(const std::shared_ptr<const Volume>& volume) {
  if (m_exact && m_exact->scene.volume != volume)
    m_exact.reset();
}

void AccuracyMeasurer::measure(const QString& name, const Scene& scene, const glm::ivec2& size) {
  start([this, name = name.toStdString(), scene, size](Job& job) -> BackgroundWork::Deliver {
    const double steepest = steepness(*scene.volume);
    if (isPhysical(scene)) {
      MeasuredAccuracy accuracy{
          measurePaths(name, scene, size, mostPathsMeasured, job.effort(), job.progress(0.0, 1.0)), scene,
          steepest};
      return [this, accuracy = std::move(accuracy)] { emit measured(accuracy); };
    }
    const ConvergedPicture& exact = job.exactPicture(scene, size, 0.5);
    MeasuredAccuracy accuracy{measureAccuracy(name, scene, size, pointsToMeasure(scene, steepest), exact,
                                              job.renderers(), job.progress(0.5, 1.0)),
                              scene, steepest};
    return [this, accuracy = std::move(accuracy)] { emit measured(accuracy); };
  });
}

void AccuracyMeasurer::compare(const Scene& scene, const glm::ivec2& size) {
  start([this, scene, size](Job& job) -> BackgroundWork::Deliver {
    if (isPhysical(scene)) {
      ComparedPicture compared;
      compared.point.paths = scene.quality.paths.value_or(pathsOf(scene.shading.physical.until));
      compared.reference.converged = compared.reference.isByChance = true;
      PathErrors errors = pathErrors(scene, size, job.effort(), job.progress(0.0, 1.0));
      compared.error = errors.error;
      compared.map = std::move(errors.map);
      return [this, compared = std::move(compared)] { emit this->compared(compared); };
    }
    const ConvergedPicture& exact = job.exactPicture(scene, size, 0.95);
    ComparedPicture compared;
    compared.point.stepVoxels = scene.quality.stepVoxels;
    compared.point.toleranceLevels = scene.quality.toleranceLevels;
    compared.reference = exact.facts;
    if (exact.facts.converged) {
      const Image picture = job.renderers().render(scene, size);
      compared.error = imageError(picture, exact.pixels);
      compared.map = errorMap(picture, exact.pixels);
    }
    return [this, compared = std::move(compared)] { emit this->compared(compared); };
  });
}

void AccuracyMeasurer::findSteps(const std::vector<Scene>& scenes, const glm::ivec2& size) {
  start([this, scenes, size](Job& job) -> BackgroundWork::Deliver {
    const ReportProgress progress = job.progress(0.0, 1.0);
    const double usualPictures = 8.0 * static_cast<double>(scenes.size());
    int pictures = 0;
    // Some eight small pictures of each are commonly needed; how many is not known before.
    const DrawScene draw = [&](const Scene& tried, const glm::ivec2& pixels) {
      progress(1.0 - usualPictures / (usualPictures + pictures++),
               Message::tr("Looking for the steps that are needed"));
      return job.renderers().render(tried, pixels);
    };
    std::vector<WithinTolerance> found;
    found.reserve(scenes.size());
    for (const Scene& scene : scenes)
      found.push_back(
          withinTolerance(scene, size, draw, job.renderers().control(), job.renderers().filterBits()));
    const WithinTolerance finest = *std::min_element(found.begin(), found.end(), needsFinerSteps);
    return [this, finest] { emit stepsFound(finest); };
  });
}

void AccuracyMeasurer::start(std::function<BackgroundWork::Deliver(Job& job)> task) {
  m_work.start(
      [this, exact = m_exact, rays = m_rays, task = std::move(task)](const BackgroundWork::Line& line) {
        Job job(*this, line, exact, rays);
        return task(job);
      });
}

AccuracyController::AccuracyController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_panel(*new AccuracyPanel(&context.window)),
      m_map(new ErrorMapOverlay(&context.view)) {
  context.docks.add(
      {tr("&Accuracy"), "accuracyDock", &m_panel, Qt::RightDockWidgetArea, SessionDocument::Panel::accuracy});
  const double movingMs = context.settings.movingMs();
  context.view.setMovingMs(movingMs);
  m_panel.setMovingMs(movingMs);
  addRefinement();
  connectPanel();
  connectMeasurer();
  connect(m_map, &ErrorMapOverlay::outgrown, this, &AccuracyController::endMap);
  connect(&context.view, &CompareView::told, this,
          [this](const ViewNews& news) { showOnScreen(news.state); });
}

void AccuracyController::addRefinement() {
  QAction* refine = m_context.actions.add(
      QStringLiteral("refineAtRest"),
      {.text = tr("Sharpen while nothing &moves"),
       .toolTip = tr("While nothing moves, draws the picture again with smaller and smaller "
                     "steps until it lies within half a level of the exact one."),
       .isCheckable = true});
  m_context.actions.addSetting({.row = 4, .action = refine});
  refine->setChecked(m_context.settings.refinesAtRest());
  m_context.view.setRefinesAtRest(refine->isChecked());
  connect(refine, &QAction::toggled, this, [this](bool refines) {
    m_context.settings.setRefinesAtRest(refines);
    m_context.view.setRefinesAtRest(refines);
  });
}

void AccuracyController::connectPanel() {
  AccuracyPanel* panel = &m_panel;
  connect(panel, &AccuracyPanel::qualityEdited, &m_context.session, &Session::setQuality);
  connect(panel, &AccuracyPanel::toleranceWished, this, &AccuracyController::findSteps);
  connect(panel, &AccuracyPanel::movingMsPicked, this, [this](double ms) {
    m_context.settings.setMovingMs(ms);
    m_context.view.setMovingMs(ms);
  });
  connect(panel, &AccuracyPanel::measureRequested, this, &AccuracyController::measure);
  connect(panel, &AccuracyPanel::mapRequested, this, &AccuracyController::showMap);
  connect(panel, &AccuracyPanel::saveRequested, this, &AccuracyController::save);
  connect(panel, &AccuracyPanel::cancelRequested, this, [this] {
    m_measurer.cancel();
    setWork(AccuracyWork::none);
  });
}

void AccuracyController::connectMeasurer() {
  connect(&m_measurer, &AccuracyMeasurer::progressed, &m_panel, &AccuracyPanel::showProgress);
  connect(&m_measurer, &AccuracyMeasurer::measured, this, [this](const MeasuredAccuracy& measured) {
    setWork(AccuracyWork::none);
    showMeasured(measured);
  });
  connect(&m_measurer, &AccuracyMeasurer::stepsFound, this, &AccuracyController::useSteps);
  connect(&m_measurer, &AccuracyMeasurer::compared, this, &AccuracyController::showCompared);
  connect(&m_measurer, &AccuracyMeasurer::failed, this, [this](const QString& sentence) {
    setWork(AccuracyWork::none);
    m_context.messages.show(MessageBar::Kind::error, sentence);
  });
}

// What is measured is what the window does.
AccuracyMeasurer& AccuracyController::measurer() {
  m_measurer.setRays(m_context.view.engine());
  return m_measurer;
}

void AccuracyController::measure() {
  const Scene scene = m_context.view.sceneOfSide(measuredSide());
  const QString name = tr("%1, %2").arg(suggestedName(m_context.document), sideTitle(scene));
  measurer().measure(name, scene, measuredSize());
  setWork(AccuracyWork::measuring);
}

void AccuracyController::showMeasured(const MeasuredAccuracy& measured) {
  m_measured = measured.report;
  m_panel.setMeasured(timedFor(measured, shownSize()));
  m_context.view.setMeasuredErrors(
      [measured = *m_panel.measured()](const Scene& shown) { return levelsMeasuredOf(shown, measured); });
}

void AccuracyController::findSteps(const Quality& quality, const Gesture& gesture) {
  takeMapBack();
  std::vector<Scene> scenes;
  for (int side = 0; side < pictureCount(m_context.view.compareLayout()); ++side) {
    scenes.push_back(m_context.view.sceneOfSide(side));
    scenes.back().quality = quality;
  }
  m_toleranceGesture = gesture;
  measurer().findSteps(scenes, shownSize());
  setWork(AccuracyWork::findingSteps);
}

void AccuracyController::useSteps(const WithinTolerance& found) {
  setWork(AccuracyWork::none);
  m_context.session.setQuality(found.scene.quality, m_toleranceGesture);
  if (!m_warned.isEmpty() && m_context.messages.sentence() == m_warned)
    m_context.messages.hide(); // it was about the tolerance before
  m_warned = found.holds ? QString() : translated(found.sentence);
  if (!found.holds)
    m_context.messages.show(MessageBar::Kind::warning, m_warned);
}

// The map is of the picture as it stands on screen, refined or not.
void AccuracyController::showMap(bool shown) {
  takeMapBack();
  if (!shown)
    return;
  m_compared = m_context.view.sceneOfSide(measuredSide());
  m_comparedSize = shownSize();
  measurer().compare(m_context.view.sceneOfRestingImage(measuredSide()), m_comparedSize);
  setWork(AccuracyWork::comparing);
}

void AccuracyController::takeMapBack() {
  m_map->setVisible(false);
  m_compared = {};
  m_mapped.reset();
  if (m_panel.work() == AccuracyWork::comparing) {
    m_measurer.cancel();
    setWork(AccuracyWork::none);
  }
  m_panel.setCompared(std::nullopt);
}

void AccuracyController::endMap() {
  const bool wasComparing = m_panel.work() == AccuracyWork::comparing;
  takeMapBack();
  if (wasComparing)
    m_panel.sayComparisonEnded(
        tr("The picture changed before it was compared with the exact one; tick the box to begin again."));
}

void AccuracyController::showCompared(const ComparedPicture& picture) {
  setWork(AccuracyWork::none);
  m_panel.setCompared(picture);
  m_mapped = picture;
  if (picture.error)
    m_map->showMap(picture.map, m_context.view.logicalRect(measuredSide()));
}

void AccuracyController::showScene() {
  const Scene scene = m_context.view.sceneOfSide(measuredSide());
  const CompareLayout layout = m_context.view.compareLayout();
  const bool liesOver = layout == CompareLayout::wipe || layout == CompareLayout::difference;
  m_measurer.forgetOthersThan(scene.volume);
  m_panel.setScene(scene);
  if (m_compared.volume && (scene != m_compared || liesOver || shownSize() != m_comparedSize))
    endMap();
  m_panel.setMapUnavailable(
      liesOver ? tr("Choose one picture or side by side: here two pictures lie over each other.")
               : QString());
}

void AccuracyController::showOnScreen(const PictureState& state) {
  const auto index = static_cast<std::size_t>(measuredSide());
  if (!state.resting || index >= state.sides.size())
    return m_panel.setOnScreen(std::nullopt);
  const Scene scene = m_context.view.sceneOfSide(measuredSide());
  PictureState alone = state; // of two pictures the status bar tells the worse, and which that is
  alone.sides = {state.sides[index]};
  // What was measured the panel knows itself.
  const bool isTold = levelsOf(state.sides[index]) && !tellsMeasured(state.sides[index]);
  const QString told = isTold ? pictureStatusText(alone, scene).estimate : QString();
  m_panel.setOnScreen(qualityShown(scene.quality, state.sides[index]),
                      isTold && index > 0 ? tr("at the right %1", "how far a picture is off").arg(told)
                                          : told);
}

// While something is measured the pictures at rest do not refine: each would slow the other down.
void AccuracyController::setWork(AccuracyWork work) {
  m_panel.setWork(work);
  const bool pauses = work != AccuracyWork::none;
  if (std::exchange(m_pausesRefinement, pauses) != pauses)
    m_context.view.pauseRefinement(pauses);
}

// The right one of two, as for the effects.
int AccuracyController::measuredSide() const {
  return pictureCount(m_context.view.compareLayout()) - 1;
}

glm::ivec2 AccuracyController::shownSize() const {
  const QSizeF shown = m_context.view.logicalRect(measuredSide()).size() * m_context.view.devicePixelRatioF();
  return glm::max(glm::ivec2(qRound(shown.width()), qRound(shown.height())), glm::ivec2(1));
}

glm::ivec2 AccuracyController::measuredSize() const {
  const glm::dvec2 shown = shownSize();
  const double scale = std::min(1.0, mostPixels / std::max(shown.x, shown.y));
  return glm::max(glm::ivec2(glm::round(scale * shown)), glm::ivec2(1));
}

void AccuracyController::save() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString path =
      askWhereToSave(&m_context.window,
                     {tr("Save what was measured"),
                      suggestedName(m_context.document) + QStringLiteral("-accuracy.html"),
                      {tr("Page with chart and table (*.html)"), tr("Chart (*.png)"), tr("Table (*.csv)")},
                      folder},
                     m_context.settings);
  if (!path.isEmpty())
    write(path);
}

void AccuracyController::write(const QString& path) {
  if (!m_measured)
    return;
  const auto writeFile = [&] {
    const QByteArray bytes = accuracyFile(*m_measured, QFileInfo(path).suffix().toLower());
    writeFileAtomically(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
  };
  m_context.notes.attempt(writeFile, path);
}

AccuracyController::Memory AccuracyController::memory() const {
  Memory memory{m_measurer.exact(), {}, m_compared, m_comparedSize, m_mapped};
  if (m_measured && m_panel.measured()) {
    memory.measured = m_panel.measured();
    memory.measured->report = *m_measured; // its times are not those of the picture on screen
  }
  return memory;
}

void AccuracyController::takeOver(const Memory& memory) {
  showScene();
  m_measurer.setExact(memory.exact);
  if (memory.measured)
    showMeasured(*memory.measured);
  if (!memory.map || memory.comparedSize != shownSize())
    return;
  m_compared = memory.compared;
  m_comparedSize = memory.comparedSize;
  showCompared(*memory.map);
}

} // namespace limn
