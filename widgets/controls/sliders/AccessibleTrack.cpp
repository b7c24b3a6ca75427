// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/sliders/AccessibleTrack.h"

#include "widgets/controls/AccessiblePart.h"
#include "widgets/controls/sliders/TrackSlider.h"

#include <QAccessibleWidget>

#include <array>

namespace limn {
namespace {

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
