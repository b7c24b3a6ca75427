// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/SurfaceFormat.h"

#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

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

OpenGlOffer openGlOffer() {
  QOffscreenSurface surface;
  surface.setFormat(limnSurfaceFormat());
  surface.create();
  QOpenGLContext context;
  context.setFormat(limnSurfaceFormat());
  const bool isMade = context.create() && surface.isValid() && context.makeCurrent(&surface);
  const auto version = isMade ? context.format().version() : qMakePair(0, 0);
  OpenGlOffer offer;
  if (version >= qMakePair(3, 0) && !context.isOpenGLES())
    offer.renderer =
        QString::fromLatin1(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
  else
    offer.problem = QObject::tr(
        "This computer offers the program no OpenGL 3.0, so the processor draws; to have the graphics "
        "card draw, install or update its driver.");
  if (isMade)
    context.doneCurrent();
  return offer;
}

} // namespace limn
