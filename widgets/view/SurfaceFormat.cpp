// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/SurfaceFormat.h"

namespace limn {

QSurfaceFormat limnSurfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 1);
  format.setOption(QSurfaceFormat::DeprecatedFunctions);
  format.setDepthBufferSize(0);
  format.setStencilBufferSize(0);
  format.setSamples(0);
  return format;
}

} // namespace limn
