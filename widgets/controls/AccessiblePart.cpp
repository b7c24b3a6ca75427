// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/AccessiblePart.h"

#include <cmath>

namespace limn {
namespace {

constexpr int partSize = 16; // pixels

} // namespace

QWindow* AccessiblePart::window() const {
  QAccessibleInterface* owner = QAccessible::queryAccessibleInterface(m_owner);
  return owner ? owner->window() : nullptr;
}

QRect AccessiblePart::rect() const {
  QRect place(0, 0, partSize, partSize);
  place.moveCenter(m_owner->mapToGlobal(centre()).toPoint());
  return place;
}

QAccessible::State AccessiblePart::state() const {
  QAccessible::State state = QAccessible::queryAccessibleInterface(m_owner)->state();
  state.focusable = true;
  state.focused = hasFocus();
  return state;
}

void AccessiblePart::doAction(const QString& name) {
  if (name != setFocusAction() || !m_owner->isEnabled())
    return;
  m_owner->activateWindow(); // or keys would go elsewhere
  takeFocus();
}

void AccessiblePart::setCurrentValue(const QVariant& value) {
  const double wanted = value.toDouble();
  if (m_owner->isEnabled() && std::isfinite(wanted))
    setNumber(wanted);
}

void* AccessiblePart::interface_cast(QAccessible::InterfaceType type) {
  if (type == QAccessible::ValueInterface)
    return static_cast<QAccessibleValueInterface*>(this);
  return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
}

} // namespace limn
