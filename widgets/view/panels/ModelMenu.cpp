// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/ModelMenu.h"

#include "scene/light/ModelName.h"
#include "widgets/shading/ModelSection.h"

#include <QMenu>

namespace limn {

void popUpModels(QWidget* parent, const QPoint& at, ShadingModel present,
                 const std::function<void(ShadingModel)>& choose) {
  auto* menu = new QMenu(parent);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const ShadingModel model : shadingModels) {
    QAction* action = menu->addAction(modelName(model));
    action->setCheckable(true);
    action->setChecked(model == present);
    QObject::connect(action, &QAction::triggered, parent, [choose, model] { choose(model); });
  }
  menu->popup(at);
}

} // namespace limn
