// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/curve/SuggestionController.h"

#include "app/panels/curve/SuggestionDialog.h"
#include "app/window/WindowContext.h"
#include "scene/presets/PresetFit.h"

namespace limn {
namespace {

constexpr int restBeforeLookMs = 250;

} // namespace

SuggestionController::SuggestionController(WindowContext& context)
    : QObject(&context.window), m_context(context) {
  const QAction* suggest =
      context.actions.add(QStringLiteral("suggest"),
                          {.text = tr("S&uggest from boundaries…"),
                           .place = {Menu::preset, 1, 4},
                           .toolTip = tr("Finds where materials touch in this volume and proposes a band of "
                                         "the curve for each"),
                           .needsVolume = true});
  connect(suggest, &QAction::triggered, this, &SuggestionController::show);
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
  m_soon.setSingleShot(true);
  m_soon.setInterval(restBeforeLookMs);
  connect(&m_soon, &QTimer::timeout, this, &SuggestionController::lookAnew);
}

void SuggestionController::showScene(const Scene& scene) {
  const Looked now{scene.volume, scene.keep, scene.crop};
  if (now == m_at)
    return markShown();
  const bool isSameVolume = now.volume == m_at.volume;
  m_search.cancel();
  m_at = now;
  m_isKnown = false;
  if (isSameVolume && m_dialog && m_dialog->isVisible())
    return m_soon.start();
  m_suggestions.clear();
  lookAnew();
}

void SuggestionController::lookAnew() {
  if (m_dialog && m_dialog->isVisible() && m_at.volume)
    look();
  else if (m_dialog)
    m_dialog->close();
}

void SuggestionController::show() {
  if (!m_at.volume)
    return;
  if (!m_dialog) {
    m_dialog = new SuggestionDialog(&m_context.window);
    connect(m_dialog, &SuggestionDialog::previewed, this, &SuggestionController::preview);
    connect(m_dialog, &SuggestionDialog::chosen, this, &SuggestionController::accept);
    connect(&m_search, &BackgroundWork::progressed, m_dialog, &SuggestionDialog::showProgress);
    connect(&m_search, &BackgroundWork::failed, m_dialog, [this](const QString& why) {
      m_suggestions.clear();
      m_dialog->showSentence(tr("Boundaries cannot be looked for: %1.").arg(why));
    });
  }
  if (!m_isKnown)
    look();
  markShown();
  if (!m_dialog->isVisible())
    place();
  m_dialog->show();
  m_dialog->raise();
}

void SuggestionController::markShown() {
  if (!m_dialog || !m_isKnown)
    return;
  const TransferFunction& function = m_context.session.scene().transferFunction;
  std::vector<bool> shown;
  for (const Suggestion& suggestion : m_suggestions)
    shown.push_back(classify(function, suggestion.top.value).opacity >= suggestion.top.opacity);
  m_dialog->setShown(shown);
}

// Beside the pictures that it is about, over the properties.
void SuggestionController::place() {
  const QPoint corner = m_context.window.mapToGlobal(QPoint(m_context.window.width(), 0));
  m_dialog->move(corner + QPoint(-m_dialog->width() - 8, 64));
}

void SuggestionController::look() {
  m_soon.stop();
  m_dialog->showProgress(0.0);
  m_search.start([this, at = m_at](const Effort& effort) -> BackgroundWork::Deliver {
    const KeptVoxels kept(at.volume->grid(), at.keep, at.crop);
    auto suggestions = suggestionsFor(boundariesOf(*at.volume, kept, effort), at.volume->range());
    return [this, suggestions = std::move(suggestions)] { receive(suggestions); };
  });
}

void SuggestionController::receive(const std::vector<Suggestion>& suggestions) {
  m_isKnown = true;
  m_suggestions = suggestions;
  m_dialog->setSuggestions(m_suggestions, names());
  markShown();
}

void SuggestionController::preview(const std::optional<std::size_t>& index) {
  Scene scene = m_context.session.scene();
  if (index && *index < m_suggestions.size())
    scene.transferFunction = withBand(scene.transferFunction, m_suggestions[*index]);
  emit previewed(scene);
}

void SuggestionController::accept(std::size_t index) {
  const Suggestion& used = m_suggestions[index];
  m_context.session.setTransferFunction(
      withBand(m_context.session.scene().transferFunction, used),
      {nextGestureId(), tr("use the band %1").arg(boundaryName(used.boundary, names())), true});
}

ValueNames SuggestionController::names() const {
  return {QString::fromStdString(m_at.volume->info().unit), looksLikeHounsfield(*m_at.volume)};
}

} // namespace limn
