// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/ModelName.h"

#include <QObject>

namespace limn {

QString modelName(ShadingModel model) {
  switch (model) {
  case ShadingModel::none:
    return QObject::tr("Unlit");
  case ShadingModel::classic:
    return QObject::tr("Classic");
  case ShadingModel::enhanced:
    return QObject::tr("Enhanced");
  case ShadingModel::robust:
    return QObject::tr("Robust");
  }
  return {};
}

} // namespace limn
