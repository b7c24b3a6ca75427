// SPDX-License-Identifier: GPL-3.0-or-later
// Grabs the editing widgets in both looks: limn_widget_pictures FOLDER
#include "scene/volume/Phantom.h"
#include "widgets/WidgetSamples.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/PointFields.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/FogSection.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/shading/GradientSection.h"
#include "widgets/theme/Icons.h"
#include "widgets/theme/LookStyle.h"

#include <QApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QMouseEvent>
#include <QStatusBar>
#include <QToolBar>

using namespace limn;

namespace {

void save(QWidget& widget, const QSize& size, const QString& path) {
  widget.resize(size);
  widget.show();
  QApplication::processEvents();
  if (!widget.grab().save(path))
    qFatal("could not write %s", qPrintable(path));
}

void saveEditor(const QString& prefix) {
  TransferFunctionEditor editor;
  editor.setUnit(QStringLiteral("HU"));
  editor.setTransferFunction(sampleFunction());
  save(editor, {1200, 120}, prefix + "editor_low.png");
  save(editor, {1200, 260}, prefix + "editor_no_volume.png");
  editor.setHistogram(sampleHistogram());
  editor.setMark(ValueMark{700.0});
  editor.canvas()->selectPoints({2});
  const PlotTransform plot = editor.canvas()->transform();
  const QPointF hovered(xOfValue(plot, -90.0), yOfOpacity(plot, 0.7));
  save(editor, {1200, 260}, prefix + "editor.png");
  QMouseEvent move(QEvent::MouseMove, hovered, editor.canvas()->mapToGlobal(hovered), Qt::NoButton,
                   Qt::NoButton, {});
  QApplication::sendEvent(editor.canvas(), &move);
  editor.canvas()->setFineLowOpacities(true);
  editor.canvas()->setPinnedValue(1800.0);
  save(editor, {1200, 260}, prefix + "editor_fine.png");
  TransferFunction wide = sampleFunction();
  wide.points.back().value = 9000.0; // beyond the values of the histogram
  editor.setTransferFunction(wide);
  save(editor, {1200, 260}, prefix + "editor_wide.png");
  auto* popup =
      new PointPopup(CurveSubject::value, sampleFunction(), PointIndices{2}, QStringLiteral("HU"), 1,
                     &editor); // deletes itself
  save(*popup, popup->sizeHint(), prefix + "popup.png");
  popup->close();
  TransferFunctionEditor empty;
  save(empty, {1200, 220}, prefix + "editor_empty.png");
}

void saveGradientEditor(const QString& prefix) {
  CurvePanel panel;
  panel.showGradient(true);
  GradientOpacityEditor& editor = *panel.gradientEditor();
  editor.setUnit(QStringLiteral("HU"));
  editor.setMeasuring(true);
  save(panel, {1200, 260}, prefix + "gradient_measuring.png");
  Histogram gradients = sampleHistogram();
  gradients.range = {0.0, 1800.0};
  editor.setHistogram(gradients);
  save(panel, {1200, 260}, prefix + "gradient_off.png");
  editor.setGradientOpacity(GradientOpacity{{{40.0, 0.1}, {300.0, 0.7}, {700.0, 1.0}}});
  panel.setGradientState(CurvePanel::GradientState::on);
  editor.editor()->canvas()->selectPoints({1});
  save(panel, {1200, 260}, prefix + "gradient.png");
  save(panel, {780, 220}, prefix + "gradient_narrow.png");
  auto* popup = new PointPopup(CurveSubject::gradient, sampleFunction(), PointIndices{2},
                               QStringLiteral("HU/mm"), 1, &panel);
  save(*popup, popup->sizeHint(), prefix + "gradient_popup.png");
  popup->close();
}

// The sections of what a scene may use, with a scene that does and one that does not.
void saveSections(const QString& prefix) {
  QWidget both;
  auto* layout = new QHBoxLayout(&both);
  Scene scene;
  scene.volume = phantomVolume({8.0, 0.0, 1});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.projection = Projection::compositeIsosurface;
  scene.crop = {{0.123, 0.0, 0.25}, {1.0, 0.8, 1.0}};
  const auto panelOf = [&](const Scene& shown) {
    auto* panel = new PropertiesPanel;
    for (auto* section : panel->findChildren<ShadingSection*>())
      section->setFolded(true);
    panel->setScene(shown);
    panel->foldUnused();
    layout->addWidget(panel);
    return panel;
  };
  scene.fog = withFogMode(scene, Fog::Mode::exp);
  panelOf(scene);
  scene.fog = withFogMode(scene, Fog::Mode::linear);
  scene.projection = Projection::mip;
  panelOf(scene);
  Scene plain;
  plain.volume = scene.volume;
  plain.camera = scene.camera;
  panelOf(plain);
  save(both, {1020, 1100}, prefix + "sections.png");
}

void savePanels(const QString& prefix) {
  QWidget both;
  auto* layout = new QHBoxLayout(&both);
  auto* open = new PropertiesPanel;
  auto* compared = new PropertiesPanel;
  auto* browser = new PresetBrowser;
  auto* icons = new QListWidget;
  for (auto* panel : {open, compared})
    panel->findChild<GradientSection*>()->setFolded(false);
  Shading robust;
  robust.model = ShadingModel::robust;
  robust.gradientReference = PercentileReference{};
  robust.lightDirection = glm::dvec3(0.0, 1.0, 0.0);
  open->setShading(robust);
  open->setModelsShown({ShadingModel::robust});
  compared->setModelsShown({ShadingModel::classic, ShadingModel::enhanced});
  const std::vector<Preset> presets = samplePresets();
  browser->setPresets(presets, {[&] {
                        Preset own = presets[1];
                        own.name = "My temporal bone";
                        own.note.clear();
                        return own;
                      }()});
  for (const QString& name : iconNames())
    icons->addItem(new QListWidgetItem(themedIcon(name, QApplication::palette()), name));
  icons->setIconSize({24, 24});
  for (QWidget* widget : std::initializer_list<QWidget*>{browser, compared, open, icons})
    layout->addWidget(widget);
  save(both, {1240, 1600}, prefix + "panels.png");
}

// A window like the program's, to see the parts together.
void saveWindow(const QString& prefix) {
  QMainWindow window;
  const QPalette palette = QApplication::palette();
  window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  for (const char* title : {"File", "Edit", "View", "Preset", "Help"})
    window.menuBar()->addMenu(QLatin1String(title));
  QToolBar* bar = window.addToolBar(QString());
  bar->setIconSize({20, 20});
  for (const char* name :
       {"open", "undo", "redo", "single", "side-by-side", "wipe", "difference", "snapshot"})
    bar->addAction(themedIcon(QLatin1String(name), palette), QLatin1String(name))->setCheckable(true);
  bar->actions()[4]->setChecked(true);
  auto* picture = new QWidget;
  picture->setAutoFillBackground(true);
  picture->setPalette(QPalette(QColor("#16181b")));
  window.setCentralWidget(picture);
  auto* editor = new TransferFunctionEditor;
  editor->setUnit(QStringLiteral("HU"));
  editor->setHistogram(sampleHistogram());
  editor->setTransferFunction(sampleFunction());
  auto* browser = new PresetBrowser;
  browser->setPresets(samplePresets(), {});
  auto* shading = new PropertiesPanel;
  shading->setModelsShown({ShadingModel::classic, ShadingModel::enhanced});
  const auto dock = [&](const char* title, QWidget* content, Qt::DockWidgetArea area) {
    auto* made = new QDockWidget(QLatin1String(title));
    made->setWidget(content);
    window.addDockWidget(area, made);
  };
  dock("Presets", browser, Qt::LeftDockWidgetArea);
  dock("Properties", shading, Qt::RightDockWidgetArea);
  dock("Transfer function", editor, Qt::BottomDockWidgetArea);
  window.statusBar()->showMessage(QStringLiteral("256×256×108 · 0.96×0.96×1.5 mm"));
  editor->canvas()->selectPoints({3});
  save(window, {1440, 900}, prefix + "window.png");
}

} // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  if (argc < 2)
    qFatal("usage: limn_widget_pictures FOLDER");
  const QString folder = QString::fromLocal8Bit(argv[1]) + QLatin1Char('/');
  for (const bool dark : {true, false}) {
    applyTheme(application, dark ? ThemeChoice::dark : ThemeChoice::light);
    const QString prefix = folder + (dark ? QStringLiteral("dark_") : QStringLiteral("light_"));
    saveEditor(prefix);
    saveGradientEditor(prefix);
    saveSections(prefix);
    savePanels(prefix);
    saveWindow(prefix);
  }
  return 0;
}
