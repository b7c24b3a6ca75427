// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/suggestions/SuggestionDesk.h"

#include "app/document/Session.h"
#include "app/suggestions/SuggestionDialog.h"
#include "app/suggestions/SuggestionText.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"
#include "widgets/Translated.h"

#include <QAction>
#include <QMetaObject>

#include <exception>

namespace limn {
namespace {

constexpr int restBeforeLookMs = 250;

} // namespace

SuggestionDesk::SuggestionDesk(Session& session, QAction& suggest, QWidget& window)
    : QObject(&window), m_session(session), m_window(window) {
  connect(&suggest, &QAction::triggered, this, &SuggestionDesk::show);
  m_soon.setSingleShot(true);
  m_soon.setInterval(restBeforeLookMs);
  connect(&m_soon, &QTimer::timeout, this, &SuggestionDesk::lookAnew);
}

void SuggestionDesk::showScene(const Scene& scene) {
  const Looked now{scene.volume, scene.keep, scene.crop};
  if (now == m_at)
    return markShown();
  const bool isSameVolume = now.volume == m_at.volume;
  m_thread.request_stop();
  m_at = now;
  m_isKnown = false;
  if (isSameVolume && m_dialog && m_dialog->isVisible())
    return m_soon.start();
  m_suggestions.clear();
  lookAnew();
}

void SuggestionDesk::lookAnew() {
  if (m_dialog && m_dialog->isVisible() && m_at.volume)
    look();
  else if (m_dialog)
    m_dialog->close();
}

void SuggestionDesk::show() {
  if (!m_at.volume)
    return;
  if (!m_dialog) {
    m_dialog = new SuggestionDialog(&m_window);
    connect(m_dialog, &SuggestionDialog::previewed, this, &SuggestionDesk::preview);
    connect(m_dialog, &SuggestionDialog::chosen, this, &SuggestionDesk::accept);
  }
  if (!m_isKnown)
    look();
  markShown();
  if (!m_dialog->isVisible())
    place();
  m_dialog->show();
  m_dialog->raise();
}

void SuggestionDesk::markShown() {
  if (!m_dialog || !m_isKnown)
    return;
  const TransferFunction& function = m_session.scene().transferFunction;
  std::vector<bool> shown;
  for (const Suggestion& suggestion : m_suggestions)
    shown.push_back(classify(function, suggestion.top.value).opacity >= suggestion.top.opacity);
  m_dialog->setShown(shown);
}

// Beside the pictures that it is about, over the properties.
void SuggestionDesk::place() {
  const QPoint corner = m_window.mapToGlobal(QPoint(m_window.width(), 0));
  m_dialog->move(corner + QPoint(-m_dialog->width() - 8, 64));
}

void SuggestionDesk::look() {
  m_soon.stop();
  m_dialog->showProgress(0.0);
  m_thread = std::jthread([this, at = m_at](const std::stop_token& stop) { search(at, stop); });
}

// On a worker thread. Only what was asked for last counts.
void SuggestionDesk::search(const Looked& at, const std::stop_token& stop) {
  std::vector<Suggestion> suggestions;
  QString problem;
  const Effort effort{0, [&stop] { return stop.stop_requested(); },
                      [this, &at](double fraction) {
                        QMetaObject::invokeMethod(
                            this,
                            [this, at, fraction] {
                              if (at == m_at && !m_isKnown && m_dialog)
                                m_dialog->showProgress(fraction);
                            },
                            Qt::QueuedConnection);
                      }};
  try {
    const KeptVoxels kept(at.volume->grid(), at.keep, at.crop);
    suggestions = suggestionsFor(boundariesOf(*at.volume, kept, effort), at.volume->range());
  } catch (const Cancelled&) {
    return;
  } catch (const std::exception& error) {
    problem = tr("Boundaries cannot be looked for: %1.").arg(translated(error));
  }
  QMetaObject::invokeMethod(
      this, [this, at, suggestions, problem] { receive(at, suggestions, problem); }, Qt::QueuedConnection);
}

void SuggestionDesk::receive(const Looked& at, const std::vector<Suggestion>& suggestions,
                             const QString& problem) {
  if (at != m_at || !m_dialog)
    return;
  m_isKnown = problem.isEmpty();
  m_suggestions = suggestions;
  if (!m_isKnown)
    return m_dialog->showSentence(problem);
  m_dialog->setSuggestions(m_suggestions, names());
  markShown();
}

void SuggestionDesk::preview(const std::optional<std::size_t>& index) {
  Scene scene = m_session.scene();
  if (index && *index < m_suggestions.size())
    scene.transferFunction = withBand(scene.transferFunction, m_suggestions[*index]);
  emit previewed(scene);
}

void SuggestionDesk::accept(std::size_t index) {
  const Suggestion& used = m_suggestions[index];
  m_session.setTransferFunction(
      withBand(m_session.scene().transferFunction, used),
      {nextGestureId(), tr("use the band %1").arg(boundaryName(used.boundary, names()))});
}

ValueNames SuggestionDesk::names() const {
  return {QString::fromStdString(m_at.volume->info().unit), looksLikeHounsfield(*m_at.volume)};
}

} // namespace limn
