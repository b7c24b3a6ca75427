// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/SurfaceFormat.h"

#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace limn {

QSurfaceFormat limnSurfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 1);
  format.setOption(QSurfaceFormat::DeprecatedFunctions);
  format.setOption(QSurfaceFormat::ResetNotification); // a driver that was reset says so
  format.setDepthBufferSize(0);
  format.setStencilBufferSize(0);
  format.setSamples(0);
  return format;
}

QString openGlProblem() {
  QOffscreenSurface surface;
  surface.setFormat(limnSurfaceFormat());
  surface.create();
  QOpenGLContext context;
  context.setFormat(limnSurfaceFormat());
  const bool isMade = context.create() && surface.isValid() && context.makeCurrent(&surface);
  const auto version = isMade ? context.format().version() : qMakePair(0, 0);
  if (isMade)
    context.doneCurrent();
  if (version >= qMakePair(3, 0) && !context.isOpenGLES())
    return {};
  return QObject::tr(
      "This computer offers the program no OpenGL 3.0, so no volume can be drawn; install or update the "
      "driver of the graphics card (on Linux without one, the package libgl1-mesa-dri).");
}

} // namespace limn
