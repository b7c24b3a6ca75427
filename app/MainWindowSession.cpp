// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/MessageBar.h"
#include "app/SaveDialog.h"
#include "io/AtomicFile.h"
#include "scene/Error.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/view/CompareView.h"

#include <QAction>
#include <QDateTime>
#include <QDockWidget>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

// The session as a file, and what is done so that none is lost: saving it all the time, keeping what is left
// unsaved, offering what an earlier window left behind.

namespace limn {
namespace {

QString timeOf(const std::filesystem::path& file) {
  const QDateTime time = QFileInfo(QString::fromStdString(file.string())).lastModified();
  return QLocale().toString(time, QLocale::ShortFormat);
}

// "CT 512×512×120, 21.11.26 14:03". What cannot be read still has a time.
QString described(const std::filesystem::path& file) {
  QString label;
  try {
    label = QString::fromStdString(parseSession(readTextFile(file), "session").label);
  } catch (const Error&) {
    // Opening it says why.
  }
  return label.isEmpty() ? timeOf(file) : label + QStringLiteral(", ") + timeOf(file);
}

} // namespace

void MainWindow::addSessionActions(QMenu& menu) {
  m_unsavedMenu = menu.addMenu(tr("Open &unsaved session"));
  m_unsavedMenu->setObjectName(QStringLiteral("unsavedSessions"));
  m_unsavedMenu->setToolTip(tr("Sessions that were left with unsaved changes."));
  connect(&menu, &QMenu::aboutToShow, this, &MainWindow::refreshUnsavedMenu);
  menu.addSeparator();
  QAction* save = menu.addAction(tr("&Save session"), QKeySequence::Save, this, &MainWindow::saveSession);
  save->setToolTip(tr("Saves everything but the volume itself: scene, comparison and panel."));
  m_sceneActions << save;
  m_sceneActions << menu.addAction(tr("Save session &as…"), this, &MainWindow::saveSessionAs);
}

SessionDocument::Panel MainWindow::panelOf(const QDockWidget* dock) const {
  return dock == m_shadingDock   ? SessionDocument::Panel::properties
         : dock == m_effectsDock ? SessionDocument::Panel::effects
                                 : SessionDocument::Panel::accuracy;
}

void MainWindow::followPanels() {
  for (QDockWidget* dock : {m_shadingDock, m_effectsDock, m_accuracyDock})
    connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
      if (visible)
        m_panel = dock;
      noteChange();
    });
}

SessionDocument MainWindow::sessionDocument() const {
  SessionDocument session;
  session.scene.scene = m_session.scene();
  session.scene.scene.volume.reset();
  session.scene.volume = m_session.volumePath();
  session.scene.hasCamera = true;
  session.scene.hasTransferFunction = true;
  session.series = m_shown.options.read.series;
  session.spacingMm = m_shown.options.read.spacingMm;
  session.layout = m_view->compareLayout();
  session.leftModel = m_leftModel;
  session.rightModel = m_rightModel;
  session.wipe = m_view->wipePosition();
  session.panel = m_panel && !m_panel->isHidden() ? panelOf(m_panel) : SessionDocument::Panel::none;
  if (showsPreset(m_session.scene()))
    session.preset = m_preset.name;
  session.cropBoxIsShown = m_cropBoxAction->isChecked();
  session.gradientCurveIsShown = m_curves->gradientIsShown();
  return session;
}

// Brings back what a session says beside its scene.
void MainWindow::showSession(const SessionDocument& session) {
  m_leftModel = session.leftModel;
  m_rightModel = session.rightModel;
  m_view->setWipePosition(session.wipe);
  setCompareLayout(session.layout);
  m_cropBoxAction->setChecked(session.cropBoxIsShown);
  m_curves->showGradient(session.gradientCurveIsShown);
  for (QDockWidget* dock : {m_shadingDock, m_effectsDock, m_accuracyDock})
    if (panelOf(dock) == session.panel) {
      dock->show();
      dock->raise();
    }
  m_preset.name = session.preset;
  m_presets->setCurrent(QString::fromStdString(session.preset));
}

// Behind every opening: what the session is called now, and from where on something could be lost.
void MainWindow::settleSession(const LoadedScene& loaded) {
  m_sessionFile.clear();
  const std::filesystem::path source(m_shown.source.toStdString());
  if (loaded.session) {
    showSession(*loaded.session);
    m_sessionFile =
        m_shown.isUnsavedSession ? QString::fromStdString(loaded.session->savedAs) : m_shown.source;
    if (m_shown.isUnsavedSession && loaded.session->isUnsaved)
      m_session.undoStack().resetClean();
  }
  m_settled = sessionDocument();
  if (!m_shown.isUnsavedSession) {
    noteChange();
    return;
  }
  m_settled = {};
  m_shown.source = QString::fromStdString(loaded.volumePath);
  m_shown.isUnsavedSession = false;
  // From here on this window keeps it.
  if (m_keeper && m_keeper->autosave().savingOfNow()())
    m_keeper->forget(source);
  offerAbandoned();
}

void MainWindow::saveSession() {
  m_sessionFile.isEmpty() ? saveSessionAs() : writeSession(m_sessionFile);
}

void MainWindow::saveSessionAs() {
  const QString suggested =
      m_sessionFile.isEmpty() ? suggestedName() + QStringLiteral("-session.json") : m_sessionFile;
  const QString path =
      askWhereToSave(this, {tr("Save the session"), suggested, {tr("Limn session (*.json)")}});
  if (!path.isEmpty())
    writeSession(path);
}

void MainWindow::writeSession(const QString& path) {
  SessionDocument session = sessionDocument();
  const std::filesystem::path target(path.toStdString());
  session.scene.volume = volumeSeenFrom(target);
  try {
    writeFileAtomically(target, sessionToJson(session));
  } catch (const Error& error) {
    showSaveError(QString::fromStdString(error.what()));
    return;
  }
  m_sessionFile = QFileInfo(path).absoluteFilePath();
  m_session.undoStack().setClean();
  m_settled = sessionDocument();
  noteChange();
  updateTitle();
  noteSaved(path);
}

void MainWindow::keepSessions() {
  try {
    m_keeper = std::make_unique<SessionKeeper>(m_folders.sessions, [this] { return unsavedSession(); });
    connect(m_keeper.get(), &SessionKeeper::abandonedFound, this, &MainWindow::offerAbandoned);
    connect(&m_keeper->autosave(), &Autosave::failed, this, &MainWindow::sayUnsafe);
    connect(&m_keeper->autosave(), &Autosave::recovered, m_unsafe, &QWidget::hide);
  } catch (const Error& error) {
    m_notKept = QString::fromStdString(error.what());
    sayUnsafe(m_notKept);
    return;
  }
  offerAbandoned();
}

void MainWindow::sayUnsafe(const QString& why) {
  m_unsafe->show(MessageBar::Kind::warning, tr("Unsaved work is not safe at present. %1").arg(why));
}

void MainWindow::noteChange() {
  if (m_keeper)
    m_keeper->autosave().noteChange();
}

// What has to be saved so that a crash loses nothing; nothing as long as everything is as it was opened.
std::optional<SessionDocument> MainWindow::unsavedSession() const {
  if (!m_session.scene().volume)
    return std::nullopt;
  SessionDocument session = sessionDocument();
  const bool isEdited = m_session.isEdited();
  SessionDocument otherwise = m_settled;
  otherwise.panel = session.panel; // alone no loss
  if (!isEdited && session == otherwise)
    return std::nullopt;
  session.isUnsaved = isEdited;
  session.savedAs = m_sessionFile.toStdString();
  session.label = labelOfShown().toStdString();
  return session;
}

// Nobody is asked as long as what is left behind can be had back.
bool MainWindow::mayLeaveScene() {
  const bool keeps = m_keeper || !m_notKept.isEmpty();
  if (!keeps || !m_session.scene().volume || !m_session.isEdited())
    return true;
  if (!m_keeper)
    return askBeforeLosing(m_notKept);
  try {
    m_keeper->keep(*unsavedSession());
    return true;
  } catch (const Error& error) {
    return askBeforeLosing(QString::fromStdString(error.what()));
  }
}

bool MainWindow::askBeforeLosing(const QString& why) {
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("The changes to this session are not saved, and Limn cannot keep them for you."),
                  QMessageBox::NoButton, this);
  box.setObjectName(QStringLiteral("unsavedChanges"));
  box.setInformativeText(why);
  QPushButton* save = box.addButton(tr("Save session…"), QMessageBox::AcceptRole);
  QPushButton* lose = box.addButton(tr("Lose the changes"), QMessageBox::DestructiveRole);
  box.addButton(tr("Cancel"), QMessageBox::RejectRole);
  box.setDefaultButton(save);
  box.exec();
  if (box.clickedButton() == save)
    saveSession();
  return box.clickedButton() == lose || !m_session.isEdited();
}

void MainWindow::offerAbandoned() {
  const std::optional<std::filesystem::path> file = m_keeper ? m_keeper->abandoned() : std::nullopt;
  if (!file) {
    m_recovery->hide();
    return;
  }
  m_recovery->show(MessageBar::Kind::question,
                   tr("Limn ended unexpectedly. Restore the last session (%1)?").arg(described(*file)), {},
                   {tr("Restore"), [this, file = *file] { restoreSession(file); }},
                   {tr("Discard"), [this, file = *file] {
                      m_keeper->forget(file);
                      offerAbandoned();
                    }});
}

void MainWindow::restoreSession(const std::filesystem::path& file) {
  startReading({QString::fromStdString(file.string()), {}, true}, tr("Restoring the session"));
}

void MainWindow::refreshUnsavedMenu() {
  m_unsavedMenu->clear();
  for (const std::filesystem::path& file : m_keeper ? m_keeper->kept() : std::vector<std::filesystem::path>())
    m_unsavedMenu->addAction(described(file).replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                             [this, file] { restoreSession(file); });
  m_unsavedMenu->setEnabled(!m_unsavedMenu->isEmpty());
}

} // namespace limn
