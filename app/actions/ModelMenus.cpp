// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/ModelMenus.h"

#include "app/actions/Actions.h"
#include "app/actions/MenuButton.h"
#include "widgets/shading/ModelSection.h"

#include <QMenu>
#include <QToolBar>

namespace limn {

ModelMenus::ModelMenus(const std::array<QActionGroup*, 2>& models, QMenu& menu) : QObject(&menu) {
  for (std::size_t side = 0; side < m_sides.size(); ++side) {
    m_sides[side].group = models[side];
    m_sides[side].menu = menu.addMenu(QString());
    m_sides[side].menu->addActions(models[side]->actions());
  }
}

void ModelMenus::addTo(QToolBar& bar) {
  const std::array names{"modelButton", "rightModelButton"};
  for (std::size_t side = 0; side < m_sides.size(); ++side) {
    QToolButton* button = addMenuButton(bar, m_sides[side].menu, QToolButton::InstantPopup);
    button->setObjectName(QLatin1String(names[side]));
    m_sides[side].button = button;
    m_sides[side].place = bar.addWidget(button);
    const QAction* choice = m_sides[side].group->actions().front(); // enabled as all of its group are
    connect(choice, &QAction::enabledChanged, button, &QWidget::setEnabled);
  }
}

void ModelMenus::show(const std::vector<ShadingModel>& models) {
  const bool isSingle = models.size() < 2;
  const std::array menuTexts{isSingle ? tr("&Model") : tr("Le&ft model"), tr("R&ight model")};
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
