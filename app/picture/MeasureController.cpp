// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/MeasureController.h"

#include "app/picture/CameraController.h"
#include "app/picture/CrosshairController.h"
#include "app/window/WindowContext.h"
#include "planes/EllipseVoxels.h"
#include "scene/framing/KeptVoxels.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/panels/HintBar.h"

#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr int measureTellsForMs = 6000;
constexpr int leastHeightForBar =
    400; // of the pictures, so that it is clear of the face where it lies upon them

// What lies in a slice is led there: a place that is seen in the picture lies elsewhere.
bool isLedInSlices(const Measurement& measurement) {
  return measurement.plane && measurement.kind != Measurement::Kind::mark;
}

// Whether the voxel that a place lies in and all around it are hidden by crop, cuts or labels: what lies
// within a voxel of what is kept is seen at it.
bool liesCutAway(const Scene& scene, const glm::dvec3& placeMm) {
  const Grid& grid = scene.volume->grid();
  const KeptVoxels kept(grid, scene.keep, scene.crop);
  const glm::ivec3 at(glm::round(worldToIndex(grid, placeMm)));
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i)
        if (kept.has(at.x + i, at.y + j, at.z + k))
          return false;
  return true;
}

// What to do with the tool, which is in hand in the picture and in slices alike.
QString hintFor(Measurement::Kind kind, bool hasSlices) {
  using Kind = Measurement::Kind;
  switch (kind) {
  case Kind::distance:
    return MeasureController::tr("Click both ends");
  case Kind::angle:
    return MeasureController::tr("Click end, corner and end");
  case Kind::mark:
    return MeasureController::tr("Click the place to mark");
  case Kind::ellipse:
    break; // which no picture has
  }
  return hasSlices ? MeasureController::tr("In a slice, drag from corner to corner or click both")
                   : MeasureController::tr("An ellipse is drawn in a slice; View ▸ Slices shows them.");
}

// While one is drawn: its next place, and how it ends. Nothing of what has but one.
QString nextHint(Measurement::Kind kind, std::size_t place) {
  if (kind == Measurement::Kind::mark)
    return {};
  if (kind == Measurement::Kind::ellipse)
    return MeasureController::tr("Now the opposite corner, which ends it. Esc takes it back.");
  if (kind == Measurement::Kind::angle && place < 2)
    return MeasureController::tr("Now the corner of the angle. Esc takes it back.");
  return MeasureController::tr("Now the other end, which ends it. Esc takes it back.");
}

// Whether drags draw it: a distance, or an angle's first leg.
bool hasLegs(Measurement::Kind kind) {
  return kind == Measurement::Kind::distance || kind == Measurement::Kind::angle;
}

} // namespace

MeasureController::MeasureController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_bar(new HintBar(tr("Measuring"), &context.view)) {
  MeasureInput* input = &context.view.input().measures();
  connect(&context.planes, &PlaneDeck::measurementsEdited, this, [this](const MeasurementsEdited& edited) {
    m_open.reset(); // one is drawn at a time
    edit(edited);
  });
  connect(&context.session, &Session::measurementsChanged, this, &MeasureController::refresh);
  connect(&context.view, &CompareView::toolChanged, this, &MeasureController::showTool);
  connect(&context.session, &Session::planesChanged, this, &MeasureController::showBar);
  connect(m_bar, &HintBar::closeRequested, this, [this] {
    layAside();
    m_context.view.setFocus(); // the button that had the keyboard is gone
  });
  context.keepClear(*m_bar);
  m_bar->setDrawing([this] { return m_open.has_value(); });
  m_bar->setLeastHeight(leastHeightForBar);
  connect(input, &MeasureInput::placeRequested, this, &MeasureController::pick);
  connect(input, &MeasureInput::stretched, this, &MeasureController::stretch);
  input->setDrawsFrom([this](const Ray& ray, int side) { return drawsFrom(ray, side); });
  connect(input, &MeasureInput::taken, this, &MeasureController::take);
  connect(input, &MeasureInput::led, this, &MeasureController::lead);
  connect(input, &MeasureInput::left, this, [this] {
    if (m_led)
      edit({m_led->before, m_inHand, {m_led->gesture, {}}});
  });
  connect(input, &MeasureInput::removed, this, &MeasureController::remove);
  connect(input, &MeasureInput::dropped, this, &MeasureController::drop);
  connect(&context.view, &CompareView::told, this, [this](const ViewNews& news) {
    if (std::exchange(m_isAtRest, news.state.resting) != m_isAtRest)
      findHidden();
  });
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene& scene) {
    if (scene.volume == m_volume)
      return;
    if (!haveSameVoxels(std::exchange(m_volume, scene.volume), scene.volume))
      m_inHand.reset();
    m_measured.clear(); // what they said was said of other places
    m_hidden.clear();
    m_open.reset();
    m_led.reset();
    sayNext({});
    refresh();
    showBar();
  });
  // Once slices know the other volume, so that they take back nothing of the one before.
  context.followers.add(SceneFollowers::Stage::after,
                        [this, armedFor = m_volume](const Scene& scene) mutable {
                          const auto before = std::exchange(armedFor, scene.volume);
                          if (!haveSameVoxels(before, scene.volume))
                            layAside();
                        });
}

void MeasureController::layAside() {
  if (kindOf(m_context.view.tool()))
    m_context.view.setTool(ViewTool::rotate);
}

void MeasureController::edit(const MeasurementsEdited& edited) {
  if (!m_volume)
    return;
  m_inHand = edited.inHand;
  sayNext(edited.next && m_inHand ? nextHint(edited.measurements.at(*m_inHand).kind, *edited.next)
                                  : QString());
  m_measured = measuredIn(m_volume.get(), edited.measurements, m_measured);
  if (edited.measurements == m_context.session.measurements())
    return show(); // another one is in hand
  Gesture gesture = edited.gesture;
  if (gesture.text.isEmpty() && m_inHand && *m_inHand < m_measured.size())
    gesture.text = measureTitle(m_measured[*m_inHand], *m_volume);
  m_context.session.setMeasurements(edited.measurements, gesture);
}

// The list ends with what waits in a slice for its next click. Where another row is edited that goes.
void MeasureController::editListed(const MeasurementsEdited& edited) {
  MeasurementsEdited wanted = edited;
  const std::vector<Measurement> before = m_context.session.measurements();
  const bool isOfLast = edited.inHand && *edited.inHand + 1 == before.size();
  if (!isOfLast && m_context.planes.endLooseDrag() && !wanted.measurements.empty() &&
      wanted.measurements.back() == before.back())
    wanted.measurements.pop_back();
  edit(wanted);
}

// What is said of those that stayed as they were is not found anew.
void MeasureController::refresh() {
  m_measured = measuredIn(m_volume.get(), m_context.session.measurements(), m_measured);
  if (m_inHand && *m_inHand >= m_measured.size()) {
    m_inHand.reset();
    sayNext({}); // what was drawn was undone
  }
  if (std::vector<Measurement> now = placed(); now != m_lookedFor) {
    if (now.size() != m_lookedFor.size())
      m_hidden.clear(); // of others
    findHidden();
  }
  show();
}

std::vector<Measurement> MeasureController::placed() const {
  std::vector<Measurement> measurements;
  for (const Measured& one : m_measured)
    measurements.push_back(one.measurement);
  return measurements;
}

// While the picture rests, because each place takes a ray that is followed as exactly as a pixel.
void MeasureController::findHidden() {
  m_looking.cancel();
  m_lookedFor = placed();
  if (!m_isAtRest || m_measured.empty() || !m_context.view.scene().volume)
    return;
  const std::vector<Scene> sides = m_context.view.scenesOfSides();
  std::vector<GradientScale> scales;
  for (std::size_t side = 0; side < sides.size(); ++side)
    scales.push_back(m_context.view.input().scaleOfSide(static_cast<int>(side)));
  m_looking.start(
      [this, measurements = m_lookedFor, sides, scales](const Effort& effort) -> BackgroundWork::Deliver {
        std::vector<std::array<bool, 2>> hidden;
        for (const Measurement& one : measurements) {
          if (effort.isCancelled && effort.isCancelled())
            break;
          std::array<bool, 2>& found = hidden.emplace_back();
          for (std::size_t side = 0; side < sides.size() && isSeenInPicture(one); ++side)
            found.at(side) = std::ranges::all_of(one.placesMm, [&](const glm::dvec3& placeMm) {
              return liesCutAway(sides[side], placeMm) || isHidden(sides[side], scales[side], placeMm);
            });
        }
        return [this, hidden] {
          m_hidden = hidden;
          show();
        };
      });
}

// While one is being drawn no other is in hand, so that Delete takes none that is finished.
void MeasureController::show() {
  const std::optional<std::size_t> inHand = m_open ? std::nullopt : m_inHand;
  std::vector<SeenMeasure> seen;
  for (std::size_t number = 0; m_volume && number < m_measured.size(); ++number)
    if (const Measured& one = m_measured[number]; isSeenInPicture(one.measurement))
      seen.push_back({number, one.measurement.kind, one.measurement.placesMm, measureNoteText(one, *m_volume),
                      inHand == number, isLedInSlices(one.measurement),
                      number < m_hidden.size() ? m_hidden[number] : std::array<bool, 2>{}});
  if (m_open && !m_open->placesMm.empty()) {
    std::vector<glm::dvec3> places = m_open->placesMm;
    if (m_stretchedTo)
      places.push_back(*m_stretchedTo);
    seen.push_back({m_measured.size(), m_open->kind, places, {}, true, true, {}});
  }
  m_context.view.setMeasures(seen);
  emit shown(m_measured, m_volume, inHand);
}

void MeasureController::goTo(std::size_t number) {
  drop();
  if (number >= m_measured.size())
    return;
  m_inHand = number;
  PlaneContent content;
  content.volume = m_volume;
  content.settings = m_context.session.planes();
  m_context.session.setPlanes(withCrosshair(content, middleMm(m_measured[number].measurement)));
  show();
}

void MeasureController::useTool(Measurement::Kind kind) {
  m_context.view.setTool(viewToolOf(kind));
}

void MeasureController::remove() {
  if (!drop() && m_volume && m_inHand)
    edit(withoutMeasure(m_measured, *m_inHand, *m_volume));
}

bool MeasureController::drop() {
  if (!std::exchange(m_open, std::nullopt))
    return m_context.planes.endLooseDrag();
  sayNext({});
  show();
  return true;
}

// Another tool leaves what has not all of its places.
void MeasureController::showTool() {
  m_open.reset();
  sayNext({});
  if (QStatusBar& bar = *m_context.window.statusBar(); !m_said.isEmpty() && bar.currentMessage() == m_said)
    bar.clearMessage(); // of the tool before
  m_said.clear();
  show();
  showBar();
}

bool MeasureController::hasSlices() const {
  return m_context.session.planes().layout != PlaneLayout::pictureOnly;
}

void MeasureController::showBar() {
  const std::optional<Measurement::Kind> kind = kindOf(m_context.view.tool());
  if (!m_volume || !kind) {
    sayNext({});
    return m_bar->putAway();
  }
  const QString hint = hintFor(*kind, hasSlices());
  if (m_bar->isOut() && m_bar->hint() == hint) // slices are scrolled
    return m_bar->lookAgain();
  m_bar->showHint(
      hint,
      hasLegs(*kind)
          ? tr("A drag over tissue measures, too; one beside it rotates the picture, as does any while ends "
               "are "
               "missing. What was measured is led by its ends and goes with Delete. Esc takes back what is "
               "begun, then lays the tool aside.")
          : tr("What was measured is led by its ends and goes with Delete; a drag over the picture rotates "
               "it. "
               "Esc takes back what is begun, then lays the tool aside."));
  if (!m_bar->hasRoom())
    say(hint);
}

std::optional<glm::dvec3> MeasureController::placeSeen(const Ray& ray, int side) {
  if (m_context.view.sceneOfSide(side).projection == Projection::average) {
    say(tr("In an average every depth counts alike, so that there is no place to measure at."));
    return std::nullopt;
  }
  const TurnCentre seen = turnCentreAlong(m_context.view, ray, side);
  if (!seen.placeMm)
    say(seen.reason);
  return seen.placeMm;
}

// A drag draws a distance, or an angle's first leg. While one lacks places it turns the picture, because they
// may lie on its other side, as it does beside the tissue.
bool MeasureController::drawsFrom(const Ray& ray, int side) const {
  const std::optional<Measurement::Kind> kind = kindOf(m_context.view.tool());
  return kind && hasLegs(*kind) && m_volume && !m_open &&
         m_context.view.sceneOfSide(side).projection != Projection::average &&
         turnCentreAlong(m_context.view, ray, side).placeMm;
}

// Off the tissue it stays where it was.
void MeasureController::stretch(const Ray& ray, int side) {
  const TurnCentre seen = turnCentreAlong(m_context.view, ray, side);
  if (!m_open || !seen.placeMm)
    return;
  m_stretchedTo = seen.placeMm;
  show();
}

void MeasureController::pick(const Ray& ray, int side) {
  m_stretchedTo.reset();
  const std::optional<Measurement::Kind> kind = kindOf(m_context.view.tool());
  if (!kind || !m_volume)
    return;
  if (*kind == Measurement::Kind::ellipse)
    return say(hintFor(*kind, hasSlices()));
  const std::optional<glm::dvec3> place = placeSeen(ray, side);
  if (!place)
    return show(); // without the place that a drag had reached
  if (!m_open) {
    m_context.planes.setTool(toolOf(*kind)); // takes back what was begun in a slice
    m_open = Measurement{*kind, std::nullopt, {}};
  }
  m_open->placesMm.push_back(*place);
  if (m_open->placesMm.size() < placesOf(*kind)) {
    sayNext(nextHint(*kind, m_open->placesMm.size()));
    return show();
  }
  std::vector<Measurement> measurements = m_context.session.measurements();
  if (*kind == Measurement::Kind::mark)
    m_open->name = freeName(measurements);
  measurements.push_back(*m_open);
  m_open.reset();
  const std::size_t last = measurements.size() - 1;
  edit({std::move(measurements), last, {nextGestureId(), {}}});
}

void MeasureController::take(const MeasureHandle& handle, std::uint64_t gesture) {
  m_led.reset();
  m_context.planes.endLooseDrag();
  if (handle.number >= m_measured.size())
    return; // of the one that is being measured
  m_led = Led{handle, gesture, m_context.session.measurements()};
  m_inHand = handle.number;
  show();
}

void MeasureController::lead(const Ray& ray, int side) {
  if (!m_led || m_led->handle.number >= m_context.session.measurements().size())
    return;
  const std::optional<glm::dvec3> place = placeSeen(ray, side);
  if (!place)
    return;
  std::vector<Measurement> measurements = m_context.session.measurements();
  Measurement& led = measurements[m_led->handle.number];
  led.placesMm[m_led->handle.place] = *place;
  edit({std::move(measurements), m_led->handle.number, {m_led->gesture, {}}});
}

// It stands until that place is there, and hides nothing else that was said meanwhile.
void MeasureController::sayNext(const QString& hint) {
  QStatusBar& bar = *m_context.window.statusBar();
  const QString before = std::exchange(m_next, hint);
  if (before == hint)
    return;
  if (!hint.isEmpty())
    bar.showMessage(hint);
  else if (bar.currentMessage() == before)
    bar.clearMessage();
}

void MeasureController::say(const QString& sentence) {
  m_said = sentence;
  m_context.window.statusBar()->showMessage(sentence, measureTellsForMs);
}

} // namespace limn
