// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h> // before any OpenGL header of Qt

#include "gl/DriverHealth.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/ReferenceDrawing.h"
#include "widgets/view/ReferencePanel.h"
#include "widgets/view/ViewPanels.h"
#include "widgets/view/ViewPictures.h"

#include <QCoreApplication>
#include <QEvent>
#include <QOpenGLContext>

// What the compare view does when drawing fails: everything in the graphics driver is made anew, and when
// that has failed too often, the processor draws. The scene, its history and the controls live elsewhere and
// notice nothing.

namespace limn {
namespace {

constexpr int mostFailures = 3; // in a row, before the processor draws

} // namespace

void CompareView::makeReference() {
  m_reference = new ReferenceDrawing(this);
  m_referencePanel = new ReferencePanel(this);
  connect(m_reference, &ReferenceDrawing::drawn, this, &CompareView::showReference);
  connect(m_reference, &ReferenceDrawing::failed, this, &CompareView::fail);
  connect(m_referencePanel, &ReferencePanel::retryRequested, this, [this] {
    leaveProcessor();
    redraw();
  });
}

void CompareView::setProcessorRenderer(DrawOnProcessor renderer) {
  m_reference->setRenderer(std::move(renderer));
}

void CompareView::guarded(const std::function<void()>& work) {
  try {
    forgetDriverErrors(); // those of Qt's painter
    work();
    requireHealthyDriver("drawing the picture");
  } catch (const DriverError& error) {
    failDriver(QString::fromStdString(error.what()), QString::fromStdString(error.details()));
  } catch (const Error& error) {
    if (error.kind() == Error::Kind::openGl)
      failDriver(QString::fromStdString(error.what()), {});
    else
      fail(QString::fromStdString(error.what()));
  } catch (const std::exception& error) {
    fail(QString::fromStdString(error.what()));
  }
}

// Asked before work that nobody waits for, which ends quietly where it fails.
bool CompareView::isDriverLost() {
  guarded([] {});
  return !m_error.isEmpty();
}

void CompareView::stopDrawing() {
  m_idleTimer.stop();
  m_refineTimer.stop();
  m_restTimer.stop();
  m_probeTimer.stop();
}

void CompareView::fail(const QString& sentence) {
  m_error = sentence;
  m_onProcessor = false;
  stopDrawing();
  // Widgets must not be shown, nor the caller's slots run, in the middle of painting.
  QTimer::singleShot(0, this, [this, sentence] {
    updatePanels();
    emit errorOccurred(sentence);
  });
}

// Needs the context current, lost or not.
void CompareView::failDriver(const QString& sentence, const QString& details) {
  const bool wasLost = contextIsLost();
  m_error = sentence;
  m_failureDetails = details;
  ++m_driverFailures;
  stopDrawing();
  QTimer::singleShot(0, this, [this, wasLost] {
    if (m_driverFailures < mostFailures)
      rebuildGraphics(wasLost);
    else
      giveUpGraphics();
  });
}

void CompareView::rebuildGraphics(bool withContext) {
  if (withContext)
    renewContext();
  else
    releasePictures();
  m_error.clear();
  redraw();
}

// Qt makes a widget's context anew when its window changes, and tells the widget of it in this way, too where
// the window itself has lost its device.
void CompareView::renewContext() {
  QEvent windowChanged(QEvent::WindowChangeInternal);
  QCoreApplication::sendEvent(this, &windowChanged);
}

void CompareView::giveUpGraphics() {
  releasePictures();
  m_onProcessor = m_reference->canDraw() && m_scene.volume != nullptr;
  m_referencePanel->setReason(m_error, m_failureDetails);
  m_referencePanel->setPictures({});
  updatePanels();
  emit errorOccurred(m_error);
  if (m_onProcessor)
    drawOnProcessor();
}

void CompareView::drawOnProcessor() {
  const bool hasChanged = m_state.driverFailure != m_error || m_state.processorIsDone;
  m_state = {};
  m_state.driverFailure = m_error;
  const int count = pictureCount(m_layout);
  m_reference->draw(scenesOfSides(), {deviceSize().x / count, deviceSize().y});
  if (hasChanged)
    emit pictureStateChanged(m_state);
}

void CompareView::showReference(const std::vector<QImage>& pictures, bool isComplete) {
  if (!m_onProcessor)
    return;
  m_referencePanel->setPictures(pictures);
  updatePanels();
  m_state.processorIsDone = isComplete;
  emit pictureStateChanged(m_state);
}

void CompareView::leaveProcessor() {
  m_reference->stop();
  m_onProcessor = false;
  m_driverFailures = 0;
  m_error.clear();
  m_state = {};
}

// The pictures are complete: what failed before works.
void CompareView::noteRecovery() {
  if (m_driverFailures == 0)
    return;
  m_driverFailures = 0;
  emit graphicsRestored(
      tr("The graphics driver failed, and everything in it was made anew; nothing is lost."));
}

} // namespace limn
