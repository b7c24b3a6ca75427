// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CompareView.h"

#include "scene/FirstView.h"
#include "scene/ModelName.h"
#include "widgets/scene/ProjectionSection.h"
#include "widgets/shading/ModelName.h"
#include "widgets/view/CropBoxPainting.h"
#include "widgets/view/SideText.h"
#include "widgets/view/WindowLevelGesture.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QEnterEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <numbers>

// Mouse and keys of the compare view.

namespace limn {
namespace {

constexpr double wipeGrip = 12.0;  // logical pixels to each side of the border
constexpr double clickSlack = 3.0; // a click may tremble by this much
constexpr double keyTurnDeg = 5.0; // of an arrow key
constexpr int wheelNotch = 120;

double lengthOf(const QPointF& vector) {
  return std::hypot(vector.x(), vector.y());
}

} // namespace

void CompareView::lookFrom(StandardView view) {
  if (!m_scene.volume)
    return;
  const Grid& grid = m_scene.volume->grid();
  emit cameraEdited(framed(standardView(m_scene.camera, grid, view), grid, pictureAspect()));
}

void CompareView::resetCamera() {
  if (!m_scene.volume)
    return;
  const Grid& grid = m_scene.volume->grid();
  emit cameraEdited(framed(firstView(m_scene.camera, grid), grid, pictureAspect()));
}

int CompareView::positionAt(const QPointF& point) const {
  const glm::ivec2 size = deviceSize();
  return pictureAt(m_layout, size, m_wipe, point.x() * devicePixelRatioF());
}

bool CompareView::onWipeBorder(const QPointF& point) const {
  return m_layout == CompareLayout::wipe && std::abs(point.x() - m_wipe * width()) <= wipeGrip;
}

int CompareView::labelAt(const QPointF& point) const {
  if (!usesLight(m_scene.projection))
    return -1; // there is no model to choose
  for (int position = 0; position < pictureCount(m_layout); ++position)
    if (labelRect(position).contains(point))
      return position;
  return -1;
}

void CompareView::mousePressEvent(QMouseEvent* event) {
  if (!m_scene.volume || m_drag)
    return;
  const QPointF point = event->position();
  if (event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier) {
    if (const int position = labelAt(point); position >= 0)
      return popUpModels(position);
    if (beginCropDrag(*event))
      return;
  }
  beginDrag(event);
}

void CompareView::beginDrag(QMouseEvent* event) {
  Drag drag;
  drag.button = event->button();
  drag.first = drag.last = event->position();
  drag.side = logicalRect(pictureUnder(drag.first));
  drag.wipe = event->button() == Qt::LeftButton && onWipeBorder(drag.first);
  drag.kind = drag.wipe ? DragKind::none : dragKind(event->button(), event->modifiers(), m_tool);
  drag.mayPin = event->button() == Qt::LeftButton && event->modifiers() == Qt::ShiftModifier;
  drag.camera = m_scene.camera;
  drag.function = m_scene.transferFunction;
  const bool opacity = drag.kind == DragKind::opacity;
  drag.gesture = {nextGestureId(), opacity ? tr("change opacity") : tr("change window and level")};
  m_drag = drag;
}

void CompareView::mouseMoveEvent(QMouseEvent* event) {
  wakeLabels();
  if (m_drag)
    continueDrag(event);
  else
    hover(event);
}

void CompareView::continueDrag(QMouseEvent* event) {
  const QPointF point = event->position();
  Drag& drag = *m_drag;
  if (drag.wipe) {
    setWipePosition(point.x() / std::max(1, width()));
    emit wipeMoved(m_wipe);
    return;
  }
  if (drag.face)
    return dragCrop(point);
  if (drag.mayPin && lengthOf(point - drag.first) <= clickSlack)
    return;
  drag.mayPin = false;
  if (drag.kind == DragKind::windowLevel || drag.kind == DragKind::opacity)
    return dragWindowLevel(point);
  const Camera camera = dragged(m_scene.camera, drag.kind, drag.last, point, drag.side);
  drag.last = point;
  if (camera != m_scene.camera)
    emit cameraEdited(camera);
}

void CompareView::dragWindowLevel(const QPointF& to) {
  const Drag& drag = *m_drag;
  const QPointF moved = to - drag.first;
  const TransferFunction function = drag.kind == DragKind::opacity
                                        ? opacityDragged(drag.function, moved)
                                        : windowLevelDragged(drag.function, m_scene.volume->range(), moved);
  if (function != m_scene.transferFunction)
    emit windowLevelEdited(function, drag.gesture);
}

void CompareView::mouseReleaseEvent(QMouseEvent* event) {
  if (!m_drag || event->button() != m_drag->button)
    return;
  const bool pin = m_drag->mayPin;
  const bool crop = m_drag->face.has_value();
  m_drag.reset();
  if (crop)
    hover(event); // its handle may have left the pointer
  if (!pin)
    return;
  if (const std::optional<Probe> probe = probeAt(event->position()))
    emit pinRequested(probe->value);
}

// Esc puts back what the drag has changed; the gesture's id lets undo see that nothing is left of it.
void CompareView::cancelDrag() {
  if (!m_drag)
    return;
  const Drag drag = *m_drag;
  m_drag.reset();
  if (drag.wipe) {
    setWipePosition(drag.first.x() / std::max(1, width()));
    emit wipeMoved(m_wipe);
  } else if (drag.kind == DragKind::windowLevel || drag.kind == DragKind::opacity) {
    if (drag.function != m_scene.transferFunction)
      emit windowLevelEdited(drag.function, drag.gesture);
  } else if (drag.face) {
    if (drag.crop != m_scene.crop)
      emit cropEdited(drag.crop, drag.gesture);
    update();
  } else if (drag.camera != m_scene.camera) {
    emit cameraEdited(drag.camera);
  }
}

void CompareView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_scene.volume || labelAt(event->position()) >= 0)
    return;
  if (const std::optional<CropHandle> handle = cropHandleAt(event->position())) {
    resetFace(handle->face);
  } else if (onWipeBorder(event->position())) {
    setWipePosition(0.5);
    emit wipeMoved(m_wipe);
  } else {
    emit maximiseRequested();
  }
}

void CompareView::wheelEvent(QWheelEvent* event) {
  if (!m_scene.volume || event->angleDelta().y() == 0)
    return event->ignore();
  emit cameraEdited(wheelZoomed(m_scene.camera, event->angleDelta().y()));
  event->accept();
}

void CompareView::hover(QMouseEvent* event) {
  if (!m_scene.volume)
    return;
  const QPointF point = event->position();
  const int label = labelAt(point);
  const std::optional<CropHandle> handle = label < 0 ? cropHandleAt(point) : std::nullopt;
  const std::optional<CropFace> face = handle ? std::optional(handle->face) : std::nullopt;
  const bool border = label < 0 && !handle && onWipeBorder(point);
  if (label != m_hoveredLabel || border != m_wipeHovered || face != m_hoveredFace) {
    m_hoveredLabel = label;
    m_wipeHovered = border;
    m_hoveredFace = face;
    setCursor(label >= 0 ? Qt::PointingHandCursor
              : handle   ? cursorFor(*handle)
              : border   ? Qt::SplitHCursor
                         : Qt::ArrowCursor);
    update();
  }
  // Only over the title: a tool tip anywhere else would cover the picture.
  const bool onTitle = m_layout == CompareLayout::difference &&
                       (differenceTitleRect().contains(point) || differenceNote().plate.contains(point));
  setToolTip(onTitle ? tr("<p>Black where both sides show the same; brighter the more they differ, in the "
                          "colour in which they differ. Differences are shown %1 times as large as they "
                          "are.</p>")
                           .arg(differenceGain)
                     : QString());
  const bool probing = event->modifiers() == Qt::ShiftModifier && event->buttons() == Qt::NoButton;
  showProbe(probing ? probeAt(point) : std::nullopt, point);
}

std::optional<Probe> CompareView::probeAt(const QPointF& point) const {
  const std::vector<PixelRect> places = rects();
  if (places.empty() || !m_scene.volume)
    return std::nullopt;
  const int position = positionAt(point);
  const PixelRect& place = places[position];
  const double ratio = devicePixelRatioF();
  const glm::ivec2 pixel = glm::ivec2(glm::floor(glm::dvec2(point.x(), point.y()) * ratio)) - place.topLeft;
  const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < place.size.x && pixel.y < place.size.y;
  if (!inside)
    return std::nullopt;
  const int side = sideShownAt(position);
  const Scene scene = sceneOfSide(side);
  return probeAlong(scene, gradientScaleOfSide(side),
                    rayThroughPixel(scene.camera, pixel.x, pixel.y, place.size));
}

void CompareView::showProbe(const std::optional<Probe>& probe, const QPointF& point) {
  if (!probe && !m_probe)
    return;
  m_probe = probe;
  m_probePoint = point;
  emit probed(probe);
  update();
}

void CompareView::popUpModels(int position) {
  const int side = sideShownAt(position);
  const ShadingModel current = sceneOfSide(side).shading.model;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const ShadingModel model : shadingModels) {
    QAction* action = menu->addAction(modelName(model));
    action->setCheckable(true);
    action->setChecked(model == current);
    connect(action, &QAction::triggered, this, [this, side, model] { emit modelChosen(side, model); });
  }
  menu->popup(mapToGlobal(labelRect(position).bottomLeft().toPoint()));
}

void CompareView::setSwapped(bool swapped) {
  if (swapped == m_swapped || (swapped && pictureCount(m_layout) < 2))
    return;
  m_swapped = swapped;
  wakeLabels();
  showOtherParts();
}

void CompareView::leaveEvent(QEvent* event) {
  QOpenGLWidget::leaveEvent(event);
  showProbe(std::nullopt, {});
  m_hoveredLabel = -1;
  m_wipeHovered = false;
  m_hoveredFace.reset();
  update();
}

void CompareView::enterEvent(QEnterEvent* event) {
  QOpenGLWidget::enterEvent(event);
  // Keys go to what the pointer is over, but not out of a field in which someone types.
  const QWidget* focused = QApplication::focusWidget();
  const bool isTyping = qobject_cast<const QLineEdit*>(focused) != nullptr ||
                        qobject_cast<const QAbstractSpinBox*>(focused) != nullptr;
  if (isActiveWindow() && !isTyping)
    setFocus(Qt::MouseFocusReason);
}

void CompareView::focusOutEvent(QFocusEvent* event) {
  QOpenGLWidget::focusOutEvent(event);
  setSwapped(false);
}

void CompareView::keyPressEvent(QKeyEvent* event) {
  if (!m_scene.volume || !obey(commandOf(*event)))
    QOpenGLWidget::keyPressEvent(event);
}

void CompareView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Shift)
    showProbe(std::nullopt, {});
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
    setSwapped(false);
  QOpenGLWidget::keyReleaseEvent(event);
}

bool CompareView::obey(const ViewCommand& command) {
  using namespace viewcommand;
  if (const auto* look = std::get_if<LookFrom>(&command)) {
    lookFrom(look->view);
  } else if (std::holds_alternative<LookFromNearest>(command)) {
    lookFrom(nearestStandardView(m_scene.camera));
  } else if (std::holds_alternative<Reset>(command)) {
    resetCamera();
  } else if (const auto* turn = std::get_if<Rotate>(&command)) {
    const double step = keyTurnDeg * std::numbers::pi / 180.0;
    emit cameraEdited(orbited(m_scene.camera, -turn->right * step, -turn->down * step));
  } else if (const auto* zoom = std::get_if<Zoom>(&command)) {
    emit cameraEdited(wheelZoomed(m_scene.camera, zoom->notches * wheelNotch));
  } else if (const auto* use = std::get_if<UseTool>(&command)) {
    setTool(use->tool);
  } else if (const auto* preset = std::get_if<WindowPreset>(&command)) {
    emit windowPresetRequested(preset->number);
  } else if (std::holds_alternative<Swap>(command)) {
    setSwapped(true);
  } else if (std::holds_alternative<Cancel>(command) && m_drag) {
    cancelDrag();
  } else if (std::holds_alternative<ListShortcuts>(command)) {
    emit shortcutListRequested();
  } else {
    return false;
  }
  return true;
}

} // namespace limn
