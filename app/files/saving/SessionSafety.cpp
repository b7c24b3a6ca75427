// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/SessionSafety.h"

#include "app/document/DocumentText.h"
#include "app/window/WindowContext.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/panels/ViewPanels.h"

#include <QDateTime>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace limn {
namespace {

QDateTime timeOf(const std::filesystem::path& file) {
  return QFileInfo(QString::fromStdString(file.string())).lastModified();
}

// Whether a session is of the volume that is open: of several series in a folder, of the same.
bool isOf(const OpenDocument& document, const std::filesystem::path& file) {
  try {
    const SessionDocument session = parseSession(readTextFile(file), "session");
    return session.scene.volume == document.volumePath() && // kept with its whole path
           session.series == document.request().options.read.series;
  } catch (const Error&) {
    return false;
  }
}

// "CT 512×512×120, 21 Nov 2026, 14:03". What cannot be read still has a time.
QString described(const std::filesystem::path& file) {
  QString label;
  try {
    label = QString::fromStdString(parseSession(readTextFile(file), "session").label);
  } catch (const Error&) {
    // Opening it says why.
  }
  const QString time = momentText(timeOf(file));
  return label.isEmpty() ? time : label + QStringLiteral(", ") + time;
}

} // namespace

SessionSafety::SessionSafety(WindowContext& context, std::function<SessionDocument()> session)
    : QObject(&context.window), m_context(context),
      m_unsaved(context.actions.addMenu(tr("Open &unsaved session"), {Menu::file, 1, 7})),
      m_session(std::move(session)) {
  m_unsaved->setObjectName(QStringLiteral("unsavedSessions"));
  m_unsaved->setToolTip(tr("Sessions that were left with unsaved changes."));
  connect(&context.actions.menu(Menu::file), &QMenu::aboutToShow, this, &SessionSafety::refreshMenu);
  connect(&context.view.emptyPanel(), &EmptyPanel::continueRequested, this, &SessionSafety::continueLast);
  connect(&context.view, &CompareView::wipeMoved, this, &SessionSafety::noteChange);
  connect(&context.docks, &Docks::panelChanged, this, &SessionSafety::noteChange);
  connect(&context.session, &Session::planesChanged, this, &SessionSafety::noteChange);
  connect(&context.session, &Session::measurementsChanged, this, &SessionSafety::noteChange);
  connect(&context.session, &Session::viewsChanged, this, &SessionSafety::noteChange);
}

void SessionSafety::begin(std::unique_ptr<SessionKeeper> keeper) {
  const auto current = [this] { return m_context.document.unsaved(m_session()); };
  try {
    m_keeper =
        keeper ? std::move(keeper) : std::make_unique<SessionKeeper>(m_context.folders.sessions, current);
    m_keeper->autosave().follow(current);
    connect(m_keeper.get(), &SessionKeeper::abandonedFound, this, &SessionSafety::offerAbandoned);
    connect(&m_keeper->autosave(), &Autosave::failed, this, &SessionSafety::sayUnsafe);
    connect(&m_keeper->autosave(), &Autosave::recovered, &m_context.unsafe, &QWidget::hide);
  } catch (const Error& error) {
    m_notKept = translated(error.sentence());
    sayUnsafe(m_notKept);
    return;
  }
  if (const std::optional<QString>& problem = m_keeper->autosave().problem())
    sayUnsafe(*problem);
  offerAbandoned();
  tellUnfinished();
}

std::unique_ptr<SessionKeeper> SessionSafety::giveKeeper() {
  if (m_keeper)
    m_keeper->autosave().follow({});
  return std::move(m_keeper);
}

void SessionSafety::noteChange() {
  if (m_keeper)
    m_keeper->autosave().noteChange();
}

std::function<void()> SessionSafety::savingOfNow() {
  return m_keeper ? std::function<void()>(m_keeper->autosave().savingOfNow()) : nullptr;
}

std::optional<QString> SessionSafety::keepUnsaved() {
  m_context.planes.endLooseDrag(); // what lacks places is not kept
  if (!keeps() || !m_context.document.scene().volume || !m_context.document.isEdited())
    return std::nullopt;
  if (!m_keeper)
    return m_notKept;
  try {
    const SessionDocument left = *m_context.document.unsaved(m_session());
    m_keeper->keep(left);
    tellUnfinished();
    m_left = left.label;
    return std::nullopt;
  } catch (const Error& error) {
    return translated(error.sentence());
  }
}

// Nobody is asked as long as what is left behind can be had back.
bool SessionSafety::mayLeave() {
  const std::optional<QString> why = keepUnsaved();
  return !why || askBeforeLosing(*why);
}

SessionSafety::Kept SessionSafety::keptNow(bool hasLeft, bool isFirst) const {
  const auto files = m_keeper ? m_keeper->kept() : std::vector<std::filesystem::path>();
  const OpenDocument& document = m_context.document;
  if (files.empty() || !document.scene().volume)
    return {};
  Kept kept;
  if (hasLeft)
    kept.left = files.front();
  const auto found =
      std::ranges::find_if(files, [&document](const auto& file) { return isOf(document, file); });
  // Whoever opened one of the kept sessions chose among them.
  if (found != files.end() && *found != kept.left && !document.request().isUnsavedSession)
    kept.ofThis = *found;
  // One offer at a time: what a crash left behind goes before what was closed.
  else if (!hasLeft && isFirst && !m_keeper->abandoned())
    kept.left = files.front();
  return kept;
}

// The page without a volume offers it itself.
void SessionSafety::sayWhatIsKept() {
  tellUnfinished(); // what was opened may be newer
  std::optional<std::string> label = std::exchange(m_left, std::nullopt);
  Kept kept = keptNow(label.has_value(), std::exchange(m_saysWithFirst, false));
  kept.label = std::move(label);
  tellAgain(kept);
}

std::optional<SessionSafety::Kept> SessionSafety::told() const {
  return m_context.kept.isWanted() ? std::optional(m_told) : std::nullopt;
}

void SessionSafety::tellAgain(const Kept& kept) {
  m_told = kept;
  const QString left = kept.label          ? QString::fromStdString(*kept.label)
                       : kept.left.empty() ? QString()
                                           : described(kept.left);
  const auto opening = [this](const QString& text, const std::filesystem::path& file) {
    return MessageBar::Action{text, [this, file = QString::fromStdString(file.string())] {
                                m_context.kept.hide();
                                emit restoreRequested(file);
                              }};
  };
  const auto say = [this](const QString& sentence, const MessageBar::Action& action,
                          const MessageBar::Action& other = {}) {
    m_context.kept.show(MessageBar::Kind::note, sentence, {}, action, {}, other);
  };
  if (kept.ofThis.empty() && kept.left.empty())
    m_context.kept.hide();
  else if (kept.ofThis.empty())
    say(tr("Your work on %1 is kept.").arg(left), opening(tr("Bring back"), kept.left));
  else if (kept.left.empty())
    say(tr("Your earlier work on this volume (%1) is kept.").arg(momentText(timeOf(kept.ofThis))),
        opening(tr("Continue"), kept.ofThis));
  else
    say(tr("Your earlier work on this volume (%1) is kept, and so is your work on %2.")
            .arg(momentText(timeOf(kept.ofThis)), left),
        opening(tr("Continue"), kept.ofThis), opening(tr("Bring back the other"), kept.left));
}

bool SessionSafety::askBeforeLosing(const QString& why) {
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("The changes to this session are not saved, and Limn cannot keep them for you."),
                  QMessageBox::NoButton, &m_context.window);
  box.setObjectName(QStringLiteral("unsavedChanges"));
  box.setInformativeText(why);
  QPushButton* save = box.addButton(tr("Save session…"), QMessageBox::AcceptRole);
  QPushButton* lose = box.addButton(tr("Lose the changes"), QMessageBox::DestructiveRole);
  box.addButton(tr("Cancel"), QMessageBox::RejectRole);
  box.setDefaultButton(save);
  box.exec();
  if (box.clickedButton() == save)
    emit saveRequested();
  return box.clickedButton() == lose || !m_context.document.isEdited();
}

void SessionSafety::sayUnsafe(const QString& why) {
  m_context.unsafe.show(MessageBar::Kind::warning, tr("Unsaved work is not safe at present. %1").arg(why));
}

void SessionSafety::takeOver(const QString& file, bool isWhole) {
  if (m_keeper && m_keeper->autosave().savingOfNow()() && isWhole)
    m_keeper->forget(file.toStdString());
  offerAbandoned();
  tellUnfinished();
}

void SessionSafety::tellUnfinished() {
  // One offer at a time: what a crash left behind goes before what was closed.
  const bool isOffered = m_keeper && m_keeper->abandoned();
  const auto kept = m_keeper && !isOffered ? m_keeper->kept() : std::vector<std::filesystem::path>();
  EmptyPanel& page = m_context.view.emptyPanel();
  if (kept.empty())
    return page.setUnfinished({});
  // Saving a session to a file counts as opening it.
  const QList<RecentSource> recent = m_context.settings.recentSources();
  page.setUnfinished(described(kept.front()),
                     recent.isEmpty() || timeOf(kept.front()) > recent.front().openedAt());
}

void SessionSafety::continueLast() {
  const auto kept = m_keeper ? m_keeper->kept() : std::vector<std::filesystem::path>();
  if (!kept.empty())
    emit restoreRequested(QString::fromStdString(kept.front().string()));
}

void SessionSafety::offerAbandoned() {
  const std::optional<std::filesystem::path> file = m_keeper ? m_keeper->abandoned() : std::nullopt;
  if (!file) {
    m_context.recovery.hide();
    return;
  }
  m_context.recovery.show(
      MessageBar::Kind::question,
      tr("Limn ended unexpectedly. Restore the last session (%1)?").arg(described(*file)), {},
      {tr("Restore"), [this, file = *file] { emit restoreRequested(QString::fromStdString(file.string())); }},
      {tr("Discard"), [this, file = *file] {
         m_keeper->forget(file);
         offerAbandoned();
         tellUnfinished();
       }});
}

void SessionSafety::end() {
  if (m_keeper)
    m_keeper->close();
  m_keeper.reset();
}

void SessionSafety::refreshMenu() {
  m_unsaved->clear();
  for (const std::filesystem::path& file : m_keeper ? m_keeper->kept() : std::vector<std::filesystem::path>())
    m_unsaved->addAction(described(file).replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                         [this, file] { emit restoreRequested(QString::fromStdString(file.string())); });
  m_unsaved->setEnabled(!m_unsaved->isEmpty());
}

} // namespace limn
