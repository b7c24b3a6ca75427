// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"

#include <QObject>

#include <array>
#include <vector>

class QAction;
class QActionGroup;
class QMenu;
class QToolBar;
class QToolButton;

namespace limn {

/// The models of the pictures: a menu and a button of the tool bar for each side, which name the model that
/// is shown and change it. Of a single picture there is one of each.
class ModelMenus : public QObject {
  Q_OBJECT

public:
  /// `models` are the choices of the two sides; the menus are entries of `menu`.
  ModelMenus(const std::array<QActionGroup*, 2>& models, QMenu& menu);

  void addTo(QToolBar& bar);

  /// The models in the pictures on screen, from left to right: one or two.
  void show(const std::vector<ShadingModel>& models);

private:
  struct Side {
    QActionGroup* group = nullptr;
    QMenu* menu = nullptr;
    QToolButton* button = nullptr;
    QAction* place = nullptr; ///< of the button in the tool bar
  };
  std::array<Side, 2> m_sides;
};

} // namespace limn
