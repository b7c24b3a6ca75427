// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Icons.h"

#include <QEvent>
#include <QWidget>

#include <functional>
#include <vector>

namespace limn {

/// Keeps icons of actions and buttons in the colours of a window.
class ThemedIcons : public QObject {
public:
  explicit ThemedIcons(QWidget& window) : m_window(window) { window.installEventFilter(this); }

  /// Gives `target`, which lives as long as the window, the icon of this name (widgets/Icons).
  template <class Target>
  void give(Target& target, const QString& icon) {
    m_refreshes.push_back([this, &target, icon] { target.setIcon(themedIcon(icon, m_window.palette())); });
    m_refreshes.back()();
  }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::PaletteChange)
      for (const auto& refresh : m_refreshes)
        refresh();
    return QObject::eventFilter(watched, event);
  }

private:
  QWidget& m_window;
  std::vector<std::function<void()>> m_refreshes;
};

} // namespace limn
