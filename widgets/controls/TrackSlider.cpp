// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/TrackSlider.h"

#include "widgets/Gesture.h"
#include "widgets/ValueText.h"
#include "widgets/controls/AccessiblePart.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/theme/Theme.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace limn {
namespace {

constexpr double handleRadius = 7.0;
constexpr double keyStep = 0.01;
constexpr double pageStep = 0.1;

std::optional<double> fractionAfterKey(int key, double fraction) {
  switch (key) {
  case Qt::Key_Left:
  case Qt::Key_Down:
    return fraction - keyStep;
  case Qt::Key_Right:
  case Qt::Key_Up:
    return fraction + keyStep;
  case Qt::Key_PageDown:
    return fraction - pageStep;
  case Qt::Key_PageUp:
    return fraction + pageStep;
  case Qt::Key_Home:
    return 0.0;
  case Qt::Key_End:
    return 1.0;
  default:
    return std::nullopt;
  }
}

bool isRange(const TrackSlider& slider) {
  return slider.values().size() > 1;
}

class AccessibleHandle : public AccessiblePart {
public:
  AccessibleHandle(TrackSlider& slider, int handle)
      : AccessiblePart(slider), m_slider(slider), m_handle(handle) {}

  QString text(QAccessible::Text text) const override {
    if (text == QAccessible::Name)
      return m_slider.handleNames().value(m_handle);
    return text == QAccessible::Value ? m_slider.readOutOf(m_handle) : parent()->text(text);
  }

  QVariant currentValue() const override { return m_slider.values()[static_cast<std::size_t>(m_handle)]; }
  QVariant minimumValue() const override { return m_slider.reachOf(m_handle).lowest; }
  QVariant maximumValue() const override { return m_slider.reachOf(m_handle).highest; }
  QVariant minimumStepSize() const override { return m_slider.keyStepOf(m_handle); }

protected:
  QPointF centre() const override { return m_slider.handleCentre(m_handle); }
  bool hasFocus() const override { return m_slider.hasFocus() && m_slider.activeHandle() == m_handle; }
  void takeFocus() override { m_slider.focusHandle(m_handle); }
  void setNumber(double number) override { m_slider.moveHandle(m_handle, number); }

private:
  TrackSlider& m_slider;
  int m_handle;
};

class AccessibleTrack : public QAccessibleWidget {
public:
  explicit AccessibleTrack(TrackSlider& slider)
      : QAccessibleWidget(&slider, isRange(slider) ? QAccessible::Grouping : QAccessible::Slider),
        m_slider(slider), m_only(slider, 0) {
    for (int handle = 0; isRange(slider) && handle < 2; ++handle)
      m_handles[static_cast<std::size_t>(handle)] =
          QAccessible::registerAccessibleInterface(new AccessibleHandle(slider, handle));
  }

  int childCount() const override { return isRange(m_slider) ? 2 : 0; }
  QAccessibleInterface* child(int index) const override {
    return index >= 0 && index < childCount()
               ? QAccessible::accessibleInterface(m_handles[static_cast<std::size_t>(index)])
               : nullptr;
  }
  int indexOfChild(const QAccessibleInterface* wanted) const override {
    for (int handle = 0; handle < childCount(); ++handle)
      if (child(handle) == wanted)
        return handle;
    return -1;
  }
  QAccessibleInterface* childAt(int x, int y) const override {
    for (int handle = 0; handle < childCount(); ++handle)
      if (child(handle)->rect().contains(x, y))
        return child(handle);
    return nullptr;
  }
  QAccessibleInterface* focusChild() const override {
    return isRange(m_slider) && m_slider.hasFocus() ? child(m_slider.activeHandle())
                                                    : QAccessibleWidget::focusChild();
  }

  QString text(QAccessible::Text text) const override {
    return text == QAccessible::Value && !isRange(m_slider) ? m_slider.readOutOf(0)
                                                            : QAccessibleWidget::text(text);
  }

  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    if (isRange(m_slider))
      state.focusable = state.focused = false; // its handles are
    return state;
  }

  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface && !isRange(m_slider))
      return static_cast<QAccessibleValueInterface*>(&m_only);
    return QAccessibleWidget::interface_cast(type);
  }

protected:
  ~AccessibleTrack() override {
    for (const QAccessible::Id handle : m_handles)
      if (handle)
        QAccessible::deleteAccessibleInterface(handle);
  }

private:
  TrackSlider& m_slider;
  AccessibleHandle m_only; ///< stands for the track where there is one
  std::array<QAccessible::Id, 2> m_handles{};
};

QAccessibleInterface* accessibleTrack(const QString&, QObject* object) {
  auto* slider = qobject_cast<TrackSlider*>(object);
  return slider ? new AccessibleTrack(*slider) : nullptr;
}

// Makes assistive technology find in every TrackSlider what Qt's sliders are: role, name and value. Of two
// handles it finds a group with a slider each, which ends where the other handle is.
void makeTracksAccessible() {
  QAccessible::installFactory(accessibleTrack); // once, however often it is asked for
}

// Says to assistive technology that a number changed.
void tellValue(TrackSlider& slider, int handle) {
  QAccessibleValueChangeEvent event(&slider, slider.values()[static_cast<std::size_t>(handle)]);
  if (isRange(slider))
    event.setChild(handle);
  QAccessible::updateAccessibility(&event);
}

// Says which of two handles has the focus, where one has it.
void tellFocus(TrackSlider& slider) {
  if (!slider.hasFocus() || !isRange(slider))
    return;
  QAccessibleEvent event(&slider, QAccessible::Focus);
  event.setChild(slider.activeHandle());
  QAccessible::updateAccessibility(&event);
}

} // namespace

TrackSlider::TrackSlider(const SliderScale& scale, int handles, QWidget* parent)
    : QWidget(parent), m_scale(scale), m_values(static_cast<std::size_t>(handles), scale.lowest),
      m_origin(scale.lowest) {
  makeTracksAccessible();
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void TrackSlider::setScale(const SliderScale& scale) {
  if (m_origin == m_scale.lowest)
    m_origin = scale.lowest;
  m_scale = scale;
  update();
}

void TrackSlider::setValues(const std::vector<double>& values) {
  if (values == m_values)
    return;
  const std::vector<double> former = std::exchange(m_values, values);
  update();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] != former[i])
      tellValue(*this, static_cast<int>(i));
}

void TrackSlider::setOrigin(double value) {
  m_origin = value;
  update();
}

QPointF TrackSlider::handleCentre(int handle) const {
  const double fraction = fractionOf(m_scale, m_values[static_cast<std::size_t>(handle)]);
  return {handleRadius + 1.0 + fraction * trackWidth(), height() / 2.0};
}
QSize TrackSlider::minimumSizeHint() const {
  return {60, 20};
}

void TrackSlider::moveHandle(int handle, double value) {
  if (m_dragging)
    return;
  m_active = handle;
  moveActive(value, nextGestureId());
  emit dragEnded();
}

void TrackSlider::focusHandle(int handle) {
  m_active = handle;
  update();
  if (hasFocus())
    tellFocus(*this);
  else
    setFocus();
}

SliderScale TrackSlider::reachOf(int handle) const {
  const auto index = static_cast<std::size_t>(handle);
  SliderScale reach = m_scale;
  if (index > 0) {
    reach.lowest = std::max(reach.lowest, m_values[index - 1]);
    reach.highest = std::max(reach.highest, m_values[index - 1]); // which may lie beyond the scale
  }
  if (index + 1 < m_values.size()) {
    reach.lowest = std::min(reach.lowest, m_values[index + 1]);
    reach.highest = std::min(reach.highest, m_values[index + 1]);
  }
  return reach;
}

double TrackSlider::keyStepOf(int handle) const {
  const double value = m_values[static_cast<std::size_t>(handle)];
  const double fraction = fractionOf(m_scale, value);
  const bool atEnd = fraction + keyStep > 1.0;
  const double next = valueAtFraction(m_scale, atEnd ? fraction - keyStep : fraction + keyStep);
  return std::max(std::abs(next - value), std::pow(10.0, -m_decimals));
}

QString TrackSlider::readOutOf(int handle) const {
  const double value = m_values[static_cast<std::size_t>(handle)];
  return m_readOut ? m_readOut(value) : plainNumber(value, std::min(m_decimals, 6));
}

double TrackSlider::trackWidth() const {
  return std::max(1.0, width() - 2.0 * (handleRadius + 1.0));
}

int TrackSlider::handleAt(double x) const {
  if (m_values.size() == 1)
    return 0;
  const double toFirst = std::abs(x - handleCentre(0).x());
  const double toSecond = std::abs(x - handleCentre(1).x());
  if (toFirst != toSecond)
    return toFirst < toSecond ? 0 : 1;
  // Both on one spot: take the one that can go where the pointer is, or can move at all.
  if (m_values[1] >= m_scale.highest)
    return 0;
  return x < handleCentre(0).x() ? 0 : 1;
}

double TrackSlider::valueUnder(double x) const {
  return valueAtFraction(m_scale, (x - handleRadius - 1.0) / trackWidth());
}

void TrackSlider::moveActive(double value, std::uint64_t gestureId) {
  const auto active = static_cast<std::size_t>(m_active);
  const double unit = std::pow(10.0, m_decimals);
  const SliderScale reach = reachOf(m_active);
  std::vector<double> values = m_values;
  values[active] = std::clamp(std::round(value * unit) / unit, reach.lowest, reach.highest);
  if (values == m_values)
    return;
  setValues(values);
  emit valuesEdited(values, gestureId);
}

void TrackSlider::stepActive(double fraction, std::uint64_t gestureId) {
  const double current = m_values[static_cast<std::size_t>(m_active)];
  const double wanted = valueAtFraction(m_scale, fraction);
  // A step never gets lost in rounding: it is at least one unit of the last digit.
  const double least = std::pow(10.0, -m_decimals);
  const double direction = wanted < current ? -1.0 : 1.0;
  moveActive(current + direction * std::max(std::abs(wanted - current), least), gestureId);
}

void TrackSlider::endDrag() {
  m_dragging = false;
  update();
  emit dragEnded();
}

void TrackSlider::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const double middle = height() / 2.0;
  painter.setBrush(isEnabled() ? colors.outline : colors.border);
  painter.drawRoundedRect(QRectF(handleRadius + 1.0, middle - 2.0, trackWidth(), 4.0), 2.0, 2.0);

  const double originX = handleRadius + 1.0 + fractionOf(m_scale, m_origin) * trackWidth();
  const double from = m_values.size() == 1 ? originX : handleCentre(0).x();
  const double to = handleCentre(static_cast<int>(m_values.size()) - 1).x();
  painter.setBrush(isEnabled() ? colors.accent : colors.border);
  painter.drawRoundedRect(QRectF(QPointF(from, middle - 2.0), QPointF(to, middle + 2.0)).normalized(), 2.0,
                          2.0);

  for (int i = 0; i < static_cast<int>(m_values.size()); ++i) {
    const bool active = hasFocus() && i == m_active;
    painter.setBrush(isEnabled() ? (active ? colors.accent : colors.raised) : colors.window);
    painter.setPen(QPen(isEnabled() ? colors.accent : colors.border, 2.0));
    painter.drawEllipse(handleCentre(i), handleRadius - 1.0, handleRadius - 1.0);
  }
}

void TrackSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return QWidget::mousePressEvent(event);
  const double x = event->position().x();
  m_active = handleAt(x);
  m_dragging = true;
  m_before = m_values;
  m_gestureId = nextGestureId();
  const double handleX = handleCentre(m_active).x();
  const bool onHandle = std::abs(x - handleX) <= handleRadius + 2.0;
  m_dragX = onHandle ? handleX : x;
  m_lastX = x;
  if (!onHandle)
    moveActive(valueUnder(m_dragX), m_gestureId);
  update();
}

void TrackSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!m_dragging)
    return;
  const double travelled = event->position().x() - m_lastX;
  m_lastX = event->position().x();
  m_dragX += event->modifiers() & Qt::ShiftModifier ? travelled / 10.0 : travelled;
  moveActive(valueUnder(m_dragX), m_gestureId);
}

void TrackSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && m_dragging)
    endDrag();
}

void TrackSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && m_dragging) {
    const bool moved = m_values != m_before;
    setValues(m_before);
    if (moved)
      emit valuesEdited(m_before, m_gestureId);
    return endDrag();
  }
  const double fraction = fractionOf(m_scale, m_values[static_cast<std::size_t>(m_active)]);
  const auto next = fractionAfterKey(event->key(), fraction);
  if (!next)
    return QWidget::keyPressEvent(event);
  // A key held down is one gesture.
  if (!event->isAutoRepeat())
    m_gestureId = nextGestureId();
  stepActive(*next, m_gestureId);
  emit dragEnded();
}

void TrackSlider::wheelEvent(QWheelEvent* event) {
  if (!takesWheel(*this) || m_dragging)
    return event->ignore(); // so that scrolling a panel changes nothing on the way
  const double fraction = fractionOf(m_scale, m_values[static_cast<std::size_t>(m_active)]);
  stepActive(fraction + keyStep * event->angleDelta().y() / 120.0, nextGestureId());
  emit dragEnded();
}

void TrackSlider::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  // Behind Qt's own word that the whole slider has the focus.
  if (QAccessible::isActive())
    QTimer::singleShot(0, this, [this] { tellFocus(*this); });
}

bool TrackSlider::focusNextPrevChild(bool next) {
  const int wanted = m_active + (next ? 1 : -1);
  if (wanted < 0 || wanted >= static_cast<int>(m_values.size())) {
    m_active = next ? 0 : static_cast<int>(m_values.size()) - 1;
    return QWidget::focusNextPrevChild(next);
  }
  focusHandle(wanted);
  return true;
}

} // namespace limn
