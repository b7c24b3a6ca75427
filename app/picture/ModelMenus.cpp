// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/ModelMenus.h"

#include "app/window/ActionList.h"
#include "scene/light/Shading.h"
#include "widgets/shading/ModelSection.h"

#include <QMenu>

namespace limn {

// Last in the tool bar: the buttons come, go and change their width with the layout, and move nothing.
ModelMenus::ModelMenus(ActionList& actions, QObject* parent) : QObject(parent) {
  const std::array names{"model-left-", "model-right-"}, buttons{"modelButton", "rightModelButton"};
  for (int side = 0; side < 2; ++side) {
    const auto place = static_cast<std::size_t>(side);
    Side& its = m_sides[place];
    its.group = actions.addGroup();
    its.menu = actions.addMenu({}, {Menu::view, 2, 2 + side});
    for (const ShadingModel model : shadingModels)
      its.menu->addAction(actions.addChoice(*its.group, QLatin1String(names[place]) + nameOf(model),
                                            static_cast<int>(model),
                                            {.text = modelName(model), .needsVolume = true}));
    its.button = actions.makeMenuButton(QLatin1String(buttons[place]), QToolButton::InstantPopup);
    its.place = actions.addMenuButton(*its.button, its.menu, {7, side});
    const QAction* choice = its.group->actions().front(); // enabled as all of its group are
    connect(choice, &QAction::enabledChanged, its.button, &QWidget::setEnabled);
    connect(its.group, &QActionGroup::triggered, this, [this, side](const QAction* action) {
      emit chosen(side, static_cast<ShadingModel>(action->data().toInt()));
    });
  }
}

void ModelMenus::show(const std::vector<ShadingModel>& models) {
  const bool isSingle = models.size() < 2;
  const std::array menuTexts{isSingle ? tr("&Model") : tr("Left &model"), tr("R&ight model")};
  const std::array buttonTexts{isSingle ? tr("%1") : tr("Left: %1"), tr("Right: %1")};
  const std::array toolTips{isSingle ? tr("The shading model of the picture: how tissue is lit.")
                                     : tr("The shading model of the left side."),
                            tr("The shading model of the right side.")};
  for (std::size_t side = 0; side < m_sides.size(); ++side) {
    const Side& its = m_sides[side];
    const bool isShown = side < models.size();
    its.menu->menuAction()->setVisible(isShown);
    its.place->setVisible(isShown);
    if (!isShown)
      continue;
    const QString text = buttonTexts[side].arg(modelName(models[side]));
    checkOnly(*its.group, static_cast<int>(models[side]));
    its.menu->setTitle(menuTexts[side]);
    its.button->setText(text);
    its.button->setToolTip(toolTips[side]);
    its.button->setAccessibleName(tr("Model: %1").arg(text));
  }
}

} // namespace limn
