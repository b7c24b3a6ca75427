// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h> // before any OpenGL header of Qt

#include "widgets/view/CompareView.h"

#include "widgets/view/ReferencePanel.h"
#include "widgets/view/SurfaceFormat.h"
#include "widgets/view/ViewPanels.h"
#include "widgets/view/ViewPictures.h"

#include <QOpenGLContext>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int idleMs = 150;        // from the last coarse picture to refinement
constexpr int labelsStayMs = 4000; // the numbers of a label, after the pointer rests
constexpr int labelFadeMs = 400;

} // namespace

CompareView::CompareView(QWidget* parent) : QOpenGLWidget(parent) {
  setFormat(limnSurfaceFormat());
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr("Drag to rotate, middle drag to pan, right drag or wheel to zoom"));

  m_idleTimer.setSingleShot(true);
  m_idleTimer.setInterval(idleMs);
  connect(&m_idleTimer, &QTimer::timeout, this, &CompareView::refine);
  m_refineTimer.setSingleShot(true);
  connect(&m_refineTimer, &QTimer::timeout, this, &CompareView::refine);
  m_restTimer.setSingleShot(true);
  connect(&m_restTimer, &QTimer::timeout, this, &CompareView::workAtRest);
  m_probeTimer.setSingleShot(true);
  connect(&m_probeTimer, &QTimer::timeout, this, &CompareView::probeError);

  m_labelFade.setDuration(labelFadeMs);
  m_labelFade.setStartValue(1.0);
  m_labelFade.setEndValue(0.0);
  connect(&m_labelFade, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
  m_labelTimer.setSingleShot(true);
  m_labelTimer.setInterval(labelsStayMs);
  connect(&m_labelTimer, &QTimer::timeout, this, [this] { m_labelFade.start(); });

  makePanels();
  makeReference();
}

void CompareView::makePanels() {
  m_empty = new EmptyPanel(this);
  connect(m_empty, &EmptyPanel::openFolderRequested, this, &CompareView::openFolderRequested);
  connect(m_empty, &EmptyPanel::openFileRequested, this, &CompareView::openFileRequested);
  connect(m_empty, &EmptyPanel::sampleRequested, this, &CompareView::sampleRequested);
  m_message = new MessagePanel(this);
  m_message->hide();
  connect(m_message, &MessagePanel::retryRequested, this, [this] {
    m_error.clear();
    redraw();
  });
  m_loading = new LoadingPanel(this);
  m_loading->hide();
  connect(m_loading, &LoadingPanel::cancelled, this, &CompareView::loadingCancelled);
}

CompareView::~CompareView() {
  releasePictures();
  // The base class destroys the context after this class is gone.
  if (context())
    disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &CompareView::releasePictures);
}

void CompareView::setScene(const Scene& scene) {
  if (scene == m_scene)
    return;
  const bool otherVolume = scene.volume != m_scene.volume;
  const bool otherKind = otherVolume || scene.projection != m_scene.projection;
  Scene asShown = scene;
  asShown.camera = m_scene.camera;
  if (otherVolume)
    leaveProcessor();
  if (asShown != m_scene && !m_onProcessor) // more than the camera: what failed may work now
    m_error.clear();
  if (otherVolume) {
    m_probe.reset();
    m_drag.reset();
  }
  if (otherKind)
    m_quality.forget();
  if (scene.shading != m_scene.shading)
    wakeLabels();
  m_scene = scene;
  redraw();
}

void CompareView::setCompareLayout(CompareLayout layout) {
  if (layout == m_layout)
    return;
  m_layout = layout;
  m_swapped = false;
  wakeLabels();
  redraw();
}

void CompareView::setModels(ShadingModel left, ShadingModel right) {
  const std::array models{left, right};
  if (models == m_models)
    return;
  m_models = models;
  wakeLabels();
  redraw();
}

void CompareView::setWipePosition(double fraction) {
  m_wipe = std::clamp(fraction, 0.0, 1.0);
  showOtherParts();
}

// What a coarse picture hides behind the wipe's border was not drawn.
void CompareView::showOtherParts() {
  if (m_layout == CompareLayout::wipe && !m_state.resting)
    redraw();
  else
    update();
}

void CompareView::setTool(ViewTool tool) {
  if (tool == m_tool)
    return;
  m_tool = tool;
  emit toolChanged(tool);
}

void CompareView::setOverlayVisible(bool visible) {
  m_overlayVisible = visible;
  update();
}

void CompareView::setLoading(double fraction, const QString& text) {
  m_loading->setProgress(fraction, text);
  m_loading->show();
  updatePanels();
}

void CompareView::clearLoading() {
  m_loading->hide();
  updatePanels();
}

QImage CompareView::currentPicture(int side) {
  return m_state.resting && side < m_pictures->count() ? m_pictures->side(side).picture().bytes : QImage();
}

std::optional<Image> CompareView::restingImage(int side) {
  if (!m_state.resting || side >= m_pictures->count())
    return std::nullopt;
  return *m_pictures->side(side).picture().image;
}

Scene CompareView::sceneOfSide(int side) const {
  Scene scene = m_scene;
  if (m_layout != CompareLayout::single)
    scene.shading.model = m_models[side];
  return scene;
}

int CompareView::compiledPrograms() const {
  return m_pictures ? m_pictures->compiledPrograms() : 0;
}

std::vector<Scene> CompareView::scenesOfSides() const {
  std::vector<Scene> scenes;
  for (int side = 0; side < pictureCount(m_layout); ++side)
    scenes.push_back(sceneOfSide(side));
  return scenes;
}

GradientScale CompareView::gradientScaleOfSide(int side) const {
  return m_pictures && side < m_pictures->count() ? m_pictures->side(side).gradientScale() : GradientScale{};
}

glm::ivec2 CompareView::deviceSize() const {
  const double ratio = devicePixelRatioF();
  return {static_cast<int>(std::lround(width() * ratio)), static_cast<int>(std::lround(height() * ratio))};
}

std::vector<PixelRect> CompareView::rects() const {
  const int gap = static_cast<int>(std::lround(2.0 * devicePixelRatioF()));
  return pictureRects(m_layout, deviceSize(), gap);
}

double CompareView::pictureAspect() const {
  const std::vector<PixelRect> places = rects();
  return places.empty() ? 1.0 : static_cast<double>(places[0].size.x) / places[0].size.y;
}

void CompareView::initializeGL() {
  // The context may be replaced when the view moves to another window.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &CompareView::releasePictures,
          Qt::UniqueConnection);
  m_quality.forget();
  m_stale = true;
}

void CompareView::makePictures() {
  if (!m_pictures)
    m_pictures = std::make_unique<ViewPictures>();
}

void CompareView::releasePictures() {
  if (!m_pictures)
    return;
  stopDrawing();
  makeCurrent();
  // What a lost context held died with it; to delete it would need another.
  if (context()->isValid() && QOpenGLContext::currentContext() == context())
    m_pictures.reset();
  else
    static_cast<void>(m_pictures.release());
  doneCurrent();
  m_state = {};
}

void CompareView::resizeGL(int, int) {
  redraw();
}

void CompareView::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  updatePanels();
}

void CompareView::showEvent(QShowEvent* event) {
  QOpenGLWidget::showEvent(event);
  // Without OpenGL paintGL() is never called; the window would stay black.
  QTimer::singleShot(0, this, [this] {
    if (!isVisible() || isValid())
      return;
    const QString problem = openGlProblem();
    fail(problem.isEmpty()
             ? tr("The graphics driver gives this window no OpenGL context; restart the program.")
             : problem);
  });
  if (!m_state.resting)
    redraw();
  else
    m_restTimer.start(0);
}

void CompareView::updatePanels() {
  m_empty->setGeometry(rect());
  m_message->setGeometry(rect());
  const int height = m_loading->sizeHint().height();
  m_loading->setGeometry(0, this->height() - height, width(), height);
  const bool showsReference = m_onProcessor && !m_referencePanel->pictures().empty();
  m_referencePanel->cover(rect());
  m_referencePanel->showParts(showsReference);
  m_message->setSentence(m_error);
  m_message->setVisible(!m_error.isEmpty() && !showsReference);
  m_empty->setVisible(m_error.isEmpty() && !m_scene.volume);
  m_loading->raise();
}

void CompareView::redraw() {
  m_stale = true;
  if (m_state.resting) {
    m_state.resting = false;
    m_state.refines = false;
    m_state.refinementEnd.reset();
    for (SideState& side : m_state.sides)
      side.fraction = 0.0;
    emit pictureStateChanged(m_state);
  }
  m_refineTimer.stop();
  m_idleTimer.stop();
  leaveRest();
  updatePanels();
  if (m_onProcessor)
    drawOnProcessor();
  update();
}

void CompareView::paintGL() {
  if (m_scene.volume && m_error.isEmpty())
    guarded([this] {
      makePictures();
      if (m_stale)
        drawCoarsely();
    });
  const glm::dvec3 background = m_scene.image.background;
  if (m_pictures && m_scene.volume && m_error.isEmpty()) {
    const glm::ivec2 size = deviceSize();
    m_pictures->show({m_layout, rects(), size, wipeColumn(size.x, m_wipe), m_swapped},
                     defaultFramebufferObject(), background);
    if (m_overlayVisible)
      paintOverlay();
  } else {
    glClearColor(static_cast<float>(background.r), static_cast<float>(background.g),
                 static_cast<float>(background.b), 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  m_sinceShown.start();
}

// Draw at the quality that was fast enough last time; where it proves to have been too careful, once more.
void CompareView::drawCoarsely() {
  m_stale = false;
  const std::vector<PixelRect> places = rects();
  if (places.empty())
    return;
  m_pictures->want(scenesOfSides(), places[0].size);
  const double all = static_cast<double>(places.size()) * places[0].size.x * places[0].size.y;
  const double seen = m_layout == CompareLayout::wipe ? 0.5 * all : all;
  int level = m_quality.levelFor(seen);
  if (level == 0 && m_quality.levelFor(all) > 0)
    level = 1; // full quality draws the hidden parts too
  m_quality.measured(level, level == 0 ? all : seen, m_pictures->drawCoarsely(level, seenColumns()));
  if (m_quality.levelFor(all) < level) {
    m_stale = true;
    QTimer::singleShot(0, this, qOverload<>(&QWidget::update));
  }
  m_idleTimer.start();
  if (!m_probeTimer.isActive())
    m_probeTimer.start(0);
  updateState();
  showEffects();
}

// Of a wipe's two pictures each shows one part.
std::array<Columns, 2> CompareView::seenColumns() const {
  std::array<Columns, 2> seen;
  if (m_layout == CompareLayout::wipe) {
    seen[sideShownAt(0)].to = m_wipe;
    seen[sideShownAt(1)].from = m_wipe;
  }
  return seen;
}

void CompareView::refine() {
  if (!isVisible() || !m_pictures || !m_error.isEmpty() || !m_scene.volume)
    return;
  bool complete = false;
  makeCurrent();
  guarded([&] { complete = m_pictures->refine(budgetMs); });
  doneCurrent();
  updateState();
  if (complete || m_sinceShown.elapsed() >= showEveryMs)
    update();
  if (!m_error.isEmpty())
    return;
  if (complete)
    noteRecovery();
  (complete ? m_restTimer : m_refineTimer).start(0);
}

void CompareView::wakeLabels() {
  const bool hidden = m_labelFade.state() == QAbstractAnimation::Running ||
                      m_labelFade.currentTime() == m_labelFade.totalDuration();
  m_labelFade.stop();
  m_labelFade.setCurrentTime(0);
  m_labelTimer.start();
  if (hidden)
    update();
}

} // namespace limn
