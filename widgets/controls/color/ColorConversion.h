// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include <glm/glm.hpp>

namespace limn {

/// A scene's display colour (sRGB-encoded, 0..1) as Qt paints it.
inline QColor toQColor(const glm::dvec3& color) {
  const glm::dvec3 c = glm::clamp(color, 0.0, 1.0);
  return QColor::fromRgbF(static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b));
}

/// A picked colour as the scene keeps it: 8 bits per channel, as hex codes write them.
inline glm::dvec3 toSceneColor(const QColor& color) {
  return glm::dvec3(color.red(), color.green(), color.blue()) / 255.0;
}

} // namespace limn
