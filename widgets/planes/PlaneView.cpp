// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneView.h"

#include "planes/GreyWindows.h"
#include "scene/presets/PresetFit.h"
#include "widgets/planes/AccessiblePlane.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneCut.h"
#include "widgets/planes/PlaneMeasures.h"
#include "widgets/planes/PlaneOverlay.h"
#include "widgets/view/panels/FocusRing.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <chrono>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr int notch = 120; // of a wheel, in Qt's eighths of a degree
constexpr double zoomStep = 1.15;
constexpr int fastSlices = 10;

// A slice follows the pointer; what takes longer (thick slabs that lie obliquely) is coarse until it rests.
constexpr double mostMovingMs = 16.0;
constexpr int restMs = 150;

std::optional<glm::dvec3> crosshairIn(const PlaneContent& content) {
  return content.volume ? std::optional(crosshairOf(content)) : std::nullopt;
}

} // namespace

PlaneView::PlaneView(PatientPlane plane, QWidget* parent) : QWidget(parent), m_plane(plane) {
  setObjectName(QStringLiteral("plane-") + QLatin1String(nameOf(plane)));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  makePlanesAccessible();
  new FocusRing(this);
  new PointerFocus(this);
  m_rest.setSingleShot(true);
  m_rest.setInterval(restMs);
  connect(&m_rest, &QTimer::timeout, this, &PlaneView::readAllPixels);
}

// Of what is shown no longer they are of no use, and what there is no memory for stays as coarse as it is.
void PlaneView::readAllPixels() {
  if (!m_content.volume)
    return;
  const PlaneReading wanted = readingOf(m_content, frame().grid);
  if (m_reading.isRunning() && wanted == m_beingRead)
    return;
  m_beingRead = wanted;
  m_reading.start([this, wanted](const Effort& effort) -> BackgroundWork::Deliver {
    const auto begin = std::chrono::steady_clock::now();
    PlaneImage values =
        reformatted(*wanted.volume, wanted.plane, wanted.sampling, {0, effort.isCancelled, {}});
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
    return [this, wanted, values = std::move(values), ms = taken.count()] {
      if (!m_content.volume || wanted != readingOf(m_content, frame().grid))
        return;
      m_pictures.take(wanted, values, ms);
      update();
    };
  });
}

void PlaneView::setContent(const PlaneContent& content) {
  if (content == m_content)
    return;
  if (content.volume != m_content.volume) {
    m_pictures.forget();
    m_zoom.reset();
    m_drag.reset();
  }
  // An angle without its end may have been undone, or left for another measurement.
  if (m_drag && m_drag->isLoose &&
      (content.measured.size() <= m_drag->handle.number || content.inHand != m_drag->handle.number))
    m_drag.reset();
  // A line would go around other things in another slice.
  if (content.volume != m_content.volume || crosshairIn(content) != crosshairIn(m_content))
    forgetLine();
  m_beingRead = {};
  m_content = content;
  describe();
  look();
  if (m_drag && m_drag->isLoose &&
      !isInSlice(content, m_plane, content.measured[m_drag->handle.number].measurement))
    endLooseDrag(); // its slice is left
}

// At something else, or from elsewhere.
void PlaneView::look() {
  m_reading.cancel();
  update();
}

void PlaneView::setTool(PlaneTool tool) {
  endLooseDrag();
  forgetLine();
  m_tool = tool;
  showCursor(mapFromGlobal(QCursor::pos()));
}

PlaneFrame PlaneView::frame() const {
  return planeFrame(seenGrid(m_content), m_plane, crosshairOf(m_content), size(), devicePixelRatioF(),
                    m_zoom);
}

void PlaneView::goOn(int slices) {
  if (m_content.volume)
    emit settingsEdited(withCrosshairMoved(m_content, axesOf(m_plane).forward, slices));
}

// What assistive technology reads beside the name.
void PlaneView::describe() {
  if (!m_content.volume) {
    setAccessibleName({});
    return;
  }
  setAccessibleName(tr("%1 slice").arg(planeTitle(*m_content.volume, m_plane)));
  const QString place = slicePlaceText(m_content, m_plane);
  const QString value = crosshairText(m_content);
  const QString description = value.isEmpty() ? place : tr("%1, %2 under the crosshair").arg(place, value);
  if (description == accessibleDescription())
    return;
  setAccessibleDescription(description);
  tellPlaneMoved(*this);
}

bool PlaneView::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || !m_content.volume)
    return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const PlaneOverlay overlay = planeOverlay(m_content, m_plane, frame(), size(), font());
  QString tip = planeToolTip(overlay, m_content, help->pos());
  if (tip.isEmpty() && isOnKeptLine(help->pos()))
    tip = tr("<p>The orange line is the edge of what is kept: the rest is hidden or faded.</p>");
  QToolTip::showText(help->globalPos(), tip, this);
  return true;
}

bool PlaneView::isOnKeptLine(const QPoint& point) const {
  const double scale = frame().pixelRatio / m_pictures.coarseness(m_content, frame().grid, mostMovingMs);
  const glm::ivec2 pixel(scale * (point.x() + 0.5), scale * (point.y() + 0.5));
  return m_pictures.hasKeptLineNear(pixel, static_cast<int>(std::lround(2.0 * scale)));
}

void PlaneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!m_content.volume)
    return;
  const PlaneFrame shown = frame();
  const int coarseness = m_pictures.coarseness(m_content, shown.grid, mostMovingMs);
  if (coarseness > 1)
    m_rest.start();
  const int linePixels = std::max(1, static_cast<int>(std::lround(shown.pixelRatio / coarseness)));
  const QImage& picture = m_pictures.picture(m_content, coarser(shown.grid, coarseness), linePixels);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, coarseness > 1);
  painter.drawImage(QRectF({0.0, 0.0}, QSizeF(picture.size()) * coarseness / shown.pixelRatio), picture);
  paintPlaneOverlay(painter, planeOverlay(m_content, m_plane, shown, size(), font()));
  if (m_line)
    paintCutLine(painter, *m_line);
}

void PlaneView::mousePressEvent(QMouseEvent* event) {
  if (pressCut(*event))
    return;
  if (m_drag && m_drag->isLoose && event->button() == Qt::LeftButton) {
    m_drag->isLoose = false; // the release ends it
    emit measurementsEdited(measuredAfter(*m_drag, event->position()));
    return;
  }
  if (!m_content.volume || m_drag)
    return;
  m_drag =
      dragFrom({m_plane, m_tool, event->button(), event->modifiers(), event->position()}, m_content, frame());
  if (!m_drag)
    return;
  if (m_drag->kind == PlaneDrag::Kind::crosshair)
    emit settingsEdited(*settingsAfter(*m_drag, event->position()));
  else if (m_drag->kind == PlaneDrag::Kind::measure && !m_drag->isNew) // taken in hand, and not moved yet
    emit measurementsEdited({m_drag->measurements, m_drag->handle.number, m_drag->gesture});
}

// What a button that goes down is to a tool that cuts; false where it leaves it to others.
bool PlaneView::pressCut(const QMouseEvent& event) {
  const Qt::KeyboardModifiers others = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
  if (!m_content.volume || m_drag || event.button() != Qt::LeftButton || others != Qt::NoModifier)
    return false;
  if (m_tool == PlaneTool::piece && !(event.modifiers() & Qt::ShiftModifier)) {
    emit pieceRequested(worldAt(frame(), event.position()));
    return true;
  }
  if (m_tool != PlaneTool::scissors)
    return false;
  if (!m_line) {
    m_line = lineFrom(event.position(), rect());
    m_line->removesInside = m_linesRemoveInside;
  } else if (pressLine(*m_line, event.position())) {
    closeLine();
  }
  update();
  return true;
}

void PlaneView::closeLine() {
  const CutLine line = *m_line;
  forgetLine();
  if (isArea(line))
    emit lineClosed(scissorsOn(m_content, frame(), line, m_linesRemoveInside));
}

void PlaneView::forgetLine() {
  if (!m_line)
    return;
  update();
  if (std::exchange(m_line, std::nullopt)->isByClicks)
    emit cornersBegun(false);
}

bool PlaneView::obeyInLine(int key) {
  if (!m_line)
    return false;
  if (key == Qt::Key_Return || key == Qt::Key_Enter)
    closeLine();
  else if (key == Qt::Key_Escape || key == Qt::Key_Delete ||
           (key == Qt::Key_Backspace && !shortenLine(*m_line)))
    forgetLine();
  else if (key != Qt::Key_Backspace)
    return false;
  update();
  return true;
}

void PlaneView::mouseMoveEvent(QMouseEvent* event) {
  if (m_line && !m_drag) {
    moveLine(*m_line, event->position(), event->modifiers() == Qt::ShiftModifier);
    return update();
  }
  if (!m_drag)
    return showCursor(event->position());
  if (m_drag->kind == PlaneDrag::Kind::measure) {
    if (m_drag->isLoose)
      m_drag->frame = frame(); // the view may have another size by now
    emit measurementsEdited(measuredAfter(*m_drag, event->position()));
    return;
  }
  if (const auto settings = settingsAfter(*m_drag, event->position())) {
    emit settingsEdited(*settings);
    return;
  }
  m_zoom = pannedBy(m_drag->frame, event->position() - m_drag->press);
  forgetLine();
  look();
}

void PlaneView::mouseReleaseEvent(QMouseEvent* event) {
  if (m_line && m_line->isHeld && event->button() == Qt::LeftButton) {
    const bool hadCorners = m_line->isByClicks;
    if (releaseLine(*m_line, event->position()))
      closeLine();
    else if (!hadCorners)
      emit cornersBegun(true);
    return update();
  }
  if (!m_drag || m_drag->isLoose || event->button() != m_drag->button)
    return;
  const PlaneDrag drag = *m_drag;
  if (drag.button == Qt::RightButton && QLineF(drag.press, event->position()).length() < shortestDrag) {
    m_drag.reset();
    emit settingsEdited(drag.before);
    emit menuRequested(worldAt(drag.frame, drag.press), event->globalPosition().toPoint());
    return;
  }
  if (m_drag->kind != PlaneDrag::Kind::measure || releaseMeasure(event->position()))
    m_drag.reset();
}

// Whether the drag ends with it.
bool PlaneView::releaseMeasure(const QPointF& point) {
  if (m_drag->isNew)
    emit measurementsEdited(measuredAtRelease(*m_drag, point));
  return !m_drag || !m_drag->isLoose;
}

bool PlaneView::endLooseDrag() {
  if (!m_drag || !m_drag->isLoose)
    return false;
  const PlaneDrag drag = *std::exchange(m_drag, std::nullopt);
  const std::vector<Measured>& now = m_content.measured;
  if (drag.handle.place == 2 && drag.handle.number < now.size() &&
      angleDegrees(now[drag.handle.number].measurement)) {
    emit measurementsEdited({measurementsOf(now), m_content.inHand, drag.gesture}); // it is over
    return false;
  }
  emit measurementsEdited(measuredBefore(drag));
  return true;
}

void PlaneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (m_line && event->button() == Qt::LeftButton)
    return closeLine();
  if (m_content.volume && event->button() == Qt::LeftButton && !kindOf(m_tool) && !cuts(m_tool))
    emit settingsEdited(withLargeToggled(m_content.settings, m_plane));
}

void PlaneView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (!m_content.volume)
    return;
  endLooseDrag();
  if (event->modifiers() & Qt::ControlModifier)
    return zoom(event->position(), std::pow(zoomStep, event->angleDelta().y() / static_cast<double>(notch)));
  if (m_wheelIsForPiece) {
    emit pieceNarrowed(event->angleDelta().y() / static_cast<double>(notch),
                       event->modifiers() & Qt::ShiftModifier);
    return;
  }
  // Touch pads turn by less than a notch at a time.
  m_turned += event->angleDelta().y();
  const int slices = m_turned / notch;
  m_turned -= slices * notch;
  if (slices != 0)
    goOn(slices);
}

void PlaneView::keyPressEvent(QKeyEvent* event) {
  const bool isPlain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (!m_content.volume || !isPlain || !obey(event->key(), event->modifiers() & Qt::ShiftModifier))
    QWidget::keyPressEvent(event);
}

// A right click asks as its button is let go.
void PlaneView::contextMenuEvent(QContextMenuEvent* event) {
  event->accept();
  if (!m_content.volume || event->reason() != QContextMenuEvent::Keyboard)
    return;
  const glm::dvec3 crosshair = crosshairOf(m_content);
  emit menuRequested(crosshair, mapToGlobal(pointOf(frame(), crosshair).toPoint()));
}

bool PlaneView::obey(int key, bool isFast) {
  if (obeyInLine(key))
    return true;
  if ((key == Qt::Key_Delete || key == Qt::Key_Backspace) && m_drag && m_drag->isLoose) {
    cancel();
    return true;
  }
  const bool isHeld = (key >= Qt::Key_Shift && key <= Qt::Key_ScrollLock) || key == Qt::Key_AltGr;
  if (key != Qt::Key_Escape && !isHeld)
    endLooseDrag();
  if (moveByKey(key, isFast ? fastSlices : 1))
    return true;
  if (const std::optional<PlaneTool> tool = toolOfKey(key)) {
    emit toolRequested(*tool);
    return true;
  }
  switch (key) {
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    zoom(QRectF(rect()).center(), zoomStep);
    return true;
  case Qt::Key_Minus:
    zoom(QRectF(rect()).center(), 1.0 / zoomStep);
    return true;
  case Qt::Key_F:
    m_zoom.reset();
    look();
    return true;
  case Qt::Key_Escape:
    if (!m_drag && m_tool == PlaneTool::crosshair)
      return false; // somebody else may have a use for it
    cancel();
    return true;
  case Qt::Key_0:
  case Qt::Key_1:
  case Qt::Key_2:
  case Qt::Key_3:
  case Qt::Key_4:
    return chooseWindow(key - Qt::Key_0);
  case Qt::Key_Delete:
    if (!m_content.inHand)
      return false;
    emit measurementsEdited(withoutMeasure(m_content.measured, *m_content.inHand, *m_content.volume));
    return true;
  default:
    return false;
  }
}

// 0 is the full range, the others are those of tissues where values are Hounsfield units.
bool PlaneView::chooseWindow(int number) {
  PlaneSettings settings = m_content.settings;
  if (number == 0)
    settings.window = fullWindow(m_content.volume->range());
  else if (looksLikeHounsfield(*m_content.volume))
    settings.window = windowOf(tissueWindows[static_cast<std::size_t>(number) - 1]);
  else
    return false;
  emit settingsEdited(settings);
  return true;
}

bool PlaneView::moveByKey(int key, int slices) {
  const PlaneAxes axes = axesOf(m_plane);
  const auto move = [&](const glm::dvec3& direction) {
    emit settingsEdited(withCrosshairMoved(m_content, direction, slices));
    return true;
  };
  switch (key) {
  case Qt::Key_Left:
    return move(-axes.right);
  case Qt::Key_Right:
    return move(axes.right);
  case Qt::Key_Up:
    return move(-axes.down);
  case Qt::Key_Down:
    return move(axes.down);
  case Qt::Key_PageUp:
    return move(axes.forward);
  case Qt::Key_PageDown:
    return move(-axes.forward);
  case Qt::Key_Home: {
    PlaneSettings settings = m_content.settings;
    settings.crosshairMm.reset();
    emit settingsEdited(settings);
    return true;
  }
  default:
    return false;
  }
}

// Esc puts back what the drag has changed, or returns to the crosshair.
void PlaneView::cancel() {
  if (!m_drag) {
    emit toolRequested(PlaneTool::crosshair);
    return;
  }
  const PlaneDrag drag = *m_drag;
  m_drag.reset();
  if (drag.kind == PlaneDrag::Kind::pan) {
    m_zoom = pannedBy(drag.frame, {});
    look();
  } else if (drag.kind == PlaneDrag::Kind::measure) {
    emit measurementsEdited(measuredBefore(drag));
  } else {
    emit settingsEdited(drag.before);
  }
}

void PlaneView::zoom(const QPointF& about, double factor) {
  forgetLine();
  m_zoom = zoomedAbout(frame(), about, factor);
  look();
}

void PlaneView::showCursor(const QPointF& point) {
  if (m_content.volume && handleTaken(m_content, m_plane, frame(), m_tool, point))
    setCursor(Qt::SizeAllCursor);
  else
    setCursor(m_tool == PlaneTool::windowLevel ? Qt::SizeAllCursor
              : m_tool == PlaneTool::piece     ? Qt::PointingHandCursor
                                               : Qt::CrossCursor);
}

} // namespace limn
