// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/Actions.h"

#include "app/engines/EngineChoice.h"
#include "app/language/Language.h"
#include "scene/light/ModelName.h"
#include "scene/view/CompareLayout.h"
#include "scene/view/PlaneSettings.h"
#include "widgets/shading/ModelSection.h"
#include "widgets/view/gestures/CameraGesture.h"

#include <QUndoStack>

namespace limn {

struct Actions::Look {
  QString text;
  QKeySequence shortcut = {};
  QString toolTip = {};
  const char* icon = nullptr;
  bool isCheckable = false;
};

Actions::Actions(QWidget& window, QUndoStack& history) : icons(window), m_window(window) {
  makeFileActions();
  makeEditActions(history);
  makeLayouts();
  makePlaneLayouts();
  makeModels();
  makeTools();
  makeViews();
  makeViewActions();
  makeThemes();
  makeLanguages();
  makeEngines();
  makeOtherActions();
}

QAction* Actions::dressed(QAction* action, const QString& name, const Look& look) {
  action->setObjectName(name);
  if (!look.shortcut.isEmpty())
    action->setShortcut(look.shortcut);
  if (!look.toolTip.isEmpty())
    action->setToolTip(look.toolTip);
  if (look.icon)
    icons.give(*action, QLatin1String(look.icon));
  action->setCheckable(look.isCheckable);
  return action;
}

QAction* Actions::made(const char* name, const Look& look) {
  return dressed(new QAction(look.text, &m_window), QLatin1String(name), look);
}

void Actions::addChoice(QActionGroup& group, const QString& name, const QVariant& data, const Look& look) {
  QAction* action = dressed(new QAction(look.text, &m_window), name, look);
  action->setData(data);
  group.addAction(action);
}

void Actions::makeFileActions() {
  openFile =
      made("openFile", {.text = tr("&Open file…"),
                        .shortcut = QKeySequence::Open,
                        .toolTip = tr("Opens a volume, a session, a scene or a picture that Limn saved."),
                        .icon = "open"});
  openFile->setIconText(tr("Open"));
  openFolder = made("openFolder", {.text = tr("Open &DICOM folder…"), .shortcut = tr("Ctrl+Shift+O")});
  openSample = made("openSample", {.text = tr("Open the sample &head")});
  openLabels = made("openLabels", {.text = tr("Open &labels…"),
                                   .toolTip = tr("Opens a segmentation of the volume: each label can be "
                                                 "shown, hidden or faded.")});
  saveSession =
      made("saveSession",
           {.text = tr("&Save session"),
            .shortcut = QKeySequence::Save,
            .toolTip = tr("Saves all of your work but the volume itself: look and camera, comparison, "
                          "slices and panels.")});
  saveSessionAs = made("saveSessionAs", {.text = tr("Save session &as…")});
  saveScene =
      made("saveScene", {.text = tr("Save look and ca&mera (scene)…"),
                         .toolTip = tr("Saves how the volume is shown: curve, light, camera, crop. For "
                                       "another volume, or for the command line.")});
  savePicture = made("savePicture",
                     {.text = tr("Save &picture…"),
                      .shortcut = tr("Ctrl+Shift+S"),
                      .toolTip = tr("Saves the picture on screen at full quality, with its scene inside."),
                      .icon = "snapshot"});
  savePicture->setIconText(tr("Snapshot"));
  saveFigure =
      made("saveFigure", {.text = tr("Save &figure…"),
                          .shortcut = tr("Ctrl+Shift+F"),
                          .toolTip = tr("Makes a figure to publish: pictures with names, scale, curve "
                                        "and notes, as PNG, TIFF, EXR or PDF.")});
  saveTurntable = made("saveTurntable", {.text = tr("Save &turntable…"),
                                         .toolTip = tr("Saves the picture from all around, as frames or a "
                                                       "video.")});
  saveDicom = made("saveDicom", {.text = tr("Save to D&ICOM…"),
                                 .toolTip = tr("Saves picture and look of a DICOM series for an archive, "
                                               "filed with its patient and study.")});
  exportSurface =
      made("exportSurface",
           {.text = tr("E&xport surface…"),
            .toolTip = tr("Makes a mesh of the surface at a value, to print or to model with: STL, "
                          "PLY or OBJ, in millimetres.")});
  closeVolume = made("closeVolume", {.text = tr("&Close volume"), .shortcut = QKeySequence::Close});
  quit = made("quit", {.text = tr("&Quit"), .shortcut = QKeySequence::Quit});
}

void Actions::makeEditActions(QUndoStack& history) {
  undo = dressed(history.createUndoAction(&m_window, tr("Undo")), QStringLiteral("undo"),
                 {.text = {}, .icon = "undo"});
  redo = dressed(history.createRedoAction(&m_window, tr("Redo")), QStringLiteral("redo"),
                 {.text = {}, .icon = "redo"});
  undo->setShortcuts(QKeySequence::Undo);
  redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
  copyPicture = made("copyPicture", {.text = tr("&Copy picture"), .shortcut = tr("Ctrl+Shift+C")});
}

void Actions::makeLayouts() {
  layouts = new QActionGroup(&m_window);
  const auto add = [this](CompareLayout layout, const QString& text, const char* icon, const QString& tip) {
    addChoice(*layouts, QStringLiteral("layout-") + QLatin1String(nameOf(layout)), static_cast<int>(layout),
              {.text = text, .toolTip = tip, .icon = icon, .isCheckable = true});
  };
  add(CompareLayout::single, tr("Si&ngle"), "single", tr("One picture with the chosen model."));
  add(CompareLayout::sideBySide, tr("Side b&y side"), "side-by-side", tr("Two models beside each other."));
  add(CompareLayout::wipe, tr("&Wipe"), "wipe", tr("Two models over each other with a border to drag."));
  add(CompareLayout::difference, tr("&Difference"), "difference",
      tr("Where the two models differ, amplified."));
}

void Actions::makePlaneLayouts() {
  planeLayouts = new QActionGroup(&m_window);
  const auto add = [this](PlaneLayout layout, const QString& text, const QString& tip) {
    const QByteArray name = QByteArray("planes-") + nameOf(layout);
    addChoice(*planeLayouts, QLatin1String(name), static_cast<int>(layout),
              {.text = text, .toolTip = tip, .icon = name.constData(), .isCheckable = true});
  };
  add(PlaneLayout::pictureOnly, tr("&3D only"), tr("The picture without slices."));
  add(PlaneLayout::pictureAndThree, tr("3D &and slices"),
      tr("Axial, coronal and sagittal slices beside the picture."));
  add(PlaneLayout::oneLarge, tr("&One slice large"),
      tr("One slice large, the picture and the other slices beside it; a double click on a slice chooses "
         "it."));
}

void Actions::makeModels() {
  for (std::size_t side = 0; side < models.size(); ++side) {
    models[side] = new QActionGroup(&m_window);
    const QString name = side == 0 ? QStringLiteral("model-left-") : QStringLiteral("model-right-");
    for (const ShadingModel model : shadingModels)
      addChoice(*models[side], name + QLatin1String(nameOf(model)), static_cast<int>(model),
                {.text = modelName(model), .isCheckable = true});
  }
}

// The keys belong to the picture (ViewKeys), which is why these only name them.
void Actions::makeTools() {
  tools = new QActionGroup(&m_window);
  const auto add = [this](ViewTool tool, const char* name, const QString& text, const QString& key,
                          const QString& tip) {
    const QByteArray icon = QByteArray("tool-") + name;
    addChoice(*tools, QLatin1String(icon), static_cast<int>(tool),
              {.text = QStringLiteral("%1\t%2").arg(text, key),
               .toolTip = tr("Left drag: %1 (%2)").arg(tip, key),
               .icon = icon.constData(),
               .isCheckable = true});
    tools->actions().back()->setIconText(text);
  };
  add(ViewTool::rotate, "rotate", tr("Rotate"), tr("[ or Esc"), tr("rotate the picture"));
  add(ViewTool::pan, "pan", tr("Pan"), tr("M"), tr("move the picture"));
  add(ViewTool::zoom, "zoom", tr("Zoom"), tr("Z"), tr("up is nearer"));
  add(ViewTool::windowLevel, "window-level", tr("Window/level"), tr("W"),
      tr("right widens the window, up raises its level"));
  checkOnly(*tools, static_cast<int>(ViewTool::rotate));
}

void Actions::makeViews() {
  views = new QActionGroup(&m_window);
  const auto add = [this](StandardView view, const char* name, const QString& text) {
    addChoice(*views, QStringLiteral("view-") + QLatin1String(name), static_cast<int>(view), {.text = text});
  };
  add(StandardView::anterior, "anterior", tr("Anterior (front)"));
  add(StandardView::posterior, "posterior", tr("Posterior (back)"));
  add(StandardView::left, "left", tr("Left"));
  add(StandardView::right, "right", tr("Right"));
  add(StandardView::superior, "superior", tr("Superior (above)"));
  add(StandardView::inferior, "inferior", tr("Inferior (below)"));
  resetCamera = made("resetCamera", {.text = tr("Reset camera")});
  setOrientation =
      made("setOrientation", {.text = tr("Set &orientation…"),
                              .toolTip = tr("Says which side is left where the volume's file does not.")});
}

void Actions::makeViewActions() {
  orthographic =
      made("orthographic", {.text = tr("&Orthographic"),
                            .toolTip = tr("Parallel rays: sizes can be compared everywhere in the picture."),
                            .isCheckable = true});
  cropBox = made("cropBox",
                 {.text = tr("&Crop box"),
                  .shortcut = Qt::Key_B,
                  .toolTip = tr("Shows a box with handles in the picture; what is outside is cut away. (B)"),
                  .icon = "crop-box",
                  .isCheckable = true});
  // A letter belongs to whatever has the focus: this one to the picture.
  cropBox->setShortcutContext(Qt::WidgetShortcut);
  bodyOnly = made("bodyOnly", {.text = tr("&Body only"),
                               .toolTip = tr("Finds the body and hides the table, the head holder and what "
                                             "else lies beside it."),
                               .isCheckable = true});
  refineAtRest = made("refineAtRest",
                      {.text = tr("Sharpen while nothing &moves"),
                       .toolTip = tr("While nothing moves, draws the picture again with smaller and smaller "
                                     "steps until it lies within half a level of the exact one."),
                       .isCheckable = true});
  pictureAndCurveOnly =
      made("pictureAndCurveOnly",
           {.text = tr("Picture and cur&ve only"), .shortcut = Qt::Key_F11, .isCheckable = true});
  nextPanel = made("nextPanel", {.text = tr("&Next panel"), .shortcut = Qt::Key_F6});
  previousPanel = made("previousPanel",
                       {.text = tr("&Previous panel"), .shortcut = QKeySequence(Qt::SHIFT | Qt::Key_F6)});
  patientInTitle =
      made("patientInTitle", {.text = tr("Show the patient's &name in the title bar"), .isCheckable = true});
}

void Actions::makeThemes() {
  themes = new QActionGroup(&m_window);
  const auto add = [this](const char* word, const QString& text) {
    addChoice(*themes, QStringLiteral("theme-") + QLatin1String(word), QLatin1String(word),
              {.text = text, .isCheckable = true});
  };
  add("system", tr("Follow the system"));
  add("light", tr("Light"));
  add("dark", tr("Dark"));
  add("contrast", tr("High contrast"));
}

void Actions::makeLanguages() {
  languages = new QActionGroup(&m_window);
  const auto add = [this](const QString& code, const QString& text) {
    addChoice(*languages, QStringLiteral("language-") + code, code,
              {.text = text, .toolTip = tr("The window uses it from the next start."), .isCheckable = true});
  };
  add(QStringLiteral("system"), tr("Follow the system"));
  for (const Language& language : languagesSpoken())
    add(language.code, language.name);
}

void Actions::makeEngines() {
  engines = new QActionGroup(&m_window);
  const auto add = [this](EngineSetting setting, const char* name, const QString& text, const QString& tip) {
    addChoice(*engines, QStringLiteral("engine-") + QLatin1String(name), static_cast<int>(setting),
              {.text = text, .toolTip = tip, .isCheckable = true});
  };
  add(EngineSetting::automatic, "auto", tr("&Automatic"), {});
  add(EngineSetting::openGl, "gl", tr("&OpenGL"), {});
  add(EngineSetting::processor, "cpu", tr("&Processor"),
      tr("Draws with the vector instructions of the processor; needs no graphics card."));
}

void Actions::makeOtherActions() {
  findPreset = made("findPreset", {.text = tr("&Find preset"), .shortcut = QKeySequence::Find});
  savePreset = made("savePreset", {.text = tr("&Save as preset…")});
  importLooks = made("importLooks",
                     {.text = tr("&Import…"),
                      .toolTip = tr("Makes presets of your own from files of Limn or another program.")});
  exportLook =
      made("exportLook", {.text = tr("&Export…"),
                          .toolTip = tr("Writes the curve and the light that are shown as a file of Limn or "
                                        "another program.")});
  suggest =
      made("suggest", {.text = tr("S&uggest from boundaries…"),
                       .toolTip = tr("Finds where materials touch in this volume and proposes a band of "
                                     "the curve for each")});
  earlierLook =
      made("earlierLook", {.text = tr("Use the &look of the volume before"),
                           .shortcut = tr("Ctrl+L"),
                           .toolTip = tr("Shows this volume with curve and light of the one that was "
                                         "open before it.")});
  takeSnapshot = made("takeSnapshot", {.text = tr("&Remember this look as \"before\""),
                                       .shortcut = tr("Ctrl+B"),
                                       .toolTip = tr("Keeps curve and light of this moment to compare with "
                                                     "what becomes of them.")});
  compareSnapshot =
      made("compareSnapshot", {.text = tr("Compare &before and now"),
                               .shortcut = tr("Ctrl+Shift+B"),
                               .toolTip = tr("Shows the remembered look at the left, the present one at the "
                                             "right."),
                               .isCheckable = true});
  compareModels = made("compareModels", {.text = tr("Compare &models again"),
                                         .toolTip = tr("Ends the comparison of two looks.")});
  settings = made("settings", {.text = tr("&Settings…"), .shortcut = tr("Ctrl+,")});
  settings->setMenuRole(QAction::PreferencesRole);
  stability =
      made("stability",
           {.text = tr("&Stability checks…"),
            .toolTip = tr("Checks what this computer's driver draws where renderers are known to fail.")});
  guide = made("guide", {.text = tr("&Guide"),
                         .shortcut = QKeySequence::HelpContents,
                         .toolTip = tr("Opens the guide at what it says of the panel with the keyboard.")});
  tour = made("tour", {.text = tr("&Tour of the window")});
  shortcuts = made("shortcuts", {.text = QStringLiteral("%1\t%2").arg(tr("Mouse and &keys"), tr("?"))});
  about = made("about", {.text = tr("&About Limn")});
}

void Actions::setVolumeOpen(bool isOpen) const {
  for (QAction* action : {openLabels, bodyOnly, saveSession, saveSessionAs, saveScene, savePicture,
                          saveFigure, saveTurntable, exportSurface, closeVolume, copyPicture, resetCamera,
                          orthographic, cropBox, savePreset, exportLook, suggest, takeSnapshot})
    action->setEnabled(isOpen);
  for (const QActionGroup* group : {views, tools, layouts, planeLayouts, models[0], models[1]})
    for (QAction* action : group->actions())
      action->setEnabled(isOpen);
}

void checkOnly(const QActionGroup& group, const QVariant& data) {
  for (QAction* action : group.actions())
    action->setChecked(action->data() == data);
}

} // namespace limn
