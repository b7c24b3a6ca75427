// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/TurnedBoxController.h"

#include "app/window/WindowContext.h"
#include "planes/PlaneGrid.h"
#include "scene/framing/VisibleVoxels.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QAction>
#include <QStatusBar>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr int turnedToldForMs = 6000;

// Of a box found again, as a share of its size: a millionth of a voxel, and a million times what a double
// rounds.
constexpr double roundingOfBox = 1e-9;

// Where a place lies in a box, as fractions along its axes.
glm::dvec3 fractionsIn(const Grid& box, const glm::dvec3& placeMm) {
  return (worldToIndex(box, placeMm) + 0.5) / glm::dvec3(box.dims);
}

// Around the whole volume, along three axes at right angles to one another.
Grid gridAround(const Grid& volume, const glm::dmat3& axes) {
  Grid grid;
  grid.direction = axes;
  glm::dvec3 first(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const ReachMm reach = reachAlong(volume, axes[axis]);
    const double size = reach.last - reach.first;
    grid.dims[axis] = std::max(1, static_cast<int>(std::lround(size / smallestSpacingMm(volume))));
    grid.spacingMm[axis] = size / grid.dims[axis];
    first[axis] = reach.first + grid.spacingMm[axis] / 2.0;
  }
  grid.originMm = axes * first;
  return grid;
}

// The part of a box that holds what a scene's crop leaves or, where that leaves all, its body.
CropBox leftIn(const Grid& box, const Scene& scene) {
  const Grid& volume = scene.volume->grid();
  const CropBox left = scene.crop == CropBox{} ? boxAroundBody(scene) : scene.crop;
  CropBox part{glm::dvec3(1.0), glm::dvec3(0.0)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 isUpper(corner & 1, corner & 2, corner & 4);
    const glm::dvec3 fraction = glm::mix(left.lower, left.upper, isUpper);
    const glm::dvec3 at = fractionsIn(box, indexToWorld(volume, fraction * glm::dvec3(volume.dims) - 0.5));
    part.lower = glm::min(part.lower, at);
    part.upper = glm::max(part.upper, at);
  }
  return {glm::max(part.lower, 0.0), glm::min(part.upper, 1.0)};
}

// The part of a box that holds what is seen of a scene, and a voxel more on each side. What lies on the disk
// is not read for it.
CropBox seenIn(const Grid& box, const Scene& scene) {
  if (scene.volume->room())
    return leftIn(box, scene);
  const Grid& volume = scene.volume->grid();
  const auto placeOfIndex = [&](const glm::dvec3& index) {
    return fractionsIn(box, indexToWorld(volume, index));
  };
  const glm::dvec3 first = placeOfIndex(glm::dvec3(0.0));
  glm::dmat3 step;      // from a voxel to the next along each axis
  glm::dvec3 half(0.0); // of a voxel, along the axes of the box
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 next(0.0);
    next[axis] = 1.0;
    step[axis] = placeOfIndex(next) - first;
    half += 0.5 * glm::abs(step[axis]);
  }
  const VisibleVoxels seen = visibleVoxels(scene);
  const double unit = seen.unitVoxels;
  CropBox part{glm::dvec3(1.0), glm::dvec3(0.0)};
  const auto take = [&](const glm::dvec3& lowest, double voxels) {
    const glm::dvec3 middle = first + step * (lowest + (voxels - 1.0) / 2.0);
    const glm::dvec3 reach = (voxels + 2.0) * half;
    return CropBox{middle - reach, middle + reach};
  };
  for (const VisibleBlock& block : seen.blocks) {
    const glm::dvec3 corner = unit * blockUnits * glm::dvec3(block.place);
    const CropBox whole = take(corner, unit * blockUnits);
    if (glm::all(glm::greaterThanEqual(whole.lower, part.lower)) &&
        glm::all(glm::lessThanEqual(whole.upper, part.upper)))
      continue;
    for (int z = 0; z < blockUnits; ++z)
      for (std::uint64_t left = block.units[static_cast<std::size_t>(z)]; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const CropBox one = take(corner + unit * glm::dvec3(bit % blockUnits, bit / blockUnits, z), unit);
        part.lower = glm::min(part.lower, one.lower);
        part.upper = glm::max(part.upper, one.upper);
      }
  }
  return {glm::max(part.lower, 0.0), glm::min(part.upper, 1.0)};
}

// The line that says what the rectangle across two axes leaves.
struct Side {
  int along, across, up;
};
constexpr Side besides{1, 0, 2};
constexpr Side foreAndAft{2, 0, 1};

// A rectangle of the box, seen along one of its axes, outside of which all goes.
Cut sideCut(const TurnedBox& box, const Side& side) {
  const auto [along, across, up] = side;
  const Grid& grid = box.grid;
  const glm::dvec3 size = boxSizeMm(grid);
  const double beyond = boxDiagonalMm(grid);
  Camera camera;
  camera.projection = Camera::Projection::orthographic;
  camera.target = boxCentreMm(grid);
  camera.position = camera.target - beyond * grid.direction[along];
  camera.up = grid.direction[up];
  camera.heightMm = 2.0 * beyond;
  const CameraBasis basis = basisOf(camera);
  Scissors scissors{camera, 1.0, {}, false, {}};
  const glm::dvec3 lower = box.crop.lower - 0.5, upper = box.crop.upper - 0.5;
  for (const glm::dvec2& corner :
       {glm::dvec2(lower[across], lower[up]), glm::dvec2(upper[across], lower[up]),
        glm::dvec2(upper[across], upper[up]), glm::dvec2(lower[across], upper[up])}) {
    const glm::dvec3 place =
        corner.x * size[across] * grid.direction[across] + corner.y * size[up] * grid.direction[up];
    scissors.polygon.emplace_back(glm::dot(place, basis.right) / beyond, glm::dot(place, basis.up) / beyond);
  }
  const QString name = along == foreAndAft.along ? TurnedBoxController::tr("Turned box, front and back")
                                                 : TurnedBoxController::tr("Turned box, four sides");
  return {scissors, true, name.toStdString()};
}

// The axes of the box that a line would say a side of.
glm::dmat3 axesOf(const Camera& camera, const Side& side) {
  const CameraBasis basis = basisOf(camera);
  glm::dmat3 axes;
  axes[side.along] = basis.forward;
  axes[side.up] = basis.up;
  axes[side.across] = glm::cross(axes[(side.across + 1) % 3], axes[(side.across + 2) % 3]);
  return axes;
}

// The part of the box that the line of a side leaves across and up; the whole where it has not four corners.
void setPart(TurnedBox& box, const Side& side, const Scissors& scissors) {
  if (scissors.polygon.size() != 4)
    return;
  const CameraBasis basis = basisOf(scissors.camera);
  const auto placeOf = [&](const glm::dvec2& corner) {
    return fractionsIn(box.grid, scissors.camera.target + halfHeight(scissors.camera) *
                                                              (corner.x * basis.right + corner.y * basis.up));
  };
  const glm::dvec3 lower = placeOf(scissors.polygon[0]), upper = placeOf(scissors.polygon[2]);
  for (const int axis : {side.across, side.up}) {
    box.crop.lower[axis] = lower[axis] < roundingOfBox ? 0.0 : lower[axis];
    box.crop.upper[axis] = upper[axis] > 1.0 - roundingOfBox ? 1.0 : upper[axis];
  }
}

// Whether the crop takes more than what lies beside the body, which is hidden anyway.
bool takesOfBody(const Scene& scene) {
  const CropBox body = boxAroundBody(scene);
  return glm::any(glm::greaterThan(scene.crop.lower, body.lower)) ||
         glm::any(glm::lessThan(scene.crop.upper, body.upper));
}

// Whether two boxes around one volume lie alike, but for the rounding of one found again.
bool isAlong(const Grid& one, const Grid& other) {
  for (int axis = 0; axis < 3; ++axis)
    if (glm::distance(one.direction[axis], other.direction[axis]) > roundingOfBox)
      return false;
  return glm::distance(boxCentreMm(one), boxCentreMm(other)) <= roundingOfBox * boxDiagonalMm(one);
}

// Whether two cuts take the same, but for the rounding of a box found again.
bool takeTheSame(const Cut& a, const Cut& b) {
  const auto* one = std::get_if<Scissors>(&a.how);
  const auto* other = std::get_if<Scissors>(&b.how);
  if (!one || !other || a.isOn != b.isOn || one->removesInside != other->removesInside ||
      one->depthMm != other->depthMm || one->aspect != other->aspect ||
      one->camera.projection != other->camera.projection || one->polygon.size() != other->polygon.size())
    return false;
  const double size = other->camera.heightMm;
  double apart = std::max({glm::distance(one->camera.position, other->camera.position) / size,
                           glm::distance(one->camera.target, other->camera.target) / size,
                           glm::distance(one->camera.up, other->camera.up),
                           std::abs(one->camera.heightMm - size) / size});
  for (std::size_t i = 0; i < one->polygon.size(); ++i)
    apart = std::max(apart, glm::distance(one->polygon[i], other->polygon[i]));
  return apart <= roundingOfBox;
}

} // namespace

TurnedBox boxTurnedTo(const Camera& camera, const Scene& scene) {
  const CameraBasis basis = basisOf(camera);
  const Grid grid = gridAround(scene.volume->grid(), glm::dmat3(basis.right, basis.forward, basis.up));
  const CropBox fit = seenIn(grid, scene);
  return {grid, fit, fit};
}

std::vector<Cut> cutsOf(const TurnedBox& box) {
  // What is not seen now may be seen later: faces that nobody moved inwards leave it.
  TurnedBox cutting{box.grid, {}};
  for (const CropFace face : cropFaces)
    if (cutBy(box, face) > 0.0)
      (face.isUpper ? cutting.crop.upper : cutting.crop.lower)[face.axis] = placeOf(box.crop, face);
  const auto isCut = [&](int axis) {
    return cutting.crop.lower[axis] > 0.0 || cutting.crop.upper[axis] < 1.0;
  };
  std::vector<Cut> cuts;
  if (isCut(0) || isCut(2))
    cuts.push_back(sideCut(cutting, besides));
  if (isCut(1))
    cuts.push_back(sideCut(cutting, foreAndAft));
  return cuts;
}

std::optional<FoundBox> boxAtTheEnd(const std::vector<Cut>& cuts, const Grid& volume) {
  // Both lines, one of the sides, or one of front and back.
  const std::vector<std::vector<Side>> ways = {{besides, foreAndAft}, {besides}, {foreAndAft}};
  for (const std::vector<Side>& way : ways) {
    if (cuts.size() < way.size())
      continue;
    const std::vector<Cut> last(cuts.end() - static_cast<std::ptrdiff_t>(way.size()), cuts.end());
    if (!std::ranges::all_of(last, [](const Cut& cut) { return std::holds_alternative<Scissors>(cut.how); }))
      continue;
    TurnedBox box{gridAround(volume, axesOf(std::get<Scissors>(last.front().how).camera, way.front())), {}};
    for (std::size_t i = 0; i < way.size(); ++i)
      setPart(box, way[i], std::get<Scissors>(last[i].how));
    // Seen along another axis than its own, a line would have its sides the wrong way round.
    const bool hasRoom = glm::all(glm::lessThan(box.crop.lower, box.crop.upper));
    if (hasRoom && std::ranges::equal(cutsOf(box), last, takeTheSame))
      return FoundBox{box, last.size()};
  }
  return std::nullopt;
}

TurnedBoxController::TurnedBoxController(WindowContext& context)
    : QObject(&context.window), m_context(context) {
  const QAction* turn = context.actions.add(
      QStringLiteral("turnCropBox"),
      {.text = tr("Turn the crop bo&x to this view"),
       .place = {Menu::view, 2, 9},
       .toolTip =
           tr("Puts a box over the picture that lies as the picture is seen now; what its faces, which "
              "are dragged, leave outside is cut away."),
       .needsVolume = true});
  connect(turn, &QAction::triggered, this, &TurnedBoxController::turn);
  connect(&context.view.input(), &ViewInput::turnedBoxEdited, this, &TurnedBoxController::cropTo);
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
}

void TurnedBoxController::turn() {
  const Scene& scene = m_context.session.scene();
  if (!scene.volume)
    return;
  m_turned = Turned{scene.volume, boxTurnedTo(scene.camera, scene), scene.keep.cuts, scene.keep.cuts,
                    scene.keep.cuts};
  remember(m_turned->box, scene.volume);
  m_context.view.setTurnedBox(m_turned->box);
  m_context.actions.find("cropBox").setChecked(true);
  m_context.window.statusBar()->showMessage(
      tr("The box lies as the picture does now. Its handles cut; the list of cuts has what they take."),
      turnedToldForMs);
}

void TurnedBoxController::showBox(bool isShown) {
  if (!isShown)
    end();
  else if (!m_turned)
    takeUp(m_context.session.scene());
}

// Looking for it takes a walk through the volume, so it is done once for each way to lie.
CropBox TurnedBoxController::fitOf(const Grid& box, const Scene& scene) {
  if (m_fittedTo.lock() == scene.volume)
    for (const TurnedBox& known : m_fitted)
      if (isAlong(known.grid, box))
        return known.fit;
  Scene uncut = scene; // as it was before its own lines
  uncut.keep = withoutCuts(scene.keep);
  const CropBox fit = seenIn(box, uncut);
  remember({box, fit, fit}, scene.volume);
  return fit;
}

void TurnedBoxController::remember(const TurnedBox& box, const std::shared_ptr<const Volume>& volume) {
  if (m_fittedTo.lock() != volume)
    m_fitted.clear();
  m_fittedTo = volume;
  std::erase_if(m_fitted, [&](const TurnedBox& known) { return isAlong(known.grid, box.grid); });
  m_fitted.push_back(box);
}

// The box whose lines are the last of the list, if there is one.
void TurnedBoxController::takeUp(const Scene& scene) {
  const auto found = scene.volume ? boxAtTheEnd(scene.keep.cuts, scene.volume->grid()) : std::nullopt;
  if (!found)
    return end();
  std::vector<Cut> before = scene.keep.cuts;
  before.resize(before.size() - found->cuts);
  TurnedBox box = found->box;
  box.fit = fitOf(box.grid, scene);
  for (const CropFace face : cropFaces) // those that cut nothing stand where something is seen
    if (double& place = (face.isUpper ? box.crop.upper : box.crop.lower)[face.axis];
        place == (face.isUpper ? 1.0 : 0.0))
      place = placeOf(box.fit, face);
    else if (cutBy(box, face) == 0.0)
      (face.isUpper ? box.fit.upper : box.fit.lower)[face.axis] = face.isUpper ? 1.0 : 0.0;
  m_turned = Turned{scene.volume, box, before, scene.keep.cuts, scene.keep.cuts};
  m_context.view.setTurnedBox(m_turned->box);
}

void TurnedBoxController::cropTo(const CropBox& crop, const Gesture& gesture) {
  if (!m_turned)
    return;
  m_turned->box.crop = crop;
  m_context.view.setTurnedBox(m_turned->box);
  m_turned->asked = m_turned->before;
  const std::vector<Cut> own = cutsOf(m_turned->box);
  m_turned->asked.insert(m_turned->asked.end(), own.begin(), own.end());
  emit cutsWanted(m_turned->asked, gesture);
}

// Once the list of cuts is another (one step back, edited), the box is the one that it says now, or the
// crop's again. While the crop's is shown, a list that ends in a turned box shows that one.
void TurnedBoxController::showScene(const Scene& scene) {
  const bool isOther = std::exchange(m_seen, scene.keep.cuts) != scene.keep.cuts;
  if (!m_turned) {
    if (isOther && m_context.actions.find("cropBox").isChecked())
      takeUp(scene);
    return;
  }
  if (scene.keep.cuts == m_turned->asked)
    m_turned->made = m_turned->asked;
  if (scene.volume == m_turned->volume && scene.keep.cuts == m_turned->made)
    return;
  takeUp(scene);
}

// Of both boxes: the crop's lies below the turned one.
void TurnedBoxController::tellWhatStaysCut(bool isShown) {
  const QString sentence = tr("The crop box is put away; what its faces cut away stays so.");
  const Scene& scene = m_context.session.scene();
  const bool isCut =
      scene.volume && (takesOfBody(scene) || boxAtTheEnd(scene.keep.cuts, scene.volume->grid()));
  // What went wrong, or waits for an answer, stays to be read.
  const bool isTaken = m_context.messages.isWanted() && !m_context.messages.isNote();
  if (!isShown && isCut && isTaken)
    m_context.window.statusBar()->showMessage(sentence, turnedToldForMs);
  else if (!isShown && isCut)
    m_context.messages.show(MessageBar::Kind::note, sentence, {}, {tr("Close the box's cuts"), [this] {
                                                                     m_context.messages.hide();
                                                                     closeAll();
                                                                   }});
  else if (m_context.messages.isNote() && m_context.messages.sentence() == sentence)
    m_context.messages.hide();
}

void TurnedBoxController::closeAll() {
  const Scene& scene = m_context.session.scene();
  if (!scene.volume)
    return;
  const Gesture gesture{nextGestureId(), tr("close the box's cuts")};
  std::vector<Cut> cuts = scene.keep.cuts;
  while (const auto found = boxAtTheEnd(cuts, scene.volume->grid()))
    cuts.resize(cuts.size() - found->cuts);
  const bool hasLines = cuts != scene.keep.cuts;
  m_context.session.setCrop({}, gesture);
  if (hasLines)
    emit cutsWanted(cuts, gesture);
}

void TurnedBoxController::end() {
  m_turned.reset();
  m_context.view.setTurnedBox(std::nullopt);
}

} // namespace limn
