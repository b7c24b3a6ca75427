// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/LabelReading.h"

#include "scene/regions/LabelAt.h"
#include "widgets/ValueText.h"

#include <QObject>

namespace limn {

QString labelReading(const Region& keep, const TransferFunction& function, const glm::dvec3& index,
                     double value) {
  const QString name = QString::fromStdString(labelNameAt(keep, index));
  if (name.isEmpty())
    return {};
  const TransferFunction* own = ownLookAt(keep, index);
  return QObject::tr("%1 · opacity %2")
      .arg(name, opacityText(classify(own ? *own : function, value).opacity));
}

QString withLabelReading(const QString& reading, const QString& ofLabel) {
  return ofLabel.isEmpty() ? reading : QStringLiteral("%1 · %2").arg(reading, ofLabel);
}

} // namespace limn
