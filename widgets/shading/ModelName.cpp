// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/ModelName.h"

#include <QCoreApplication>

namespace limn {

QString modelName(ShadingModel model) {
  const auto translated = [](const char* text) {
    return QCoreApplication::translate("limn::ModelName", text);
  };
  switch (model) {
  case ShadingModel::none:
    return translated("Unlit");
  case ShadingModel::classic:
    return translated("Classic");
  case ShadingModel::enhanced:
    return translated("Enhanced");
  case ShadingModel::robust:
    return translated("Robust");
  }
  return {};
}

} // namespace limn
