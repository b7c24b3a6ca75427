// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"

#include <QObject>

#include <array>
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
  Q_OBJECT

public:
  ModelMenus(ActionList& actions, QObject* parent);

  /// The models in the pictures on screen, from left to right: one or two.
  void show(const std::vector<ShadingModel>& models);

signals:
  /// A model was chosen for a side: 0 left, or the only one, 1 right.
  void chosen(int side, limn::ShadingModel model);

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
