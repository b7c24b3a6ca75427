// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/CutController.h"

#include "app/picture/CameraController.h"
#include "app/window/WindowContext.h"
#include "reference/ProfileAlong.h"
#include "regions/Cutting.h"
#include "regions/ScissorSet.h"
#include "scene/LabelLooks.h"
#include "scene/volume/VolumePart.h"
#include "widgets/ValueText.h"
#include "widgets/planes/PlaneCut.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/properties/CutSection.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/panels/CutBar.h"

#include <QStatusBar>

#include <algorithm>
#include <array>

namespace limn {
namespace {

constexpr int tellsForMs = 6000;
constexpr double litBeside = 0.12; // of the opacity of what is not the piece: seen, and plainly not meant
constexpr int depthsAcross = 24;   // at which the depth inside a line is looked for, along its longer side
constexpr double pastSeenMm = 2.0; // further, so that what is seen goes with its whole skin

// In which the curves of pieces begin, so that each is told from the rest at once.
const std::array<glm::dvec3, 6> pieceColors{{{0.85, 0.2, 0.15},
                                             {0.25, 0.7, 0.3},
                                             {0.25, 0.5, 0.95},
                                             {0.95, 0.75, 0.2},
                                             {0.75, 0.35, 0.85},
                                             {0.2, 0.75, 0.8}}};

// The ray through a place of the picture (DEFINITION section 8).
Ray rayAt(const Camera& camera, const glm::dvec2& place) {
  const CameraBasis basis = basisOf(camera);
  const glm::dvec3 beside = halfHeight(camera) * (place.x * basis.right + place.y * basis.up);
  return *rayThroughPlace(camera, camera.position + basis.forward + beside); // never the eye itself
}

// How deep lies what is seen inside the line, where half of a ray's light is gathered, mm along the rays;
// nothing where nothing is seen there.
std::optional<double> depthInside(const Scissors& scissors, const Scene& scene, const GradientScale& scale,
                                  const Effort& effort) {
  glm::dvec2 lower = scissors.polygon.front(), upper = lower;
  for (const glm::dvec2& corner : scissors.polygon) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  const double step = std::max(upper.x - lower.x, upper.y - lower.y) / depthsAcross;
  std::vector<double> depths;
  for (double y = lower.y + step / 2; y < upper.y; y += step)
    for (double x = lower.x + step / 2; x < upper.x; x += step) {
      if (effort.isCancelled && effort.isCancelled())
        return std::nullopt;
      if (!isInside(scissors.polygon, {x, y}))
        continue;
      const Ray ray = rayAt(scissors.camera, {x, y});
      const std::optional<RayProfile> profile = profileAlong(scene, scale, ray);
      if (const auto depth = profile ? halfLightDepth(*profile) : std::nullopt)
        depths.push_back(glm::dot(placeAt(*profile, *depth) - ray.origin, ray.direction));
    }
  return depths.empty() ? std::nullopt : std::optional(depthOfSeen(std::move(depths)));
}

// "226 – 3071 HU · 812 ml · mean 640 HU"
QString pieceText(const ConnectedPiece& piece, const SetFigures& figures, const Volume& volume) {
  const ValueRange range = foundRange(piece, volume);
  const QString lowest =
      valueText(range.lowest, {}, decimalsOfSpan(volume.range().highest - volume.range().lowest));
  const QString ml = plainNumber(figures.millilitres, figures.millilitres < 10.0 ? 2 : 0);
  // The wheel would leave out the place that was clicked.
  if (isNarrowest(piece, volume))
    return CutController::tr("%1 – %2 · %3 ml · no narrower by the wheel")
        .arg(lowest, readingText(range.highest, volume), ml);
  return CutController::tr("%1 – %2 · %3 ml · mean %4")
      .arg(lowest, readingText(range.highest, volume), ml, readingText(figures.mean, volume));
}

} // namespace

CutController::CutController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_bar(new CutBar(&context.view)) {
  const ViewInput* input = &context.view.input();
  connect(&context.view, &CompareView::toolChanged, this, &CutController::showTool);
  connect(input, &ViewInput::lineClosed, this, &CutController::cutAlong);
  connect(input, &ViewInput::pieceRequested, this, &CutController::pick);
  connect(input, &ViewInput::pieceNarrowed, this, &CutController::narrow);
  const PlaneDeck* planes = &context.planes;
  connect(planes, &PlaneDeck::pieceRequested, this, &CutController::pickAt);
  connect(planes, &PlaneDeck::pieceNarrowed, this, &CutController::narrow);
  connect(planes, &PlaneDeck::lineClosed, this, &CutController::cutInSlice);
  connect(&context.view, &CompareView::cornersBegun, this, &CutController::tellHowCornersEnd);
  connect(planes, &PlaneDeck::cornersBegun, this, &CutController::tellHowCornersEnd);
  connect(m_bar, &CutBar::insideChosen, this, &CutController::takeInside);
  connect(m_bar, &CutBar::depthChosen, this, [this](bool onlySeen) { m_onlySeen = onlySeen; });
  connect(m_bar, &CutBar::similarRequested, this, &CutController::takeSimilar);
  connect(m_bar, &CutBar::reachChosen, this, &CutController::takeReach);
  connect(m_bar, &CutBar::hideRequested, this, [this] { finish(ConnectedPiece::Fate::hidden); });
  connect(m_bar, &CutBar::aloneRequested, this, [this] { finish(ConnectedPiece::Fate::alone); });
  connect(m_bar, &CutBar::lookRequested, this, [this] { finish(ConnectedPiece::Fate::ownLook); });
  connect(m_bar, &CutBar::closeRequested, this, [this] {
    m_context.view.setTool(ViewTool::rotate);
    m_context.view.setFocus(); // the button that had the keyboard is gone
  });
  context.keepClear(*m_bar);
  m_bar->setDrawing([view = &context.view] { return view->input().cutLine().has_value(); });
  connect(&m_work, &BackgroundWork::failed, this, [this](const QString& sentence) {
    putDown();
    m_context.showError(sentence);
  });
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
}

void CutController::showTool() {
  putDown();
  if (m_context.view.tool() != ViewTool::piece)
    m_bar->forgetReach(); // nobody expects it of the next piece, which may be picked by a menu
  showBar();
}

void CutController::showBar() {
  const ViewTool tool = m_context.view.tool();
  if (!m_volume || (tool != ViewTool::scissors && tool != ViewTool::piece))
    m_bar->putAway();
  else if (tool == ViewTool::scissors)
    m_bar->showScissors(m_removesInside, m_onlySeen);
  else if (m_shown)
    m_bar->showPiece(pieceText(*m_piece, m_shown->figures, *m_volume), true);
  else
    m_bar->showPiece(m_piece ? tr("Looking for what hangs together…")
                             : tr("Click what is meant; the wheel then takes less or more"),
                     false);
}

void CutController::cutAlong(const std::vector<glm::dvec2>& polygon, double aspect) {
  const Scissors scissors{m_context.session.scene().camera, aspect, polygon, m_removesInside, {}};
  if (m_onlySeen)
    cutToSeen(scissors);
  else
    cut(scissors);
}

void CutController::cut(const Scissors& scissors) {
  emit cutWanted({scissors, true},
                 scissors.removesInside ? tr("cut away inside a line") : tr("cut away outside a line"));
}

// What is seen of the volume in a slice is the slab that is shown.
void CutController::cutInSlice(PatientPlane plane, Scissors scissors) {
  PlaneContent content;
  content.volume = m_volume;
  content.settings = m_context.session.planes();
  scissors.removesInside = m_removesInside;
  if (m_onlySeen)
    scissors.depthMm = slabDepthMm(content, plane, scissors);
  cut(scissors);
}

void CutController::cutToSeen(Scissors scissors) {
  const int side = m_context.view.ownSide();
  m_work.start([this, scissors = std::move(scissors), scene = m_context.view.sceneOfSide(side),
                scale = m_context.view.input().scaleOfSide(side)](
                   const Effort& effort) mutable -> BackgroundWork::Deliver {
    const std::optional<double> depth = depthInside(scissors, scene, scale, effort);
    if (depth)
      scissors.depthMm = glm::dvec2(0.0, *depth + pastSeenMm);
    return [this, scissors] {
      if (scissors.depthMm)
        cut(scissors);
      else
        say(tr("Nothing is seen inside the line, so nothing was cut."));
    };
  });
}

void CutController::pick(const Ray& ray, int side) {
  const TurnCentre seen = strongestAlong(m_context.view, ray, side);
  if (!seen.placeMm)
    return say(seen.reason);
  pickAt(*seen.placeMm);
}

void CutController::pickAt(const glm::dvec3& worldMm) {
  if (!m_volume)
    return;
  const std::optional<ConnectedPiece> piece = pieceAt(m_context.session.scene(), worldMm);
  if (!piece)
    return say(tr("Nothing that the curve shows lies there, so there is no piece to pick."));
  m_context.view.setTool(ViewTool::piece);
  m_piece = piece;
  m_piece->reachMm = m_bar->reachMm();
  m_pointedMm = worldMm;
  findPiece();
}

void CutController::findPiece() {
  m_work.start([this, piece = *m_piece, volume = m_volume,
                keep = m_keep](const Effort& effort) -> BackgroundWork::Deliver {
    const std::shared_ptr<const Volume> whole = wholeOf(volume);
    const BitGrid found = pieceAmong(keptVoxels(keep, *whole, partOf(effort, 0.0, 0.1)), *whole, piece,
                                     partOf(effort, 0.1, 0.7));
    const Shown shown{lit(keep, found, litBeside, partOf(effort, 0.7, 0.9)),
                      // The rim that goes with it is no part of what the range names.
                      figuresOf(found, *whole, piece.range, partOf(effort, 0.9, 1.0))};
    return [this, shown] { show(shown); };
  });
  showBar();
}

void CutController::narrow(double notches, bool onlyAbove) {
  if (!m_piece || !m_volume)
    return;
  const ConnectedPiece before = *m_piece;
  m_piece = onlyAbove ? narrowedAbove(before, *m_volume, notches) : narrowed(before, *m_volume, notches);
  if (m_piece != before)
    findPiece();
}

void CutController::takeSimilar() {
  if (!m_piece || !m_volume)
    return;
  m_piece = withValuesAround(*m_piece, *m_volume, m_keep, m_pointedMm);
  findPiece();
}

void CutController::takeReach() {
  if (!m_piece)
    return;
  m_piece->reachMm = m_bar->reachMm();
  findPiece();
}

void CutController::show(const Shown& shown) {
  m_shown = shown;
  m_context.view.input().setWheelIsForPiece(true);
  m_context.planes.setWheelIsForPiece(true);
  // What fades beside it are labels more, behind those there were.
  PlaneLit stands{shown.lit.labels, std::vector<bool>(shown.lit.weights.size())};
  const std::size_t own = std::max<std::size_t>(1, m_keep.labels ? m_keep.weights.size() : 0);
  for (std::size_t place = 0; place < own; ++place)
    stands.isLit[place] = shown.lit.weights[place] > 0.0;
  emit stoodOut(stands);
  showScene(m_context.session.scene());
  showBar();
}

void CutController::finish(ConnectedPiece::Fate fate) {
  if (!m_piece || !m_shown)
    return;
  ConnectedPiece piece = *m_piece;
  piece.fate = fate;
  const Scene& scene = m_context.session.scene();
  const auto told = std::count_if(scene.keep.cuts.begin(), scene.keep.cuts.end(), pieceWithLook);
  if (fate == ConnectedPiece::Fate::ownLook)
    piece.look =
        inOneColor(scene.transferFunction, pieceColors[static_cast<std::size_t>(told) % pieceColors.size()]);
  putDown();
  showBar();
  m_context.view.setFocus();
  emit cutWanted({piece, true}, fate == ConnectedPiece::Fate::alone    ? tr("keep a piece alone")
                                : fate == ConnectedPiece::Fate::hidden ? tr("hide a piece")
                                                                       : tr("give a piece its own curve"));
}

// What is lit goes out; the tool stays in hand.
void CutController::putDown() {
  m_work.cancel();
  m_piece.reset();
  m_context.view.input().setWheelIsForPiece(false);
  m_context.planes.setWheelIsForPiece(false);
  if (!m_shown)
    return;
  m_shown.reset();
  emit stoodOut({});
  m_context.view.setScene(m_context.session.scene());
  m_context.view.setPreview({});
}

// What is lit stays so while the camera moves, and goes out with what it is a part of.
void CutController::showScene(const Scene& scene) {
  const bool isOther = scene.volume != m_volume || scene.keep != m_keep;
  const bool isOtherVolume = !haveSameVoxels(scene.volume, m_volume);
  m_volume = scene.volume;
  m_keep = scene.keep;
  if (isOther && (m_piece || m_work.isRunning()))
    putDown();
  if (isOtherVolume)
    layDown();
  if (isOther)
    showBar();
  if (!m_shown)
    return;
  Scene lit = scene;
  lit.keep = m_shown->lit;
  m_context.view.setScene(lit);
  m_context.view.setPreview(tr("the piece that hangs together").toStdString());
}

// Nobody expects the first drag on another volume to cut, nor the scissors to keep what they took before.
void CutController::layDown() {
  const ViewTool tool = m_context.view.tool();
  if (tool == ViewTool::scissors || tool == ViewTool::piece)
    m_context.view.setTool(ViewTool::rotate);
  m_onlySeen = false;
  takeInside(true);
}

void CutController::takeInside(bool isInside) {
  m_removesInside = isInside;
  m_context.view.setLinesRemoveInside(isInside);
  m_context.planes.setLinesRemoveInside(isInside);
}

// Meanwhile the bar is out of the way.
void CutController::tellHowCornersEnd(bool areBegun) const {
  const QString how = tr("Enter or a double click closes the line. Esc takes it back.");
  QStatusBar& bar = *m_context.window.statusBar();
  if (areBegun)
    bar.showMessage(how);
  else if (bar.currentMessage() == how)
    bar.clearMessage();
}

void CutController::say(const QString& sentence) const {
  m_context.window.statusBar()->showMessage(sentence, tellsForMs);
}

} // namespace limn
