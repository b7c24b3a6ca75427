// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneDeck.h"

#include "widgets/planes/PlaneBar.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/theme/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr int gap = 2; // between places, logical pixels

std::array<QRect, 4> inFour(const QRect& room) {
  const int left = (room.width() - gap) / 2;
  const int top = (room.height() - gap) / 2;
  const QRect first(room.topLeft(), QSize(left, top));
  const int right = room.width() - left - gap;
  const int bottom = room.height() - top - gap;
  return {first, QRect(first.right() + 1 + gap, first.top(), right, top),
          QRect(first.left(), first.bottom() + 1 + gap, left, bottom),
          QRect(first.right() + 1 + gap, first.bottom() + 1 + gap, right, bottom)};
}

// The large one at the left, the others under each other.
std::array<QRect, 4> aroundLarge(PatientPlane large, const QRect& room) {
  const int column = std::max(1, room.width() * 3 / 10);
  const std::size_t chosen = static_cast<std::size_t>(large) + 1;
  std::array<QRect, 4> places;
  places[chosen] = room.adjusted(0, 0, -column - gap, 0);
  int top = room.top();
  int left = 3;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == chosen)
      continue;
    const int height = (room.bottom() + 1 - top - (left - 1) * gap) / left;
    places[i] = QRect(places[chosen].right() + 1 + gap, top, column, height);
    top += height + gap;
    --left;
  }
  return places;
}

} // namespace

std::array<QRect, 4> placesOf(const PlaneSettings& settings, const QRect& room) {
  switch (settings.layout) {
  case PlaneLayout::pictureOnly:
    return {room, {}, {}, {}};
  case PlaneLayout::pictureAndThree:
    return inFour(room);
  case PlaneLayout::oneLarge:
    return aroundLarge(settings.large, room);
  }
  return {};
}

PlaneDeck::PlaneDeck(QWidget& picture, QWidget* parent)
    : QWidget(parent), m_picture(picture), m_bar(new PlaneBar(this)) {
  setObjectName(QStringLiteral("planeDeck"));
  picture.setParent(this);
  for (const PatientPlane plane : patientPlanes) {
    auto* view = m_views[static_cast<std::size_t>(plane)] = new PlaneView(plane, this);
    view->installEventFilter(this);
    connect(view, &PlaneView::settingsEdited, this, &PlaneDeck::settingsEdited);
    connect(view, &PlaneView::measurementsEdited, this, &PlaneDeck::measurementsEdited);
    connect(view, &PlaneView::toolRequested, this, &PlaneDeck::setTool);
    connect(view, &PlaneView::pieceRequested, this, &PlaneDeck::pieceRequested);
    connect(view, &PlaneView::pieceNarrowed, this, &PlaneDeck::pieceNarrowed);
    connect(view, &PlaneView::cornersBegun, this, &PlaneDeck::cornersBegun);
    connect(view, &PlaneView::lineClosed, this,
            [this, plane](const Scissors& scissors) { emit lineClosed(plane, scissors); });
    connect(view, &PlaneView::menuRequested, this,
            [this, plane](const glm::dvec3& mm, const QPoint& at) { emit menuRequested(plane, mm, at); });
  }
  connect(m_bar, &PlaneBar::settingsEdited, this, &PlaneDeck::settingsEdited);
  connect(m_bar, &PlaneBar::measurementsEdited, this, &PlaneDeck::measurementsEdited);
  connect(m_bar, &PlaneBar::toolRequested, this, &PlaneDeck::setTool);
  setContent({});
  arrange();
}

void PlaneDeck::addButton(QAction& action) {
  m_bar->addButton(action);
}

void PlaneDeck::setContent(const PlaneContent& content) {
  const PlaneLayout layout = shownLayout();
  const PatientPlane large = m_content.settings.large;
  m_content = content;
  m_bar->setContent(content);
  for (PlaneView* view : m_views)
    view->setContent(content);
  if (shownLayout() != layout || content.settings.large != large)
    arrange();
}

QSize PlaneDeck::sizeHint() const {
  return m_picture.sizeHint();
}

QSize PlaneDeck::minimumSizeHint() const {
  return m_picture.minimumSizeHint();
}

void PlaneDeck::setTool(PlaneTool tool) {
  m_bar->setTool(tool);
  for (PlaneView* view : m_views)
    view->setTool(tool);
  if (std::exchange(m_tool, tool) != tool)
    emit toolChanged(tool);
}

void PlaneDeck::setLinesRemoveInside(bool isInside) {
  for (PlaneView* view : m_views)
    view->setLinesRemoveInside(isInside);
}

void PlaneDeck::setWheelIsForPiece(bool isForPiece) {
  for (PlaneView* view : m_views)
    view->setWheelIsForPiece(isForPiece);
}

bool PlaneDeck::isDrawing() const {
  return std::ranges::any_of(m_views, &PlaneView::isDrawing);
}

PlaneView* PlaneDeck::drawingView() const {
  const auto drawing = std::ranges::find_if(m_views, &PlaneView::isDrawing);
  return drawing == m_views.end() ? nullptr : *drawing;
}

bool PlaneDeck::endLooseDrag() {
  return std::ranges::any_of(m_views, &PlaneView::endLooseDrag); // one is drawn at a time
}

// A measurement that waits for its next click is over once the left button has to do in another slice, and
// the keys that take it back find it from there, too: the pointer has led the keyboard along.
bool PlaneDeck::eventFilter(QObject* watched, QEvent* event) {
  PlaneView* drawing = drawingView();
  if (!drawing || drawing == watched)
    return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::MouseButtonPress &&
      static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
    drawing->endLooseDrag();
  if (event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool takesBack = key == Qt::Key_Escape || key == Qt::Key_Delete || key == Qt::Key_Backspace;
  return (takesBack && drawing->endLooseDrag()) || QWidget::eventFilter(watched, event);
}

PlaneLayout PlaneDeck::shownLayout() const {
  return m_content.volume ? m_content.settings.layout : PlaneLayout::pictureOnly;
}

void PlaneDeck::arrange() {
  QRect room = rect();
  PlaneSettings shown = m_content.settings;
  shown.layout = shownLayout();
  const bool hasSlices = shown.layout != PlaneLayout::pictureOnly;
  m_bar->setVisible(hasSlices);
  if (hasSlices) {
    m_bar->setGeometry(0, 0, width(), m_bar->heightAt(width()));
    room.setTop(m_bar->height());
  }
  const std::array<QRect, 4> places = placesOf(shown, room);
  m_picture.setGeometry(places[0]);
  for (std::size_t i = 0; i < m_views.size(); ++i) {
    m_views[i]->setGeometry(places[i + 1]);
    m_views[i]->setVisible(!places[i + 1].isEmpty());
    if (m_views[i]->isHidden())
      m_views[i]->endLooseDrag();
  }
}

void PlaneDeck::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

// Of keys that the picture, or the row above the slices, leaves: tools of slices are taken from there, too.
void PlaneDeck::keyPressEvent(QKeyEvent* event) {
  const Qt::KeyboardModifiers others = event->modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
  const std::optional<PlaneTool> tool = toolOfKey(event->key());
  if (!m_content.volume || others != Qt::NoModifier || !tool)
    return QWidget::keyPressEvent(event);
  setTool(*tool);
}

// What shows between the places.
void PlaneDeck::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(rect(), themeColors(palette()).border);
}

} // namespace limn
