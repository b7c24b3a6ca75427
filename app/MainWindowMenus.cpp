// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "widgets/Icons.h"
#include "widgets/Theme.h"
#include "widgets/presets/PresetBrowser.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

namespace limn {
namespace {

const char* const iconProperty = "limnIcon";

QAction* withIcon(QAction* action, const char* icon) {
  action->setProperty(iconProperty, QLatin1String(icon));
  return action;
}

} // namespace

void MainWindow::makeActions() {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makePresetMenu();
  makeHelpMenu();
  makeToolBar();
  refreshIcons();
}

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  withIcon(menu->addAction(tr("&Open file…"), QKeySequence::Open, this, &MainWindow::openFile), "open")
      ->setToolTip(tr("Opens a volume, a session, a scene or a picture that Limn saved."));
  menu->addAction(tr("Open &DICOM folder…"), QKeySequence(tr("Ctrl+Shift+O")), this, &MainWindow::openFolder);
  menu->addAction(tr("Open the sample &head"), this, [this] { openSource(QStringLiteral("sample")); });
  m_recentMenu = menu->addMenu(tr("Open &recent"));
  m_recentMenu->setObjectName(QStringLiteral("recentSources"));
  connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::refreshRecentMenu);
  refreshRecentMenu();
  addSessionActions(*menu);
  m_sceneActions << menu->addAction(tr("Save s&cene…"), this, &MainWindow::saveScene);
  QAction* snapshot =
      menu->addAction(tr("Save &picture…"), QKeySequence(tr("Ctrl+Shift+S")), this, &MainWindow::savePicture);
  snapshot->setIconText(tr("Snapshot"));
  snapshot->setToolTip(tr("Saves the picture on screen at full quality, with its scene inside."));
  m_sceneActions << withIcon(snapshot, "snapshot");
  m_sceneActions << menu->addAction(tr("&Close volume"), QKeySequence::Close, this, &MainWindow::closeVolume);
  menu->addSeparator();
  menu->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
}

void MainWindow::makeEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = m_session.undoStack().createUndoAction(this, tr("Undo"));
  QAction* redo = m_session.undoStack().createRedoAction(this, tr("Redo"));
  undo->setShortcuts(QKeySequence::Undo);
  redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  undo->setObjectName(QStringLiteral("undo"));
  redo->setObjectName(QStringLiteral("redo"));
  menu->addAction(withIcon(undo, "undo"));
  menu->addAction(withIcon(redo, "redo"));
  menu->addSeparator();
  m_sceneActions << menu->addAction(tr("&Copy picture"), QKeySequence(tr("Ctrl+Shift+C")), this, [this] {
    if (const QImage picture = m_view->currentPicture(0); !picture.isNull())
      QApplication::clipboard()->setImage(picture);
    else
      statusBar()->showMessage(tr("The picture is still being drawn; copy it in a moment."), 4000);
  });
}

void MainWindow::makeViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  m_layoutActions = new QActionGroup(this);
  const auto addLayout = [&](const QString& text, const char* icon, CompareLayout layout,
                             const QString& tip) {
    QAction* action = menu->addAction(text);
    action->setCheckable(true);
    action->setData(static_cast<int>(layout));
    action->setToolTip(tip);
    m_layoutActions->addAction(withIcon(action, icon));
    connect(action, &QAction::triggered, this, [this, layout] { setCompareLayout(layout); });
  };
  addLayout(tr("Single"), "single", CompareLayout::single, tr("One picture with the chosen model."));
  addLayout(tr("Side by side"), "side-by-side", CompareLayout::sideBySide,
            tr("Two models beside each other."));
  addLayout(tr("Wipe"), "wipe", CompareLayout::wipe, tr("Two models over each other with a border to drag."));
  addLayout(tr("Difference"), "difference", CompareLayout::difference,
            tr("Where the two models differ, amplified."));
  menu->addSeparator();
  m_viewsMenu = menu->addMenu(tr("&Look from"));
  const auto addView = [&](const QString& text, StandardView view) {
    m_sceneActions << m_viewsMenu->addAction(text, this, [this, view] { m_view->lookFrom(view); });
  };
  addView(tr("Anterior (front)"), StandardView::anterior);
  addView(tr("Posterior (back)"), StandardView::posterior);
  addView(tr("Left"), StandardView::left);
  addView(tr("Right"), StandardView::right);
  addView(tr("Superior (above)"), StandardView::superior);
  addView(tr("Inferior (below)"), StandardView::inferior);
  m_viewsMenu->addSeparator();
  m_sceneActions << m_viewsMenu->addAction(tr("Reset camera"), m_view, &CompareView::resetCamera);
  m_orthographicAction = menu->addAction(tr("&Orthographic"));
  m_orthographicAction->setCheckable(true);
  m_orthographicAction->setToolTip(tr("Parallel rays: sizes can be compared everywhere in the picture."));
  connect(m_orthographicAction, &QAction::triggered, this, &MainWindow::setOrthographic);
  m_sceneActions << m_orthographicAction;
  menu->addAction(withIcon(makeCropBoxAction(), "crop-box"));
  addRefineAction(*menu);
  menu->addSeparator();
  for (QDockWidget* dock : {m_presetDock, m_shadingDock, m_effectsDock, m_accuracyDock, m_curveDock})
    menu->addAction(dock->toggleViewAction());
  m_focusAction = menu->addAction(tr("&Picture and curve only"));
  m_focusAction->setCheckable(true);
  m_focusAction->setShortcut(QKeySequence(Qt::Key_F11));
  connect(m_focusAction, &QAction::toggled, this, &MainWindow::setFocusMode);
  menu->addSeparator();
  m_patientAction = menu->addAction(tr("Patient in the title &bar"));
  m_patientAction->setCheckable(true);
  m_patientAction->setChecked(m_settings.patientIsShown());
  connect(m_patientAction, &QAction::toggled, this, [this](bool shown) {
    m_settings.setPatientIsShown(shown);
    updateTitle();
  });
  QMenu* themes = menu->addMenu(tr("&Theme"));
  auto* group = new QActionGroup(this);
  const std::pair<QString, QString> choices[] = {{QStringLiteral("system"), tr("Follow the system")},
                                                 {QStringLiteral("light"), tr("Light")},
                                                 {QStringLiteral("dark"), tr("Dark")}};
  for (const auto& [choice, text] : choices) {
    QAction* action = themes->addAction(text);
    action->setCheckable(true);
    action->setChecked(m_settings.theme() == choice);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, choice = choice] { applyThemeChoice(choice); });
  }
}

void MainWindow::makePresetMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Preset"));
  menu->addAction(tr("&Find preset"), QKeySequence::Find, this, [this] {
    m_presetDock->show();
    m_presets->focusSearch();
  });
  m_sceneActions << menu->addAction(tr("&Save as preset…"), this, &MainWindow::savePreset);
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  menu->addAction(tr("Mouse and &keys"), QKeySequence(QKeySequence::HelpContents), this,
                  &MainWindow::showShortcuts);
  menu->addAction(tr("&About Limn"), this, &MainWindow::showAbout);
}

void MainWindow::makeToolBar() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("toolBar"));
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  const QList<QAction*> file = menuBar()->actions().at(0)->menu()->actions();
  auto* open = new QToolButton(bar);
  open->setDefaultAction(file.at(0));
  open->setPopupMode(QToolButton::MenuButtonPopup);
  open->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  open->setMenu(m_recentMenu);
  file.at(0)->setIconText(tr("Open"));
  bar->addWidget(open);
  bar->addSeparator();
  bar->addAction(findChild<QAction*>(QStringLiteral("undo")));
  bar->addAction(findChild<QAction*>(QStringLiteral("redo")));
  bar->addSeparator();
  m_modelActions = new QActionGroup(this);
  m_modelActions->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  const std::pair<ShadingModel, QString> models[] = {{ShadingModel::none, tr("Unlit")},
                                                     {ShadingModel::classic, tr("Classic")},
                                                     {ShadingModel::enhanced, tr("Enhanced")},
                                                     {ShadingModel::robust, tr("Robust")}};
  for (const auto& [model, text] : models) {
    QAction* action = bar->addAction(text);
    action->setCheckable(true);
    action->setData(static_cast<int>(model));
    action->setToolTip(tr("Shows one picture with the %1 model.").arg(text.toLower()));
    m_modelActions->addAction(action);
    connect(action, &QAction::triggered, this, [this, model = model] { setModel(model); });
  }
  bar->addSeparator();
  bar->addActions(m_layoutActions->actions());
  bar->addSeparator();
  bar->addAction(m_cropBoxAction);
  auto* views = new QToolButton(bar);
  views->setText(tr("Views"));
  views->setProperty(iconProperty, QStringLiteral("compass"));
  views->setPopupMode(QToolButton::InstantPopup);
  views->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  views->setMenu(m_viewsMenu);
  bar->addWidget(views);
  auto* stretch = new QWidget(bar);
  stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(stretch);
  for (QAction* action : m_sceneActions)
    if (action->property(iconProperty).toString() == QStringLiteral("snapshot"))
      bar->addAction(action);
}

void MainWindow::refreshIcons() {
  for (QAction* action : findChildren<QAction*>())
    if (const QString icon = action->property(iconProperty).toString(); !icon.isEmpty())
      action->setIcon(themedIcon(icon, palette()));
  for (QToolButton* button : findChildren<QToolButton*>())
    if (const QString icon = button->property(iconProperty).toString(); !icon.isEmpty())
      button->setIcon(themedIcon(icon, palette()));
}

void MainWindow::setModel(ShadingModel model) {
  Shading shading = m_session.scene().shading;
  shading.model = model;
  m_session.setShading(shading, {nextGestureId(), tr("change model")});
  setCompareLayout(CompareLayout::single);
}

void MainWindow::setSideModel(int side, ShadingModel model) {
  if (m_view->compareLayout() == CompareLayout::single) {
    setModel(model);
    return;
  }
  (side == 0 ? m_leftModel : m_rightModel) = model;
  showModels();
}

void MainWindow::setOrthographic(bool orthographic) {
  Camera camera = m_session.scene().camera;
  // The target plane keeps its size on screen.
  const double distance = glm::length(camera.target - camera.position);
  if (orthographic && camera.projection == Camera::Projection::perspective) {
    camera.heightMm = 2.0 * halfHeight(camera) * distance;
    camera.projection = Camera::Projection::orthographic;
  } else if (!orthographic && camera.projection == Camera::Projection::orthographic) {
    camera.projection = Camera::Projection::perspective;
    const glm::dvec3 forward = basisOf(camera).forward;
    camera.position = camera.target - forward * (camera.heightMm / 2.0 / halfHeight(camera));
  }
  m_session.setCamera(camera);
}

void MainWindow::applyThemeChoice(const QString& choice) {
  m_settings.setTheme(choice);
  const ThemeChoice theme = choice == QStringLiteral("dark")    ? ThemeChoice::dark
                            : choice == QStringLiteral("light") ? ThemeChoice::light
                                                                : ThemeChoice::system;
  applyTheme(*static_cast<QApplication*>(QApplication::instance()), theme);
}

void MainWindow::setFocusMode(bool on) {
  m_presetDock->setVisible(!on);
  showRightDocks(!on);
  for (QToolBar* bar : findChildren<QToolBar*>())
    bar->setVisible(!on);
  statusBar()->setVisible(!on);
}

void MainWindow::showShortcuts() {
  const QString text = tr(
      "<h3>Picture</h3><table cellspacing=6>"
      "<tr><td>Left drag</td><td>rotate</td></tr><tr><td>Middle drag, Shift+left drag</td><td>pan</td></tr>"
      "<tr><td>Right drag, wheel, + −</td><td>zoom</td></tr><tr><td>Ctrl+left drag</td><td>roll</td></tr>"
      "<tr><td>Alt+left drag, W</td><td>window and level; with Ctrl: opacity; Esc cancels</td></tr>"
      "<tr><td>Shift+move, Shift+click</td><td>value under the pointer, pin it in the curve</td></tr>"
      "<tr><td>A P L S I, End PgDn Home (Shift: opposite)</td><td>standard views</td></tr>"
      "<tr><td>R</td><td>reset the camera</td></tr><tr><td>Space</td><td>swap the two sides while "
      "held</td></tr>"
      "<tr><td>B, drag a handle</td><td>crop box; double click a handle: that face uncut</td></tr>"
      "<tr><td>0, 1 … 9</td><td>full range, presets</td></tr><tr><td>F11, double click</td><td>picture and "
      "curve only</td></tr></table>"
      "<h3>Curve</h3><table cellspacing=6>"
      "<tr><td>Click the curve, double click</td><td>add a point</td></tr>"
      "<tr><td>Drag a point</td><td>move; Shift locks an axis, Alt is fine</td></tr>"
      "<tr><td>Middle click, Del</td><td>delete</td></tr><tr><td>Double click a point</td><td>colour and "
      "numbers</td></tr>"
      "<tr><td>Drag the handle</td><td>shift the curve; Alt: width</td></tr>"
      "<tr><td>Wheel, Shift+wheel</td><td>zoom, pan the value axis</td></tr>"
      "<tr><td>Tab, arrows, Enter</td><td>walk the points, move, type numbers</td></tr></table>");
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Mouse and keys"), text, QMessageBox::Close, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowModality(Qt::NonModal);
  box->show();
}

void MainWindow::showAbout() {
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Limn"),
                              tr("<h3>Limn %1</h3><p>Transfer functions for CT and MR volumes, classic and "
                                 "gradient-enhanced Blinn-Phong side by "
                                 "side.</p><p><b>Not for diagnosis.</b></p><p>Free software under the GNU "
                                 "General Public License, version 3 or "
                                 "later.</p>")
                                  .arg(QStringLiteral(LIMN_VERSION)),
                              QMessageBox::Close, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowModality(Qt::NonModal);
  box->show();
}

} // namespace limn
