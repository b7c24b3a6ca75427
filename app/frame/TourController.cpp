// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/TourController.h"

#include "app/window/WindowContext.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/theme/Theme.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/Titles.h"

#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace limn {
namespace {

// Moved by no more than it takes.
QRect inside(QRect box, const QRect& window) {
  box.moveLeft(std::max(window.left(), std::min(box.left(), window.right() - box.width() + 1)));
  box.moveTop(std::max(window.top(), std::min(box.top(), window.bottom() - box.height() + 1)));
  return box;
}

struct Beside {
  CalloutSide side;
  int over; ///< pixels left once the box stands there
};

} // namespace

CalloutPlace calloutPlace(const QRect& target, const QSize& size, const QRect& window, int gap) {
  const QRect seen = target.intersected(window);
  const std::array<Beside, 4> rooms{{
      {CalloutSide::right, window.right() - seen.right() - size.width() - gap},
      {CalloutSide::left, seen.left() - window.left() - size.width() - gap},
      {CalloutSide::above, seen.top() - window.top() - size.height() - gap},
      {CalloutSide::below, window.bottom() - seen.bottom() - size.height() - gap},
  }};
  // What is lower than the box stands in a row with others, which a box beside it would hide.
  const bool isLow = seen.height() < size.height() && std::max(rooms[2].over, rooms[3].over) >= 0;
  const Beside best = *std::max_element(rooms.begin() + (isLow ? 2 : 0), rooms.end(),
                                        [](const Beside& a, const Beside& b) { return a.over < b.over; });
  const CalloutSide side = best.over < 0 ? CalloutSide::within : best.side;
  QRect box({}, size);
  box.moveCenter(seen.center());
  if (side == CalloutSide::right)
    box.moveLeft(seen.right() + 1 + gap);
  else if (side == CalloutSide::left)
    box.moveRight(seen.left() - 1 - gap);
  else if (side == CalloutSide::above)
    box.moveBottom(seen.top() - 1 - gap);
  else if (side == CalloutSide::below)
    box.moveTop(seen.bottom() + 1 + gap);
  box = inside(box, window);
  QPoint tip = box.center();
  if (side == CalloutSide::right || side == CalloutSide::left)
    tip = {side == CalloutSide::right ? seen.right() : seen.left(),
           std::clamp(seen.center().y(), box.top(), box.bottom())};
  else if (side != CalloutSide::within)
    tip = {std::clamp(seen.center().x(), box.left(), box.right()),
           side == CalloutSide::above ? seen.top() : seen.bottom()};
  return {box, side, tip};
}

namespace {

constexpr int arrow = 12; // pixels from the box to its tip, and around the box on every side
constexpr int textWidth = 300;
constexpr qreal radius = 8;

QPushButton* button(const QString& text, const char* name, QWidget& parent) {
  auto* made = new QPushButton(text, &parent);
  made->setObjectName(QLatin1String(name));
  made->setAutoDefault(true); // Enter presses it
  made->installEventFilter(&parent);
  return made;
}

} // namespace

Callout::Callout(QWidget& window)
    : QFrame(&window), m_title(new QLabel(this)), m_text(new QLabel(this)), m_place(new QLabel(this)),
      m_action(button({}, "tourAction", *this)), m_end(button(tr("End tour"), "tourEnd", *this)),
      m_back(button(tr("Back"), "tourBack", *this)), m_next(button({}, "tourNext", *this)) {
  setObjectName(QStringLiteral("tourCallout"));
  QFont bold = m_title->font();
  bold.setWeight(QFont::DemiBold);
  m_title->setFont(bold);
  m_text->setWordWrap(true);
  m_text->setFixedWidth(textWidth);
  m_place->setForegroundRole(QPalette::PlaceholderText);
  m_end->setFlat(true);
  auto* head = new QHBoxLayout;
  head->addWidget(m_title, 1);
  head->addWidget(m_place);
  auto* row = new QHBoxLayout;
  row->addWidget(m_end);
  row->addStretch();
  row->addWidget(m_back);
  row->addWidget(m_next);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(arrow + 16, arrow + 12, arrow + 16, arrow + 12);
  column->setSpacing(8);
  column->setSizeConstraint(QLayout::SetFixedSize);
  column->addLayout(head);
  column->addWidget(m_text);
  column->addWidget(m_action);
  column->addLayout(row);
  setTabOrder(m_next, m_action);
  setTabOrder(m_action, m_back);
  setTabOrder(m_back, m_end);
  connect(m_next, &QPushButton::clicked, this, &Callout::next);
  connect(m_back, &QPushButton::clicked, this, &Callout::back);
  connect(m_end, &QPushButton::clicked, this, &Callout::ended);
  connect(m_action, &QPushButton::clicked, this, &Callout::actionRequested);
}

void Callout::say(const CalloutText& text, bool isFirst, bool isLast) {
  setAccessibleName(QStringLiteral("%1, %2").arg(text.title, text.place));
  setAccessibleDescription(text.text);
  m_title->setText(text.title);
  m_text->setText(text.text);
  m_text->setFixedHeight(m_text->heightForWidth(textWidth)); // a box of fixed size asks for no other
  m_place->setText(text.place);
  m_action->setText(text.action);
  m_action->setVisible(!text.action.isEmpty());
  m_back->setVisible(!isFirst);
  m_next->setText(isLast ? tr("Done") : tr("Next"));
  m_next->setDefault(true);
  m_next->setAccessibleDescription(text.text); // read when it gets the keyboard
  m_end->setVisible(!isLast);
  layout()->activate();
}

void Callout::pointAt(const QRect& target) {
  const QSize box = size() - QSize(2 * arrow, 2 * arrow);
  m_at = calloutPlace(target, box, parentWidget()->rect().adjusted(4, 4, -4, -4), arrow);
  move(m_at.box.topLeft() - QPoint(arrow, arrow));
  update();
}

void Callout::takeFocus() {
  m_next->setFocus(Qt::OtherFocusReason);
}

void Callout::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath shape;
  shape.addRoundedRect(QRectF(rect()).adjusted(arrow, arrow, -arrow, -arrow), radius, radius);
  if (m_at.side != CalloutSide::within) {
    const QPointF tip = m_at.tip - pos();
    const QPointF foot(std::clamp(tip.x(), arrow + 16.0, width() - arrow - 16.0),
                       std::clamp(tip.y(), arrow + 16.0, height() - arrow - 16.0));
    const bool isBeside = m_at.side == CalloutSide::right || m_at.side == CalloutSide::left;
    const QPointF across = isBeside ? QPointF(0, arrow) : QPointF(arrow, 0);
    QPainterPath point;
    point.addPolygon(QPolygonF(
        {foot - across, isBeside ? QPointF(tip.x(), foot.y()) : QPointF(foot.x(), tip.y()), foot + across}));
    point.closeSubpath();
    shape = shape.united(point);
  }
  painter.setPen(QPen(colors.accent, 2));
  painter.setBrush(colors.raised);
  painter.drawPath(shape);
}

// A button would give the keyboard to its neighbour for an arrow, and at last to the picture.
bool Callout::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress)
    return QFrame::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Right && !m_end->isHidden())
    emit next();
  else if (key == Qt::Key_Left && !m_back->isHidden())
    emit back();
  return key == Qt::Key_Right || key == Qt::Key_Left || QFrame::eventFilter(watched, event);
}

void Callout::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape)
    emit ended();
  else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    emit next();
  else
    QFrame::keyPressEvent(event);
}

CalloutFrame::CalloutFrame(QWidget& window) : QWidget(&window) {
  setObjectName(QStringLiteral("tourFrame"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
}

void CalloutFrame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(themeColors(palette()).accent, 3));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 4, 4);
}

TourController::TourController(WindowContext& context) : QObject(&context.window), m_context(context) {
  const QAction* tour = context.actions.add(QStringLiteral("tour"),
                                            {.text = tr("&Tour of the window"), .place = {Menu::help, 1, 2}});
  connect(tour, &QAction::triggered, this, &TourController::start);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene&) {
    if (m_step != 0)
      return;
    const bool offered = m_offersSample;
    go(0);
    if (offered && !m_offersSample)
      m_callout->takeFocus(); // which the window gives to what was opened
  });
  connect(&context.view, &CompareView::told, this, [this] {
    if (m_step >= 0 && m_ofPicture != ofPicture())
      follow();
  });
}

void TourController::offer() {
  if (m_context.settings.tourIsKnown())
    return;
  m_context.tour.show(MessageBar::Kind::question,
                      tr("New to Limn? A tour shows the window in six short steps."), {},
                      {tr("Take the tour"), [this] { start(); }},
                      {tr("No, thank you"), [this] { m_context.settings.setTourIsKnown(true); }});
}

// What stands where the pictures are, as they call it.
QString TourController::ofPicture() const {
  const Comparison& shown = m_context.view.order().comparison;
  if (!shown.scene.volume || shown.layout == CompareLayout::single)
    return tr("View ▸ Side by side compares two ways of showing a volume.");
  const QString left = sideTitle(shown, 0), right = sideTitle(shown, 1);
  if (shown.layout == CompareLayout::difference)
    return tr("The colours show where \"%1\" and \"%2\" differ.").arg(left, right);
  return tr("At the left you see \"%1\", at the right \"%2\"; Space swaps them while held.").arg(left, right);
}

TourStep TourController::savingStep() const {
  const auto* bar = m_context.window.findChild<QToolBar*>();
  QWidget* camera = bar->widgetForAction(&m_context.actions.find("savePicture"));
  auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button")); // ActionList
  const bool isBehind = !camera->isVisible() && more && more->isVisible();
  const QString saves =
      isBehind ? tr("The camera, here behind », saves the picture with everything that made it.")
      : camera->isVisible() ? tr("The camera saves the picture with everything that made it.")
                            : tr("File ▸ Save picture saves the picture with everything that made it.");
  const QString help = tr("File has figures, sessions and more. F1 opens the guide, ? lists every key, and "
                          "Help has this tour again.");
  return {tr("Save, and find help"), saves + QLatin1Char(' ') + help, isBehind ? more : camera};
}

std::vector<TourStep> TourController::steps() const {
  const auto part = [this](const char* name) {
    return m_context.window.findChild<QWidget*>(QLatin1String(name));
  };
  return {
      {tr("Open"),
       tr("Open a DICOM folder or a file here, or drop one on the window. To look around first, take "
          "the sample head."),
       part("openButton")},
      {tr("Look"),
       tr("Drag with the left button to turn, turn the wheel to come nearer. %1 Esc always returns to "
          "turning.")
           .arg(ofPicture()),
       &m_context.view},
      {tr("Shape the curve"),
       tr("The curve says how solid each value is; behind it stands how often each occurs. Drag a point, or "
          "click the curve to add one: the picture follows. Ctrl+Z takes back what you did to the picture."),
       part("curveDock")},
      {tr("Choose a preset"),
       tr("Each shows what it makes of your volume. Point at one to try it, click to use it. "
          "1 to 9 in the picture are the first of the list."),
       part("presetDock")},
      {tr("Light and accuracy"),
       tr("Properties has projection, light and crop; Effects lists what is computed and why; Accuracy "
          "measures "
          "what exactness costs in time. The line below says how exact the picture is."),
       part("shadingDock")},
      savingStep(),
  };
}

void TourController::start() {
  m_context.tour.hide();
  m_context.settings.setTourIsKnown(true);
  if (m_step >= 0) {
    m_callout->takeFocus();
    return;
  }
  m_before = m_context.window.focusWidget();
  m_frame = new CalloutFrame(m_context.window);
  m_callout = new Callout(m_context.window);
  connect(m_callout, &Callout::next, this, [this] { go(m_step + 1); });
  connect(m_callout, &Callout::back, this, [this] { go(m_step - 1); });
  connect(m_callout, &Callout::ended, this, &TourController::end);
  connect(m_callout, &Callout::actionRequested, &m_context.actions.find("openSample"), &QAction::trigger);
  m_context.window.installEventFilter(this);
  go(0);
  m_callout->takeFocus();
}

void TourController::go(int step) {
  const std::vector<TourStep> all = steps();
  if (step < 0 || step >= static_cast<int>(all.size()))
    return end();
  m_step = step;
  say(all[step]);
  aimAt(*all[step].target);
  if (auto* dock = qobject_cast<QDockWidget*>(m_target)) {
    dock->show();
    dock->raise();
  }
  m_frame->show();
  m_callout->show();
  place();
}

void TourController::aimAt(QWidget& target) {
  if (m_target)
    m_target->removeEventFilter(this);
  m_target = &target;
  target.installEventFilter(this);
}

// The window may have become another meanwhile: tools find no room any more, one picture follows two.
void TourController::follow() {
  const TourStep step = steps()[static_cast<std::size_t>(m_step)];
  m_ofPicture = ofPicture();
  if (step.text != m_said)
    say(step);
  if (step.target != m_target)
    aimAt(*step.target);
  place();
}

void TourController::say(const TourStep& step) {
  m_said = step.text;
  m_ofPicture = ofPicture();
  const int count = static_cast<int>(steps().size());
  m_offersSample = m_step == 0 && !m_context.session.scene().volume;
  m_callout->say({step.title, step.text, tr("%1 of %2").arg(m_step + 1).arg(count),
                  m_offersSample ? tr("Open the sample head") : QString()},
                 m_step == 0, m_step == count - 1);
}

// A panel in a window of its own is spoken of from the middle of this one.
void TourController::place() {
  QWidget& window = m_context.window;
  const bool isHere = m_target->isVisible() && m_target->window() == &window;
  const QRect target = isHere ? QRect(m_target->mapTo(&window, QPoint()), m_target->size()) : window.rect();
  m_frame->setVisible(isHere);
  m_frame->setGeometry(target.adjusted(-2, -2, 2, 2).intersected(window.rect()));
  m_frame->raise();
  m_callout->adjustSize();
  m_callout->pointAt(target);
  m_callout->raise();
}

void TourController::end() {
  m_step = -1;
  m_context.window.removeEventFilter(this);
  if (m_target)
    m_target->removeEventFilter(this);
  const bool hadFocus = m_callout->isAncestorOf(m_context.window.focusWidget());
  m_callout->hide();
  m_callout->deleteLater();
  m_frame->hide();
  m_frame->deleteLater();
  if (hadFocus && m_before)
    m_before->setFocus(Qt::OtherFocusReason);
}

bool TourController::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if (m_step >= 0 &&
      (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show || type == QEvent::Hide))
    QMetaObject::invokeMethod(
        this,
        [this] {
          if (m_step >= 0)
            follow();
        },
        Qt::QueuedConnection); // once the layout is done
  return QObject::eventFilter(watched, event);
}

} // namespace limn
