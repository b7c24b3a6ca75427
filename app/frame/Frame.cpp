// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/Frame.h"

#include "app/document/DocumentText.h"
#include "app/language/Language.h"
#include "app/window/WindowContext.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/theme/LookStyle.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QApplication>
#include <QEvent>
#include <QFontMetrics>
#include <QList>
#include <QMenu>
#include <QPainter>
#include <QStatusBar>
#include <QToolBar>

#include <utility>

namespace limn {
namespace {

constexpr int beside = 16; // of the words, pixels
constexpr int above = 8;

// The sample's patient is an example.
bool namesSomebody(const OpenDocument& document) {
  const auto& volume = document.scene().volume;
  if (!volume || document.request().source == QLatin1String("sample"))
    return false;
  return !volume->info().patient.name.empty() || !volume->info().patient.id.empty();
}

QList<QWidget*> panelsOf(const WindowContext& context) {
  return context.docks.contentsAt(Qt::LeftDockWidgetArea) + QList<QWidget*>{&context.view, &context.planes} +
         context.docks.contentsAt(Qt::BottomDockWidgetArea) +
         context.docks.contentsAt(Qt::RightDockWidgetArea);
}

// How the window looks and which language it speaks (addLanguages) are choices in the settings, kept for the
// next time. The data of the actions are the words there.
void addThemes(WindowContext& context) {
  QActionGroup* themes = context.actions.addGroup();
  const auto add = [&](const char* word, const QString& text) {
    context.actions.addChoice(*themes, QStringLiteral("theme-") + QLatin1String(word), QLatin1String(word),
                              {.text = text});
  };
  add("system", Frame::tr("Follow the system"));
  add("light", Frame::tr("Light"));
  add("dark", Frame::tr("Dark"));
  add("contrast", Frame::tr("High contrast"));
  checkOnly(*themes, context.settings.theme());
  context.actions.addSetting({.row = 1, .label = Frame::tr("Theme"), .choice = themes});
  QObject::connect(themes, &QActionGroup::triggered, &context.window, [&context](const QAction* chosen) {
    const QString theme = chosen->data().toString();
    context.settings.setTheme(theme);
    applyTheme(*static_cast<QApplication*>(QApplication::instance()), themeNamed(theme));
  });
}

// Not folded away to nothing. What lies over it is part of it: a child may show the whole picture.
bool isSeen(const QWidget& widget) {
  if (!widget.isVisible())
    return false;
  QRect seen = widget.rect();
  for (const QWidget* at = &widget; !at->isWindow(); at = at->parentWidget())
    seen = seen.translated(at->pos()) & at->parentWidget()->rect();
  return !seen.isEmpty();
}

} // namespace

FadingNote::FadingNote(QWidget& below) : QWidget(&below) {
  setObjectName(QStringLiteral("fadingNote"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  below.installEventFilter(this);
  connect(&m_fade, &LabelFade::changed, this, [this] {
    setVisible(m_fade.opacity() > 0.0);
    update();
  });
  hide();
}

void FadingNote::say(const QString& text) {
  m_text = text;
  setAccessibleName(text);
  place();
  show();
  raise();
  m_fade.wake();
}

// In the middle, below what stands at the upper edge of a picture.
void FadingNote::place() {
  const QSize words = fontMetrics().size(Qt::TextSingleLine, m_text);
  const QSize size = words + QSize(2 * beside, 2 * above);
  setGeometry((parentWidget()->width() - size.width()) / 2, 48, size.width(), size.height());
}

bool FadingNote::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    place();
  return QWidget::eventFilter(watched, event);
}

// Dark in every theme, as all that lies over pictures.
void FadingNote::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(m_fade.opacity());
  painter.setPen(QPen(QColor(134, 142, 155), 1.0));
  painter.setBrush(QColor(24, 27, 34));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6.0, 6.0);
  painter.setPen(Qt::white);
  painter.drawText(rect(), Qt::AlignCenter, m_text);
}

FocusMode::FocusMode(WindowContext& context)
    : QObject(&context.window), m_context(context),
      m_action(
          context.actions.add(QStringLiteral("pictureOnly"), {.text = tr("Picture without panels and cur&ve"),
                                                              .place = {Menu::view, 3, 20},
                                                              .shortcut = Qt::Key_F11,
                                                              .isCheckable = true})) {
  connect(m_action, &QAction::toggled, this, &FocusMode::set);
  connect(&context.view.input(), &ViewInput::maximiseRequested, m_action, &QAction::trigger);
}

void FocusMode::leave() {
  m_action->setChecked(false);
}

bool FocusMode::isOn() const {
  return m_action->isChecked();
}

void FocusMode::enter() {
  m_action->setChecked(true);
}

// What the user had closed before stays closed.
void FocusMode::set(bool isOn) {
  if (!isOn) {
    if (m_note)
      m_note->hide();
    for (const QPointer<QWidget>& bar : std::exchange(m_hidden, {}))
      if (bar)
        bar->show();
    return m_context.docks.showAgain();
  }
  m_context.docks.hideAll();
  const auto hide = [this](QWidget* bar) {
    if (bar->isHidden())
      return;
    m_hidden.emplace_back(bar);
    bar->hide();
  };
  for (QToolBar* bar : m_context.window.findChildren<QToolBar*>())
    hide(bar);
  hide(m_context.window.statusBar());
  if (!m_note)
    m_note = new FadingNote(*m_context.window.centralWidget());
  m_note->say(tr("F11 or Esc shows the panels again"));
}

PanelCycle::PanelCycle(ActionList& actions, const QList<QWidget*>& panels) {
  QAction* next =
      actions.add(QStringLiteral("nextPanel"), {.text = tr("&Next panel"), .shortcut = Qt::Key_F6});
  QAction* previous =
      actions.add(QStringLiteral("previousPanel"),
                  {.text = tr("&Previous panel"), .shortcut = QKeySequence(Qt::SHIFT | Qt::Key_F6)});
  actions.addMenu(tr("&Keyboard focus"), {Menu::view, 3, 21})->addActions({next, previous});
  for (QWidget* area : panels)
    m_panels.append({area, nullptr});
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { note(now); });
  connect(next, &QAction::triggered, this, [this] { step(1); });
  connect(previous, &QAction::triggered, this, [this] { step(-1); });
}

// The innermost: the slices lie around the picture.
PanelCycle::Panel* PanelCycle::panelOf(const QWidget* widget) {
  for (Panel& panel : m_panels)
    if (widget && (panel.area == widget || panel.area->isAncestorOf(widget)))
      return &panel;
  return nullptr;
}

void PanelCycle::note(QWidget* now) {
  if (Panel* panel = panelOf(now))
    panel->last = now;
}

void PanelCycle::step(int direction) {
  const qsizetype count = m_panels.size();
  const Panel* here = panelOf(QApplication::focusWidget());
  // From nowhere the first step leads to the first panel, or the last.
  const qsizetype from = here ? here - m_panels.constData() : direction > 0 ? -1 : count;
  for (qsizetype steps = 1; steps <= count; ++steps) {
    Panel& panel = m_panels[((from + direction * steps) % count + count) % count];
    if (&panel == here || !isSeen(*panel.area))
      continue;
    QWidget* entry = panel.last && takesKeys(*panel.last) && isSeen(*panel.last)
                         ? panel.last.data()
                         : keyboardEntryOf(*panel.area);
    if (!entry || panelOf(entry) != &panel)
      continue;
    entry->window()->activateWindow(); // a dock may float
    entry->setFocus(Qt::TabFocusReason);
    return;
  }
}

TitleController::TitleController(WindowContext& context)
    : QObject(&context.window), m_context(context),
      m_patientInTitle(context.actions.add(
          QStringLiteral("patientInTitle"),
          {.text = tr("Show the patient's &name in the title bar"), .isCheckable = true})) {
  context.actions.addSetting({.row = 5, .action = m_patientInTitle});
  m_patientInTitle->setChecked(context.settings.patientIsShown().value_or(false));
  connect(m_patientInTitle, &QAction::toggled, this, &TitleController::choose);
  connect(&context.session.undoStack(), &QUndoStack::cleanChanged, this,
          [this](bool isClean) { m_context.window.setWindowModified(!isClean); });
}

void TitleController::show() {
  m_context.window.setWindowModified(m_context.document.isEdited());
  m_context.window.setWindowTitle(titleOf(m_context.document, m_patientInTitle->isChecked()));
  if (m_context.settings.patientIsShown() || !namesSomebody(m_context.document))
    m_context.patient.hide();
  else
    ask();
}

void TitleController::choose(bool isShown) {
  m_context.settings.setPatientIsShown(isShown);
  show();
}

void TitleController::ask() {
  m_context.patient.show(MessageBar::Kind::question,
                         tr("This volume carries its patient's name. Show it in the title bar?"), {},
                         {tr("Name the patient"), [this] { m_patientInTitle->setChecked(true); }},
                         {tr("Do not show it"), [this] { choose(false); }});
}

// The words of a window are those of the language it is made in: another one comes with another window.
void Frame::addLanguages() {
  ActionList& actions = m_context.actions;
  QActionGroup* languages = actions.addGroup();
  const auto add = [&](const QString& code, const QString& text) {
    actions.addChoice(*languages, QStringLiteral("language-") + code, code,
                      {.text = text, .toolTip = tr("The window speaks it at once.")});
  };
  add(QStringLiteral("system"), tr("Follow the system"));
  for (const Language& language : languagesSpoken())
    add(language.code, language.name);
  checkOnly(*languages, m_context.settings.language());
  actions.addSetting(
      {.row = 2,
       .label = tr("Language"),
       .choice = languages,
       .consequence = tr("The window speaks this language as soon as nothing is being read, written or "
                         "measured, no measurement, line or piece is unfinished, no other dialog is open and "
                         "no picture waits to be saved elsewhere.")});
  connect(languages, &QActionGroup::triggered, this, [this](const QAction* chosen) {
    const QString language = chosen->data().toString();
    m_context.settings.setLanguage(language);
    emit languageChosen(language);
  });
}

Frame::Memory Frame::memory() const {
  return {m_focus.isOn(), !m_context.tour.isHidden(), m_dialogs.memory()};
}

void Frame::takeOver(const Memory& memory) {
  if (memory.isPictureOnly)
    m_focus.enter();
  if (memory.offersTour)
    m_tour.offer();
  m_dialogs.takeOver(memory.dialogs);
}

Frame::Frame(WindowContext& context)
    : QObject(&context.window), m_context(context), m_focus(context),
      m_panels(context.actions, panelsOf(context)), m_title(context), m_dialogs(context), m_tour(context) {
  addThemes(context);
  addLanguages();
  const QAction* quit =
      context.actions.add(QStringLiteral("quit"),
                          {.text = tr("&Quit"), .place = {Menu::file, 3, 2}, .shortcut = QKeySequence::Quit});
  connect(quit, &QAction::triggered, &context.window, &QWidget::close);
  context.docks.arrange(context.actions);
  context.actions.arrange();
  context.docks.restore(context.settings.windowGeometry(), context.settings.windowState());
}

} // namespace limn
