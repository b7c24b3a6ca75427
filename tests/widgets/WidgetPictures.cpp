// SPDX-License-Identifier: GPL-3.0-or-later
// Grabs the editing widgets in both looks: limn_widget_pictures FOLDER
#include "widgets/Icons.h"
#include "widgets/Theme.h"
#include "widgets/WidgetSamples.h"
#include "widgets/controls/SpringSlider.h"
#include "widgets/curve/PointPopup.h"
#include "widgets/curve/TransferFunctionCanvas.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/shading/ShadingPanel.h"
#include "widgets/shading/ShadingSection.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMouseEvent>

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
  editor.setMarkedValue(700.0);
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
  auto* popup = new PointPopup(sampleFunction(), 2, QStringLiteral("HU"), 1, &editor); // deletes itself
  save(*popup, popup->sizeHint(), prefix + "popup.png");
  popup->close();
  TransferFunctionEditor empty;
  save(empty, {1200, 220}, prefix + "editor_empty.png");
}

void savePanels(const QString& prefix) {
  QWidget both;
  auto* layout = new QHBoxLayout(&both);
  auto* open = new ShadingPanel;
  auto* compared = new ShadingPanel;
  auto* browser = new PresetBrowser;
  auto* icons = new QListWidget;
  for (auto* panel : {open, compared})
    panel->sections()[1]->setFolded(false);
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
  save(both, {1200, 1000}, prefix + "panels.png");
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
    savePanels(prefix);
  }
  return 0;
}
