// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"

#include <QObject>

#include <array>
#include <functional>
#include <vector>

class QAction;
class QActionGroup;
class QMenu;
class QToolButton;

namespace limn {

class ActionList;

/// The models of the pictures: a menu and a button of the tool bar for each side, which name the model that
/// is shown and change it. Of a single picture there is one of each.
class ModelMenus : public QObject {
public:
  /// A model was chosen for a side: 0 left, or the only one, 1 right.
  using Choose = std::function<void(int side, ShadingModel model)>;
  /// A menu of presets for a side opens and is to be filled.
  using Fill = std::function<void(QMenu* menu, int side)>;

  ModelMenus(ActionList& actions, const Choose& choose, const Fill& fill, QObject* parent);

  /// The models in the pictures on screen, from left to right: one or two.
  void show(const std::vector<ShadingModel>& models) const;

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
