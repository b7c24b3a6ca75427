// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/AccessiblePlane.h"

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneView.h"

#include <QAccessibleWidget>

#include <cmath>

namespace limn {
namespace {

class AccessiblePlane : public QAccessibleWidget, public QAccessibleValueInterface {
public:
  explicit AccessiblePlane(PlaneView& view) : QAccessibleWidget(&view, QAccessible::Slider), m_view(view) {}

  QString text(QAccessible::Text text) const override {
    return text == QAccessible::Value ? m_view.accessibleDescription() : QAccessibleWidget::text(text);
  }

  void* interface_cast(QAccessible::InterfaceType type) override {
    return type == QAccessible::ValueInterface ? static_cast<QAccessibleValueInterface*>(this)
                                               : QAccessibleWidget::interface_cast(type);
  }

  QVariant currentValue() const override { return hasVolume() ? along(crosshairOf(m_view.content())) : 0.0; }
  QVariant minimumValue() const override { return hasVolume() ? reach().first : 0.0; }
  QVariant maximumValue() const override { return hasVolume() ? reach().last : 0.0; }
  QVariant minimumStepSize() const override { return hasVolume() ? step() : 0.0; }

  void setCurrentValue(const QVariant& value) override {
    const double wanted = value.toDouble();
    if (hasVolume() && std::isfinite(wanted))
      m_view.goOn(static_cast<int>(std::lround((wanted - along(crosshairOf(m_view.content()))) / step())));
  }

private:
  bool hasVolume() const { return m_view.content().volume != nullptr; }
  const Grid& grid() const { return m_view.content().volume->grid(); }
  double along(const glm::dvec3& place) const { return glm::dot(place, axesOf(m_view.plane()).forward); }
  ReachMm reach() const { return reachAlong(grid(), axesOf(m_view.plane()).forward); }
  double step() const { return sliceStepMm(grid(), m_view.plane()); }

  PlaneView& m_view;
};

QAccessibleInterface* planeInterface(const QString&, QObject* object) {
  auto* view = qobject_cast<PlaneView*>(object);
  return view ? new AccessiblePlane(*view) : nullptr;
}

} // namespace

void makePlanesAccessible() {
  QAccessible::installFactory(planeInterface);
}

void tellPlaneMoved(PlaneView& view) {
  if (!QAccessible::isActive())
    return;
  if (QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&view)) {
    QAccessibleValueChangeEvent event(interface, interface->valueInterface()->currentValue());
    QAccessible::updateAccessibility(&event);
  }
}

} // namespace limn
