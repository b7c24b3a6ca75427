// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/AccessibleCanvas.h"

#include "widgets/ValueText.h"
#include "widgets/controls/AccessiblePart.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QAccessibleWidget>
#include <QTimer>

#include <vector>

namespace limn {
namespace {

/// What a point and its opacity share.
class AccessiblePointPart : public AccessiblePart {
public:
  AccessiblePointPart(TransferFunctionCanvas& canvas, std::size_t index)
      : AccessiblePart(canvas), m_canvas(canvas), m_index(index) {}

  /// A point that is gone may still be asked for.
  bool isValid() const override { return AccessiblePart::isValid() && m_index < points().size(); }

  QAccessible::State state() const override {
    QAccessible::State state = AccessiblePart::state();
    state.selectable = true;
    state.selected = contains(m_canvas.selected(), m_index);
    state.offscreen = state.offscreen || !m_canvas.transform().plot.contains(centre());
    return state;
  }

protected:
  QPointF centre() const override { return positionOf(m_canvas.transform(), point()); }
  void takeFocus() override {
    m_canvas.setFocus();
    m_canvas.takeInHand(m_index);
  }

  const std::vector<ControlPoint>& points() const { return m_canvas.transferFunction().points; }
  const ControlPoint& point() const { return points()[m_index]; }
  TransferFunctionCanvas& canvas() const { return m_canvas; }
  std::size_t index() const { return m_index; }

private:
  TransferFunctionCanvas& m_canvas;
  std::size_t m_index;
};

class AccessibleOpacity : public AccessiblePointPart {
public:
  AccessibleOpacity(QAccessibleInterface& point, TransferFunctionCanvas& canvas, std::size_t index)
      : AccessiblePointPart(canvas, index), m_parent(point) {}

  QAccessibleInterface* parent() const override { return &m_parent; }
  QString text(QAccessible::Text text) const override {
    if (text == QAccessible::Name)
      return TransferFunctionCanvas::tr("Opacity of point %1").arg(index() + 1);
    return text == QAccessible::Value ? opacityText(point().opacity) : QString();
  }
  QVariant currentValue() const override { return point().opacity; }
  QVariant minimumValue() const override { return 0.0; }
  QVariant maximumValue() const override { return 1.0; }
  QVariant minimumStepSize() const override { return 0.01; }

protected:
  bool hasFocus() const override { return false; } // its point's
  void setNumber(double number) override { canvas().placePoint(index(), point().value, number); }

private:
  QAccessibleInterface& m_parent;
};

class AccessiblePoint : public AccessiblePointPart {
public:
  AccessiblePoint(TransferFunctionCanvas& canvas, std::size_t index)
      : AccessiblePointPart(canvas, index),
        m_opacity(QAccessible::registerAccessibleInterface(new AccessibleOpacity(*this, canvas, index))) {}

  int childCount() const override { return 1; }
  QAccessibleInterface* child(int index) const override {
    return index == 0 ? QAccessible::accessibleInterface(m_opacity) : nullptr;
  }
  int indexOfChild(const QAccessibleInterface* wanted) const override { return wanted == child(0) ? 0 : -1; }

  QString text(QAccessible::Text text) const override {
    switch (text) {
    case QAccessible::Name:
      return TransferFunctionCanvas::tr("Point %1 of %2").arg(index() + 1).arg(points().size());
    case QAccessible::Value:
      return valueText(point().value, canvas().unit(), canvas().shownDecimals());
    case QAccessible::Description:
      return TransferFunctionCanvas::tr("%1, opacity %2")
          .arg(this->text(QAccessible::Value), opacityText(point().opacity));
    default:
      return {};
    }
  }
  QVariant currentValue() const override { return point().value; }
  QVariant minimumValue() const override { return reachOf(canvas().plot(), index()).lowest; }
  QVariant maximumValue() const override { return reachOf(canvas().plot(), index()).highest; }
  QVariant minimumStepSize() const override { return valueUnit(canvas().plot()); }

protected:
  ~AccessiblePoint() override { QAccessible::deleteAccessibleInterface(m_opacity); }
  bool hasFocus() const override { return canvas().focusedPoint() == index(); }
  void setNumber(double number) override { canvas().placePoint(index(), number, point().opacity); }

private:
  QAccessible::Id m_opacity;
};

void tell(QAccessibleInterface* interface, QAccessible::Event type) {
  QAccessibleEvent event(interface, type);
  QAccessible::updateAccessibility(&event);
}

void tellNumber(QAccessibleInterface* interface) {
  QAccessibleValueChangeEvent event(interface, interface->valueInterface()->currentValue());
  QAccessible::updateAccessibility(&event);
}

class AccessibleCanvas : public QAccessibleWidget {
public:
  explicit AccessibleCanvas(TransferFunctionCanvas& canvas)
      : QAccessibleWidget(&canvas, QAccessible::Canvas), m_canvas(canvas) {}

  int childCount() const override { return static_cast<int>(m_canvas.transferFunction().points.size()); }
  QAccessibleInterface* child(int index) const override {
    if (index < 0 || index >= childCount())
      return nullptr;
    for (std::size_t i = m_points.size(); i <= static_cast<std::size_t>(index); ++i)
      m_points.push_back(QAccessible::registerAccessibleInterface(new AccessiblePoint(m_canvas, i)));
    return QAccessible::accessibleInterface(m_points[static_cast<std::size_t>(index)]);
  }
  int indexOfChild(const QAccessibleInterface* wanted) const override {
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (QAccessible::accessibleInterface(m_points[i]) == wanted)
        return static_cast<int>(i);
    return -1;
  }
  QAccessibleInterface* childAt(int x, int y) const override {
    for (int i = 0; i < childCount(); ++i)
      if (child(i)->rect().contains(x, y))
        return child(i);
    return nullptr;
  }
  QAccessibleInterface* focusChild() const override {
    const auto point = m_canvas.focusedPoint();
    return point ? child(static_cast<int>(*point)) : QAccessibleWidget::focusChild();
  }
  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.focused = state.focused && !m_canvas.focusedPoint();
    return state;
  }

  void tellSince(const std::vector<ControlPoint>& before) {
    const std::vector<ControlPoint>& now = m_canvas.transferFunction().points;
    while (m_points.size() > now.size()) {
      tell(QAccessible::accessibleInterface(m_points.back()), QAccessible::ObjectDestroyed);
      QAccessible::deleteAccessibleInterface(m_points.back());
      m_points.pop_back();
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
      QAccessibleInterface* point = child(static_cast<int>(i));
      if (i >= before.size()) {
        tell(point, QAccessible::ObjectCreated);
        continue;
      }
      if (now.size() != before.size())
        tell(point, QAccessible::NameChanged);
      if (now[i].value != before[i].value)
        tellNumber(point);
      if (now[i].opacity != before[i].opacity)
        tellNumber(point->child(0));
      if (now[i].value != before[i].value || now[i].opacity != before[i].opacity)
        tell(point, QAccessible::DescriptionChanged);
    }
  }

protected:
  ~AccessibleCanvas() override {
    for (const QAccessible::Id point : m_points)
      QAccessible::deleteAccessibleInterface(point);
  }

private:
  TransferFunctionCanvas& m_canvas;
  mutable std::vector<QAccessible::Id> m_points; ///< as many as were asked for
};

QAccessibleInterface* accessibleCanvas(const QString&, QObject* object) {
  auto* canvas = qobject_cast<TransferFunctionCanvas*>(object);
  return canvas ? new AccessibleCanvas(*canvas) : nullptr;
}

} // namespace

void makeCanvasesAccessible() {
  QAccessible::installFactory(accessibleCanvas); // once, however often it is asked for
}

void tellPoints(TransferFunctionCanvas& canvas, const TransferFunction& before) {
  if (!QAccessible::isActive())
    return;
  if (auto* interface = dynamic_cast<AccessibleCanvas*>(QAccessible::queryAccessibleInterface(&canvas)))
    interface->tellSince(before.points);
}

void tellPointFocus(TransferFunctionCanvas& canvas) {
  const auto point = canvas.focusedPoint();
  if (!point || !QAccessible::isActive())
    return;
  QAccessibleEvent event(&canvas, QAccessible::Focus);
  event.setChild(static_cast<int>(*point));
  QAccessible::updateAccessibility(&event);
}

void tellPointFocusSoon(TransferFunctionCanvas& canvas) {
  if (QAccessible::isActive())
    QTimer::singleShot(0, &canvas, [&canvas] { tellPointFocus(canvas); });
}

} // namespace limn
