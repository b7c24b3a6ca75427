// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "scene/PresetFit.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/scene/CropSection.h"
#include "widgets/scene/ProjectionSection.h"
#include "widgets/scene/PropertiesPanel.h"

#include <QAction>
#include <QApplication>

namespace limn {

template <class Change>
void MainWindow::editScene(const Gesture& gesture, Change&& change) {
  Scene next = m_session.scene();
  change(next);
  m_session.edit(next, gesture);
}

void MainWindow::connectSceneSections() {
  connect(m_properties, &PropertiesPanel::projectionEdited, this, &MainWindow::setProjection);
  connect(m_properties, &PropertiesPanel::isovalueEdited, this,
          [this](double isovalue, const Gesture& gesture) {
            editScene(gesture, [&](Scene& scene) { scene.isovalue = isovalue; });
          });
  connect(m_properties, &PropertiesPanel::fogEdited, this, [this](const Fog& fog, const Gesture& gesture) {
    editScene(gesture, [&](Scene& scene) { scene.fog = fog; });
  });
  connect(m_properties, &PropertiesPanel::cropEdited, this,
          [this](const CropBox& crop, const Gesture& gesture) {
            editScene(gesture, [&](Scene& scene) { scene.crop = crop; });
          });
  connect(m_view, &CompareView::cropEdited, m_properties, &PropertiesPanel::cropEdited);
  connect(m_properties->cropSection(), &FoldingSection::foldedByUser, this, [this](bool folded) {
    m_cropIsEdited = !folded;
    showCropBox();
  });
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { followFocus(now); });
}

void MainWindow::connectGradientCurve() {
  GradientOpacityEditor* editor = m_curves->gradientEditor();
  connect(editor, &GradientOpacityEditor::gradientOpacityEdited, this,
          [this](const std::optional<GradientOpacity>& curve, const Gesture& gesture) {
            editScene(gesture, [&](Scene& scene) { scene.gradientOpacity = curve; });
          });
  connect(m_curves, &CurvePanel::gradientShown, this, &MainWindow::measureGradients);
  connect(&m_gradients, &GradientMeasurer::measured, editor, &GradientOpacityEditor::setHistogram);
  connect(&m_gradients, &GradientMeasurer::failed, this, &MainWindow::showError);
}

void MainWindow::showGradientCurve(const Scene& scene) {
  m_curves->gradientEditor()->setGradientOpacity(scene.gradientOpacity);
  m_curves->setGradientState(!scene.gradientOpacity                  ? CurvePanel::GradientState::off
                             : usesGradientOpacity(scene.projection) ? CurvePanel::GradientState::on
                                                                     : CurvePanel::GradientState::unused);
}

// Counting gradients takes a while and most scenes need none of it: it waits until somebody looks.
void MainWindow::measureGradients() {
  const std::shared_ptr<const Volume>& volume = m_session.scene().volume;
  GradientOpacityEditor* editor = m_curves->gradientEditor();
  editor->setUnit(volume ? QString::fromStdString(volume->info().unit) : QString());
  if (m_gradients.volume() == volume)
    return;
  editor->setHistogram(std::nullopt);
  const bool begins = volume && m_curves->gradientIsShown();
  editor->setMeasuring(begins);
  m_gradients.measure(begins ? volume : nullptr);
}

QAction* MainWindow::makeCropBoxAction() {
  m_cropBoxAction = new QAction(tr("&Crop box"), this);
  m_cropBoxAction->setCheckable(true);
  m_cropBoxAction->setShortcut(QKeySequence(Qt::Key_B));
  // A letter belongs to whatever has the focus: this one to the picture.
  m_cropBoxAction->setShortcutContext(Qt::WidgetShortcut);
  m_view->addAction(m_cropBoxAction);
  m_cropBoxAction->setToolTip(
      tr("Shows a box with handles in the picture; what is outside is cut away. (B)"));
  connect(m_cropBoxAction, &QAction::toggled, this, &MainWindow::showCropBox);
  m_sceneActions << m_cropBoxAction;
  return m_cropBoxAction;
}

void MainWindow::showCropBox() {
  m_view->setCropBoxVisible(m_cropBoxAction->isChecked() || m_cropIsEdited);
}

// The box shows while the crop section is used, and on while one goes from there to its handles in the view.
void MainWindow::followFocus(QWidget* now) {
  if (!now)
    return; // another program's turn
  m_cropIsEdited = m_properties->cropSection()->isAncestorOf(now) || (m_cropIsEdited && now == m_view);
  showCropBox();
}

void MainWindow::setProjection(Projection projection, const Gesture& gesture) {
  editScene(gesture, [&](Scene& scene) {
    scene.projection = projection;
    if (!usesIsovalue(projection) || !scene.volume)
      return;
    // A value that no voxel has would show nothing, and one in HU means nothing elsewhere: begin between
    // background and object.
    const ValueRange& range = scene.volume->range();
    const bool isForeign = scene.isovalue == Scene{}.isovalue && !looksLikeHounsfield(*scene.volume);
    if (isForeign || scene.isovalue <= range.lowest || scene.isovalue >= range.highest)
      scene.isovalue = objectThreshold(m_histogram);
  });
}

} // namespace limn
