// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/sliders/AccessibleTrack.h"

#include "widgets/controls/sliders/TrackSlider.h"

#include <QAccessibleWidget>
#include <QPointer>

#include <array>
#include <cmath>

namespace limn {
namespace {

constexpr int handleSize = 16; // pixels

bool isRange(const TrackSlider& slider) {
  return slider.values().size() > 1;
}

class HandleValue : public QAccessibleValueInterface {
public:
  HandleValue(TrackSlider& slider, int handle) : m_slider(slider), m_handle(handle) {}

  QVariant currentValue() const override { return at(m_handle); }
  QVariant minimumValue() const override { return m_slider.reachOf(m_handle).lowest; }
  QVariant maximumValue() const override { return m_slider.reachOf(m_handle).highest; }
  QVariant minimumStepSize() const override { return m_slider.keyStepOf(m_handle); }

  void setCurrentValue(const QVariant& value) override {
    const double wanted = value.toDouble();
    if (m_slider.isEnabled() && std::isfinite(wanted))
      m_slider.moveHandle(m_handle, wanted);
  }

private:
  double at(int handle) const { return m_slider.values()[static_cast<std::size_t>(handle)]; }

  TrackSlider& m_slider;
  int m_handle;
};

/// One handle of a range. Like the cells of Qt's tables it is no object of its own.
class AccessibleHandle : public QAccessibleInterface, public QAccessibleActionInterface {
public:
  AccessibleHandle(TrackSlider& slider, int handle)
      : m_slider(&slider), m_handle(handle), m_value(slider, handle) {}

  bool isValid() const override { return m_slider != nullptr; }
  QObject* object() const override { return nullptr; }
  QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(m_slider); }
  QWindow* window() const override { return parent()->window(); }
  QAccessibleInterface* child(int) const override { return nullptr; }
  QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  int childCount() const override { return 0; }
  int indexOfChild(const QAccessibleInterface*) const override { return -1; }
  QAccessible::Role role() const override { return QAccessible::Slider; }

  QString text(QAccessible::Text text) const override {
    return text == QAccessible::Name ? m_slider->handleNames().value(m_handle) : parent()->text(text);
  }
  void setText(QAccessible::Text, const QString&) override {}

  QRect rect() const override {
    QRect place(0, 0, handleSize, handleSize);
    place.moveCenter(m_slider->mapToGlobal(m_slider->handleCentre(m_handle)).toPoint());
    return place;
  }

  QAccessible::State state() const override {
    QAccessible::State state = parent()->state();
    state.focusable = true;
    state.focused = m_slider->hasFocus() && m_slider->activeHandle() == m_handle;
    return state;
  }

  QStringList actionNames() const override { return {setFocusAction()}; }
  QStringList keyBindingsForAction(const QString&) const override { return {}; }
  void doAction(const QString& name) override {
    if (name == setFocusAction() && m_slider->isEnabled())
      m_slider->focusHandle(m_handle);
  }

  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface)
      return static_cast<QAccessibleValueInterface*>(&m_value);
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
  }

private:
  QPointer<TrackSlider> m_slider;
  int m_handle;
  HandleValue m_value;
};

class AccessibleTrack : public QAccessibleWidget {
public:
  explicit AccessibleTrack(TrackSlider& slider)
      : QAccessibleWidget(&slider, isRange(slider) ? QAccessible::Grouping : QAccessible::Slider),
        m_slider(slider), m_value(slider, 0) {
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

  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    if (isRange(m_slider))
      state.focusable = state.focused = false; // its handles are
    return state;
  }

  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface && !isRange(m_slider))
      return static_cast<QAccessibleValueInterface*>(&m_value);
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
  HandleValue m_value; ///< of the only handle
  std::array<QAccessible::Id, 2> m_handles{};
};

QAccessibleInterface* accessibleTrack(const QString&, QObject* object) {
  auto* slider = qobject_cast<TrackSlider*>(object);
  return slider ? new AccessibleTrack(*slider) : nullptr;
}

} // namespace

void makeTracksAccessible() {
  QAccessible::installFactory(accessibleTrack); // once, however often it is asked for
}

void tellValue(TrackSlider& slider, int handle) {
  QAccessibleValueChangeEvent event(&slider, slider.values()[static_cast<std::size_t>(handle)]);
  if (isRange(slider))
    event.setChild(handle);
  QAccessible::updateAccessibility(&event);
}

void tellFocus(TrackSlider& slider) {
  if (!slider.hasFocus() || !isRange(slider))
    return;
  QAccessibleEvent event(&slider, QAccessible::Focus);
  event.setChild(slider.activeHandle());
  QAccessible::updateAccessibility(&event);
}

} // namespace limn
