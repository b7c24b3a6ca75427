// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/DriverRecovery.h"

#include "engine/VolumeTooLarge.h"
#include "gl/DriverHealth.h"
#include "widgets/Translated.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTimer>

#include <exception>

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

void DriverRecovery::guard(const std::function<void()>& work) {
  try {
    forgetDriverErrors(); // those of Qt's painter
    work();
    requireHealthyDriver(Message::tr("drawing the picture"));
  } catch (const BeyondDriver& error) {
    m_sentence = translated(error);
    const bool isVolume = dynamic_cast<const VolumeTooLarge*>(&error) != nullptr;
    emit stopped();
    QTimer::singleShot(0, this, [this, isVolume] {
      if (hasFailed()) // otherwise something else is to be shown
        emit beyondDriver(isVolume);
    });
  } catch (const DriverError& error) {
    failDriver(translated(error), QString::fromStdString(error.details()));
  } catch (const Error& error) {
    if (error.kind() == Error::Kind::openGl)
      failDriver(translated(error), {});
    else
      fail(translated(error));
  } catch (const std::exception& error) {
    fail(translated(error));
  }
}

void DriverRecovery::fail(const QString& sentence) {
  m_sentence = sentence;
  emit stopped();
  // Widgets must not be shown, nor the caller's slots run, in the middle of painting.
  QTimer::singleShot(0, this, [this, sentence] { emit failed(sentence); });
}

void DriverRecovery::giveUp(const QString& sentence) {
  m_sentence = sentence;
  m_details.clear();
  emit stopped();
  emit givenUp();
}

void DriverRecovery::failDriver(const QString& sentence, const QString& details) {
  const bool isLost = contextIsLost();
  m_sentence = sentence;
  m_details = details;
  ++m_failures;
  emit stopped();
  QTimer::singleShot(0, this, [this, isLost] {
    if (m_failures < mostFailures)
      emit rebuildNeeded(isLost);
    else
      emit givenUp();
  });
}

void DriverRecovery::forget() {
  m_sentence.clear();
  m_failures = 0;
}

void DriverRecovery::noteSuccess() {
  if (m_failures == 0)
    return;
  m_failures = 0;
  emit restored(tr("The graphics driver failed, and everything in it was made anew; nothing is lost."));
}

} // namespace limn
