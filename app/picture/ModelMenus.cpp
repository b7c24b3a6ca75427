// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/ModelMenus.h"

#include "app/picture/ComparisonController.h"
#include "app/window/ActionList.h"
#include "widgets/shading/ModelSection.h"

#include <QActionGroup>
#include <QMenu>
#include <QToolButton>

namespace limn {

// Last in the tool bar: the buttons come, go and change their width with the layout, and move nothing.
ModelMenus::ModelMenus(ActionList& actions, const Choose& choose, const Fill& fill, QObject* parent)
    : QObject(parent) {
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
    its.menu->addSeparator();
    QMenu* presets = its.menu->addMenu(ComparisonController::tr("&Preset"));
    connect(presets, &QMenu::aboutToShow, this, [fill, presets, side] { fill(presets, side); });
    its.button = actions.makeMenuButton(QLatin1String(buttons[place]), QToolButton::InstantPopup);
    its.place = actions.addMenuButton(*its.button, its.menu, {7, side});
    const QAction* choice = its.group->actions().front(); // enabled as all of its group are
    connect(choice, &QAction::enabledChanged, its.button, &QWidget::setEnabled);
    connect(its.group, &QActionGroup::triggered, this, [choose, side](const QAction* action) {
      choose(side, static_cast<ShadingModel>(action->data().toInt()));
    });
  }
}

void ModelMenus::show(const std::vector<ShadingModel>& models) const {
  const bool isSingle = models.size() < 2;
  const std::array menuTexts{isSingle ? ComparisonController::tr("&Model")
                                      : ComparisonController::tr("Left &model"),
                             ComparisonController::tr("R&ight model")};
  const std::array buttonTexts{isSingle ? ComparisonController::tr("%1")
                                        : ComparisonController::tr("Left: %1"),
                               ComparisonController::tr("Right: %1")};
  const std::array toolTips{
      isSingle ? ComparisonController::tr("The shading model of the picture: how tissue is lit.")
               : ComparisonController::tr("The shading model of the left side."),
      ComparisonController::tr("The shading model of the right side.")};
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
    its.button->setAccessibleName(ComparisonController::tr("Model: %1").arg(text));
  }
}

} // namespace limn
