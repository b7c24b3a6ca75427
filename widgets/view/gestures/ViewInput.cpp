// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewInput.h"

#include "widgets/theme/Icons.h"
#include "widgets/theme/Theme.h"
#include "widgets/view/overlay/CropBoxOverlay.h"
#include "widgets/view/overlay/LabelReading.h"
#include "widgets/view/overlay/OrientationCube.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/overlay/Titles.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QWheelEvent>
#include <QWidget>

#include <utility>

namespace limn {
namespace {

constexpr int ofTheWheel = -1; // among the causes of gestures, which are kinds of commands otherwise

constexpr int cursorSize = 24; // logical pixels

QPixmap iconIn(const QString& icon, bool isLight) {
  return themedIcon(icon, themePalette(isLight ? Look::dark : Look::light)).pixmap(cursorSize, cursorSize);
}

// A dark sign with a light edge.
QCursor cursorWith(const QString& icon) {
  QPixmap picture(cursorSize, cursorSize);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  const QPixmap edge = iconIn(icon, true);
  for (const QPoint offset : {QPoint(-1, 0), QPoint(1, 0), QPoint(0, -1), QPoint(0, 1)})
    painter.drawPixmap(offset, edge);
  painter.drawPixmap(0, 0, iconIn(icon, false));
  painter.end();
  return QCursor(picture);
}

} // namespace

QCursor cursorOf(DragKind kind) {
  switch (kind) {
  case DragKind::pan:
    return Qt::SizeAllCursor;
  case DragKind::zoom: {
    static const QCursor zoom = cursorWith(QStringLiteral("tool-zoom"));
    return zoom;
  }
  case DragKind::windowLevel: {
    static const QCursor windowLevel = cursorWith(QStringLiteral("tool-window-level"));
    return windowLevel;
  }
  default:
    return Qt::ArrowCursor;
  }
}

ViewInput::ViewInput(QWidget* view, Facts facts)
    : QObject(view), m_view(view), m_facts(std::move(facts)),
      m_measures(new MeasureInput(this, m_facts.shown)) {}

Hovered ViewInput::hovered() const {
  Hovered hovered = m_hovered;
  hovered.wipe = hovered.wipe || (m_drag && m_drag->kind == DragKind::wipe);
  return hovered;
}

std::optional<CropFace> ViewInput::heldFace() const {
  return m_drag && m_drag->kind == DragKind::cropFace ? std::optional(m_drag->face) : std::nullopt;
}

bool ViewInput::isTurning() const {
  return m_drag && m_drag->kind == DragKind::rotate && m_drag->last != m_drag->first;
}

void ViewInput::forget() {
  m_drag.reset();
  m_line.reset();
  m_measures->forget();
  m_read.reset();
}

void ViewInput::setLinesRemoveInside(bool isInside) {
  m_linesRemoveInside = isInside;
  if (m_line)
    m_line->removesInside = isInside;
}

void ViewInput::setTool(ViewTool tool) {
  if (tool == m_tool)
    return;
  m_tool = tool;
  m_line.reset();
  m_measures->forgetDrawn();
  if (m_hovered == Hovered{} && !m_drag)
    showCursor(std::nullopt);
  emit toolChanged(tool);
}

// What a press here would do.
void ViewInput::showCursor(const std::optional<CropHandle>& handle) {
  const bool leads = m_hovered.label >= 0 || m_hovered.hidden || m_hovered.cubeFace;
  m_view->setCursor(leads                                            ? Qt::PointingHandCursor
                    : handle                                         ? cursorFor(*handle)
                    : m_hovered.measure                              ? Qt::SizeAllCursor
                    : m_hovered.wipe                                 ? Qt::SplitHCursor
                    : m_tool == ViewTool::scissors || kindOf(m_tool) ? Qt::CrossCursor
                    : m_tool == ViewTool::piece                      ? Qt::PointingHandCursor
                                                : cursorOf(dragKind(Qt::LeftButton, Qt::NoModifier, m_tool)));
}

void ViewInput::ask(const ViewEdit& edit, const Gesture& gesture) {
  if (const auto* camera = std::get_if<Camera>(&edit))
    emit cameraEdited(*camera, gesture.id);
  else if (const auto* function = std::get_if<TransferFunction>(&edit))
    emit functionEdited(*function, gesture);
  else if (const auto* crop = std::get_if<CropBox>(&edit))
    askForCrop(*crop, gesture);
  else if (const auto* wipe = std::get_if<WipeTo>(&edit))
    emit wipeEdited(wipe->fraction);
}

void ViewInput::askForCrop(const CropBox& crop, const Gesture& gesture) {
  if (m_facts.shown().comparison.turnedBox)
    emit turnedBoxEdited(crop, gesture);
  else
    emit cropEdited(crop, gesture);
}

void ViewInput::press(const QMouseEvent& event) {
  const OverlaySource source = m_facts.shown();
  if (!source.comparison.scene.volume || m_drag || m_measures->isHolding())
    return;
  const Press press{event.button(), event.modifiers(), event.position()};
  std::optional<CropHandle> handle;
  // Scissors draw over whatever stands above the picture: a corner that is not taken is a line lost.
  if (press.button == Qt::LeftButton && press.modifiers == Qt::NoModifier && m_tool != ViewTool::scissors) {
    if (cubeFaceAt(source, press.point)) {
      m_drag = dragFrom(press, source.comparison, source.geometry, ViewTool::rotate, {});
      if (m_drag)
        m_drag->click = ViewClick::cube;
      return;
    }
    if (const int position = labelAt(source, press.point); position >= 0) {
      emit modelsRequested(position);
      return;
    }
    if (const std::optional<HiddenPlace> place = hiddenNoteAt(source, press.point)) {
      m_hovered.hidden.reset();
      if (place->by == HiddenBy::crop)
        emit cropEdited({}, {nextGestureId(), tr("reset crop")});
      else
        emit everythingRequested();
      return;
    }
    handle = cropHandleAt(source, press.point);
  }
  if (!handle && (drawLine(source, event) || m_measures->press(source, event, kindOf(m_tool).has_value())))
    return;
  m_drag = dragFrom(press, source.comparison, source.geometry, m_tool, handle);
  if (handle)
    m_hovered.face = handle->face;
}

void ViewInput::lookFromFace(const OverlaySource& source, std::size_t face) {
  const CubeFace from = cubeFaces(source.volume())[cubeFaceLedTo(source, face)];
  if (from.view)
    obey(viewcommand::LookFrom{*from.view});
  else
    obey(viewcommand::LookAlong{from.outward, from.up});
}

// What a button that goes down is to the scissors; false where they leave it to others.
bool ViewInput::drawLine(const OverlaySource& source, const QMouseEvent& event) {
  const Qt::KeyboardModifiers others = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
  if (m_tool != ViewTool::scissors || event.button() != Qt::LeftButton || others != Qt::NoModifier)
    return false;
  const QPointF point = event.position();
  if (!m_line) {
    m_line = lineFrom(point, pictureRect(source.geometry, standingAt(source.geometry, point)));
    m_line->removesInside = m_linesRemoveInside;
  } else if (pressLine(*m_line, point)) {
    closeLine();
  }
  return true;
}

void ViewInput::closeLine() {
  const CutLine line = *std::exchange(m_line, std::nullopt);
  if (isArea(line))
    emit lineClosed(polygonOf(line), line.picture.width() / line.picture.height());
}

void ViewInput::move(const QMouseEvent& event) {
  if (m_line && !m_drag)
    return moveLine(*m_line, event.position(), event.modifiers() == Qt::ShiftModifier);
  if (m_measures->move(event.position()))
    return;
  if (!m_drag)
    return hover(event);
  const Gesture gesture = m_drag->gesture;
  ask(editAt(*m_drag, m_facts.shown().comparison.scene, event.position()), gesture);
}

void ViewInput::release(const QMouseEvent& event) {
  if (m_line && m_line->isHeld && event.button() == Qt::LeftButton) {
    if (releaseLine(*m_line, event.position()))
      closeLine();
    return;
  }
  if (m_measures->release(event))
    return;
  if (!m_drag || event.button() != m_drag->button)
    return;
  const ViewClick click = m_drag->click;
  const bool crops = m_drag->kind == DragKind::cropFace;
  m_drag.reset();
  obeyClick(click, event.position());
  if (crops || click == ViewClick::cube)
    hover(event); // handle or face may have left the pointer
}

void ViewInput::obeyClick(ViewClick click, const QPointF& point) {
  const OverlaySource source = m_facts.shown();
  switch (click) {
  case ViewClick::none:
    break;
  case ViewClick::pin:
    if (const std::optional<Probe> probe = probeAt(source, point)) {
      emit pinRequested(probe->value);
      emit placePinned(probe->positionMm);
    }
    break;
  case ViewClick::pick:
    if (const std::optional<Ray> ray = rayUnder(source.geometry, source.comparison.scene.camera, point))
      emit pieceRequested(*ray, sideAt(source, point));
    break;
  case ViewClick::measure:
    m_measures->click(point);
    break;
  case ViewClick::turnAbout:
    if (const std::optional<Ray> ray = rayUnder(source.geometry, source.comparison.scene.camera, point))
      emit turnAboutRequested(*ray, sideAt(source, point));
    break;
  case ViewClick::menu:
    askForMenu(point);
    break;
  case ViewClick::cube:
    if (const std::optional<std::size_t> face = cubeFaceAt(source, point))
      lookFromFace(source, *face);
    break;
  }
}

void ViewInput::askForMenu(const QPointF& point) {
  const OverlaySource source = m_facts.shown();
  if (source.comparison.scene.volume)
    emit menuRequested(rayUnder(source.geometry, source.comparison.scene.camera, point),
                       sideAt(source, point), point.toPoint());
}

// Esc puts back what the drag has changed; the gesture's id lets undo see that nothing is left of it.
void ViewInput::cancelDrag(const Scene& shown) {
  const ViewDrag drag = *m_drag;
  m_drag.reset();
  ask(undone(drag, shown), drag.gesture);
}

void ViewInput::doubleClick(const QMouseEvent& event) {
  const OverlaySource source = m_facts.shown();
  if (event.button() != Qt::LeftButton || !source.comparison.scene.volume)
    return;
  if (m_line)
    return closeLine();
  if (labelAt(source, event.position()) >= 0 || hiddenNoteAt(source, event.position()) ||
      cubeFaceAt(source, event.position()))
    return;
  if (m_tool == ViewTool::scissors || kindOf(m_tool))
    return;
  if (const std::optional<CropHandle> handle = cropHandleAt(source, event.position()))
    uncut(source.comparison, handle->face);
  else if (isOnWipeBorder(source.geometry, event.position()))
    emit wipeEdited(0.5);
  else
    emit maximiseRequested();
}

void ViewInput::uncut(const Comparison& shown, CropFace face) {
  const TurnedBox box = boxOver(shown);
  const CropBox crop = withFaceAt(box.crop, box.grid, face, placeOf(box.fit, face));
  const QString text =
      shown.turnedBox ? tr("turned box: reset %1 face").arg(turnedFaceName(box, *shown.scene.volume, face))
                      : tr("reset crop face: %1").arg(cropFaceName(*shown.scene.volume, face));
  if (crop != box.crop)
    askForCrop(crop, {nextGestureId(), text});
}

void ViewInput::turnWheel(QWheelEvent& event) {
  const OverlaySource source = m_facts.shown();
  const Scene& shown = source.comparison.scene;
  const int turn = event.angleDelta().y();
  event.setAccepted(shown.volume && turn != 0);
  if (!event.isAccepted())
    return;
  const bool isShifted = event.modifiers() == Qt::ShiftModifier;
  if (m_wheelIsForPiece && (isShifted || event.modifiers() == Qt::NoModifier)) {
    emit pieceNarrowed(static_cast<double>(turn) / wheelNotch, isShifted);
    return;
  }
  const QRectF side = pictureRect(source.geometry, positionAt(source.geometry, event.position()));
  emit cameraEdited(wheelZoomed(shown.camera, turn, event.position(), side),
                    m_runs.idOf(ofTheWheel, event.timestamp()));
}

void ViewInput::hover(const QMouseEvent& event) {
  const OverlaySource source = m_facts.shown();
  if (!source.comparison.scene.volume)
    return;
  const QPointF point = event.position();
  Hovered now;
  const bool draws = m_tool == ViewTool::scissors;
  if (!draws) {
    now.cubeFace = cubeFaceAt(source, point);
    now.label = labelAt(source, point);
    if (now.label < 0)
      now.hidden = hiddenNoteAt(source, point);
  }
  const bool isOnText = now.label >= 0 || now.hidden || now.cubeFace;
  const std::optional<CropHandle> handle = isOnText || draws ? std::nullopt : cropHandleAt(source, point);
  if (handle)
    now.face = handle->face;
  now.measure = !isOnText && !handle && !draws && measureHandleUnder(source, point);
  now.wipe = !isOnText && !handle && !draws && !now.measure && isOnWipeBorder(source.geometry, point);
  if (now != m_hovered) {
    m_hovered = now;
    showCursor(handle);
  }
  m_view->setToolTip(toolTipAt(source, point));
  const bool isProbing = event.modifiers() == Qt::ShiftModifier && event.buttons() == Qt::NoButton;
  showProbe(isProbing ? probeAt(source, point) : std::nullopt, source, point);
  if (const auto ray = rayUnder(source.geometry, source.comparison.scene.camera, point); ray && isProbing)
    emit rayRead(*ray, sideAt(source, point));
}

std::optional<Probe> ViewInput::probeAt(const OverlaySource& source, const QPointF& point) const {
  const Comparison& comparison = source.comparison;
  const std::optional<Ray> ray = rayUnder(source.geometry, comparison.scene.camera, point);
  if (!ray)
    return std::nullopt;
  const int side = sideAt(source, point);
  return probeAlong(sceneOfSide(comparison, side), m_facts.scaleOfSide(side), *ray);
}

void ViewInput::showProbe(const std::optional<Probe>& probe, const OverlaySource& source,
                          const QPointF& point) {
  if (!probe)
    return stopReading();
  const Scene scene = sceneOfSide(source.comparison, sideAt(source, point));
  m_read = ReadValue{probe->value, point,
                     labelReading(scene.keep, scene.transferFunction, probe->index, probe->value)};
  emit probed(probe);
}

void ViewInput::stopReading() {
  if (m_read) {
    m_read.reset();
    emit probed(std::nullopt);
  }
}

void ViewInput::leave() {
  stopReading();
  m_hovered = {};
  showCursor(std::nullopt);
}

bool ViewInput::obey(const ViewCommand& command, std::optional<std::uint64_t> timestampMs) {
  using namespace viewcommand;
  const OverlaySource source = m_facts.shown();
  const Scene& shown = source.comparison.scene;
  if (!shown.volume)
    return false;
  const ViewFrame frame{m_facts.visible, pictureAspect(source.geometry), source.comparison.turnsAboutMm};
  if (std::holds_alternative<Reset>(command))
    emit cameraReset();
  if (const auto camera = cameraAfter(command, shown.camera, *shown.volume, frame))
    emit cameraEdited(*camera, timestampMs && isRepeatable(command)
                                   ? m_runs.idOf(static_cast<int>(command.index()), *timestampMs)
                                   : nextGestureId());
  else if (const auto* use = std::get_if<UseTool>(&command))
    setTool(use->tool);
  else if (const auto* preset = std::get_if<WindowPreset>(&command))
    emit windowPresetRequested(preset->number);
  else if (std::holds_alternative<Swap>(command))
    emit swapRequested();
  else if (std::holds_alternative<CloseLine>(command) && m_line)
    closeLine();
  else if (std::holds_alternative<ShortenLine>(command) && m_line) {
    if (!shortenLine(*m_line))
      m_line.reset();
  } else if ((std::holds_alternative<Cancel>(command) || std::holds_alternative<Remove>(command)) && m_line)
    m_line.reset();
  else if (std::holds_alternative<ShortenLine>(command))
    m_measures->drop();
  else if (std::holds_alternative<Remove>(command))
    m_measures->remove();
  else if (std::holds_alternative<Cancel>(command) && m_measures->cancel())
    return true;
  else if (std::holds_alternative<Cancel>(command) && m_drag)
    cancelDrag(shown);
  else if (std::holds_alternative<Cancel>(command) && m_tool != ViewTool::rotate)
    setTool(ViewTool::rotate);
  else
    return false;
  return true;
}

} // namespace limn
