// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/SpokenWindow.h"

#include "app/language/Language.h"

#include <QApplication>
#include <QDialog>
#include <QLocale>
#include <QScopeGuard>

#include <utility>

namespace limn {
namespace {

constexpr int againMs = 250;

bool soundAlike(const QString& asked, const QString& other) {
  const Speech a = speechFor(asked, QLocale::system());
  const Speech b = speechFor(other, QLocale::system());
  return a.code == b.code && a.locale == b.locale;
}

// A field takes what was typed when it loses the keyboard. Settings and guide have nothing to enter, and
// the keyboard is to stay there.
void enterWhatIsTyped() {
  QWidget* field = QApplication::focusWidget();
  if (field && !qobject_cast<QDialog*>(field->window()))
    field->clearFocus();
}

} // namespace

SpokenWindow::SpokenWindow(UserFolders folders, const std::optional<MemoryBudget>& memory,
                           const QString& language)
    : m_folders(std::move(folders)), m_memory(memory), m_language(language),
      m_window(std::make_unique<MainWindow>(m_folders, m_memory)) {
  m_again.setSingleShot(true);
  m_again.setInterval(againMs);
  follow();
}

// Queued: the window must not go while it tells.
void SpokenWindow::follow() {
  connect(m_window.get(), &MainWindow::languageChosen, this, &SpokenWindow::speak, Qt::QueuedConnection);
}

// What is chosen last counts; what is under way is waited for.
void SpokenWindow::speak(const QString& language) {
  m_again.stop();
  m_again.disconnect(this);
  if (soundAlike(language, m_language)) {
    m_language = language;
    return;
  }
  if (!mayReplace()) {
    connect(&m_again, &QTimer::timeout, this, [this, language] { speak(language); });
    m_again.start();
    return;
  }
  m_language = language;
  replace();
}

// What is entered may begin work.
bool SpokenWindow::mayReplace() const {
  if (!m_window->isVisible())
    return true;
  if (m_window->isBusy())
    return false;
  enterWhatIsTyped();
  return !m_window->isBusy();
}

void SpokenWindow::replace() {
  const bool quits = QApplication::quitOnLastWindowClosed();
  QApplication::setQuitOnLastWindowClosed(false); // for a moment there is none
  const auto restore = qScopeGuard([this, quits] {
    QApplication::setQuitOnLastWindowClosed(quits);
    if (!m_window) // it cannot be made: a program that nobody sees must not stay
      QCoreApplication::exit(1);
  });
  WindowHandover handed = m_window->handOver();
  m_window.reset();
  useLanguage(*QCoreApplication::instance(), m_language);
  m_window = std::make_unique<MainWindow>(m_folders, m_memory, nullptr, std::move(handed.open));
  follow();
  m_window->show();
  m_window->takeOver(std::move(handed));
  emit replaced();
}

} // namespace limn
