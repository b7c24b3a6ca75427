// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/ViewPanels.h"

#include "widgets/theme/Theme.h"

#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cstring>

namespace limn {
namespace {

// Names with @ are replaced. Text contrast is at least 7:1.
const QString panelStyle = QStringLiteral(R"(
limn--EmptyPanel, limn--MessagePanel { background: @ground; }
limn--LoadingPanel { background: @ground; }
limn--HintBar { background: @ground; border: 1px solid @line; border-radius: 6px; }
QLabel { color: @text; background: transparent; }
QLabel#heading { color: @strong; }
QPushButton { color: @strong; background: @button; border: 1px solid @line; border-radius: 4px;
              padding: 8px 16px; min-height: 20px; }
QPushButton:hover { background: @hover; }
QPushButton:pressed { background: @pressed; }
QPushButton:focus { border: 2px solid @accent; padding: 7px 15px; }
QPushButton:default { color: @onDefault; background: @default; border-color: @accent; }
QPushButton:default:focus { border-color: @strong; }
QPushButton:default:hover { background: @defaultHover; }
QPushButton#recent { padding: 4px 16px; min-width: 320px; background: @quiet; }
QPushButton#recent:focus { padding: 3px 15px; }
QPushButton#recent:hover { background: @hover; }
QPushButton#cancel { padding: 2px 12px; min-height: 16px; }
QPushButton#cancel:focus { padding: 1px 11px; }
QPushButton#choice { padding: 3px 10px; min-height: 18px; }
QPushButton#choice:focus { padding: 2px 9px; }
QPushButton#choice:checked { color: @onDefault; background: @default; border-color: @accent; }
QProgressBar { background: @button; border: none; }
QProgressBar::chunk { background: @accent; }
)");

struct PanelColor {
  const char* name;
  const char* usual;
  const char* contrast; ///< in the theme of high contrast
};

// A name that begins another stands behind it.
constexpr PanelColor panelColors[] = {
    {"@ground", "#0d0d14", "#000000"},    {"@text", "#c9ced6", "#ffffff"},
    {"@strong", "#f2f4f7", "#ffffff"},    {"@button", "#262a33", "#000000"},
    {"@line", "#434a57", "#ffffff"},      {"@hover", "#323844", "#333333"},
    {"@pressed", "#1d2027", "#555555"},   {"@accent", "#4da3ff", "#ffd400"},
    {"@onDefault", "#f2f4f7", "#000000"}, {"@defaultHover", "#2870c2", "#ffe566"},
    {"@default", "#1f5fa8", "#ffd400"},   {"@quiet", "#15171e", "#000000"},
};

bool isContrast() {
  return lookOf(QGuiApplication::palette()) == Look::contrast;
}

QColor panelColor(const char* name) {
  const auto* found = std::ranges::find_if(
      panelColors, [name](const PanelColor& color) { return std::strcmp(color.name, name) == 0; });
  return isContrast() ? found->contrast : found->usual;
}

constexpr QMargins pageMargins(16, 8, 16, 8);
constexpr int leastWidth = 520;    // of the place to drop something, where there is room
constexpr int mostRecentShown = 3; // they fit a window of 800 pixels

// Of the place to drop something: around its words, above them with the arrow, and where there is little
// room.
constexpr int targetMargin = 24;
constexpr int arrowMargin = 80;
constexpr int lowMargin = 12;
constexpr int arrowRoom = arrowMargin + targetMargin - 2 * lowMargin;

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName(QStringLiteral("heading"));
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * 1.4);
  label->setFont(font);
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  return label;
}

} // namespace

QPushButton* panelButton(const QString& text, const QString& name, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setAccessibleName(text);
  made->setCursor(Qt::PointingHandCursor);
  made->setAutoDefault(true); // Enter presses it
  return made;
}

PicturePanel::PicturePanel(QWidget* parent) : QFrame(parent) {
  dress();
}

void PicturePanel::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
    dress();
}

void PicturePanel::dress() {
  if (m_isContrast == isContrast())
    return;
  m_isContrast = isContrast();
  QString style = panelStyle;
  for (const PanelColor& color : panelColors)
    style.replace(QLatin1String(color.name), QLatin1String(*m_isContrast ? color.contrast : color.usual));
  setStyleSheet(style);
}

EmptyPanel::EmptyPanel(QWidget* parent)
    : PicturePanel(parent), m_target(new QWidget(this)), m_recent(new QWidget(this)) {
  setAttribute(Qt::WA_StyledBackground);
  m_title = heading(tr("Drop a DICOM folder or a volume file here"), m_target);
  m_formats = new QLabel(tr("Limn shows CT and MR volumes in three dimensions.") + QLatin1Char('\n') +
                             tr("DICOM · NIfTI · NRRD · MetaImage · VTK · TIFF, PNG and JPEG stacks"),
                         m_target);
  m_formats->setAlignment(Qt::AlignCenter);
  m_formats->setWordWrap(true);
  m_folder = panelButton(tr("Open DICOM folder…"), QStringLiteral("openFolder"), m_target);
  m_continue = panelButton({}, QStringLiteral("continue"), this);
  auto* file = panelButton(tr("Open file…"), QStringLiteral("openFile"), m_target);
  auto* sample = panelButton(tr("Try the sample head"), QStringLiteral("sample"), m_target);
  connect(m_folder, &QPushButton::clicked, this, &EmptyPanel::openFolderRequested);
  connect(file, &QPushButton::clicked, this, &EmptyPanel::openFileRequested);
  connect(sample, &QPushButton::clicked, this, &EmptyPanel::sampleRequested);
  connect(m_continue, &QPushButton::clicked, this, &EmptyPanel::continueRequested);

  auto* column = new QVBoxLayout(m_target);
  column->setContentsMargins(targetMargin, arrowMargin, targetMargin, targetMargin);
  column->setSpacing(8);
  column->addWidget(m_title);
  column->addWidget(m_formats);
  column->addSpacing(16);
  m_ways = new QHBoxLayout;
  m_ways->setSpacing(8);
  for (QPushButton* each : {m_folder, file, sample})
    m_ways->addWidget(each);
  column->addLayout(m_ways);
  m_target->setMaximumSize(leastWidth, 380);

  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(pageMargins);
  outer->addStretch();
  outer->addWidget(m_continue, 0, Qt::AlignHCenter);
  auto* row = new QHBoxLayout;
  row->addStretch();
  row->addWidget(m_target, 1);
  row->addStretch();
  outer->addLayout(row);
  outer->addWidget(m_recent, 0, Qt::AlignHCenter);
  outer->addStretch();
  m_recent->hide();
  setUnfinished({});
}

void EmptyPanel::setUnfinished(const QString& text, bool isLatest) {
  const bool hadFocus = likeliest() == window()->focusWidget();
  m_isUnfinishedLatest = isLatest;
  m_continue->setVisible(!text.isEmpty());
  m_continue->setText(
      tr("Unsaved work:\n%1").arg(QString(text).replace(QLatin1Char('&'), QStringLiteral("&&"))));
  m_continue->setAccessibleName(tr("Unsaved work: %1").arg(text));
  auto* column = static_cast<QBoxLayout*>(layout());
  column->removeWidget(m_continue);
  const int place = isLatest ? 1 : column->indexOf(m_recent) + 1;
  column->insertWidget(place, m_continue, 0, Qt::AlignHCenter);
  showLikeliest(hadFocus);
  fit();
}

QPushButton* EmptyPanel::likeliest() const {
  return m_continue->isHidden() || !m_isUnfinishedLatest ? m_folder : m_continue;
}

void EmptyPanel::showLikeliest(bool takesFocus) {
  QPushButton* best = likeliest();
  for (QPushButton* each : {m_folder, m_continue})
    each->setDefault(each == best);
  if (takesFocus)
    best->setFocus(Qt::OtherFocusReason);
}

// Beside each other they leave room for what was open before.
void EmptyPanel::resizeEvent(QResizeEvent* event) {
  PicturePanel::resizeEvent(event);
  const QMargins margins = m_target->layout()->contentsMargins();
  int beside = margins.left() + margins.right() + 2 * m_ways->spacing();
  for (int i = 0; i < m_ways->count(); ++i)
    beside += m_ways->itemAt(i)->sizeHint().width();
  const QMargins around = layout()->contentsMargins();
  m_target->setMaximumWidth(std::max(leastWidth, beside)); // words of other languages are longer
  m_ways->setDirection(width() < std::max(leastWidth, beside) + around.left() + around.right()
                           ? QBoxLayout::TopToBottom
                           : QBoxLayout::LeftToRight);
  fit();
}

void EmptyPanel::keepClearOf(QWidget& cover) {
  m_covers.emplace_back(&cover);
  cover.installEventFilter(this);
}

bool EmptyPanel::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type == QEvent::Move || type == QEvent::Resize || type == QEvent::Show || type == QEvent::Hide)
    fit();
  return PicturePanel::eventFilter(watched, event);
}

int EmptyPanel::coveredBelow() const {
  int top = height();
  for (const QPointer<QWidget>& cover : m_covers) {
    if (!cover || !cover->isVisible())
      continue;
    const QRect place(mapFromGlobal(cover->mapToGlobal(QPoint())), cover->size());
    if (place.intersects(rect()))
      top = std::min(top, place.top());
  }
  return height() - top;
}

// What was open before first, then the words, the arrow last.
void EmptyPanel::fit() {
  layout()->setContentsMargins(pageMargins);
  QLayout& inner = *m_target->layout();
  const int width = std::min(m_target->maximumWidth(), this->width()) - 2 * targetMargin;
  const auto wordsIn = [&](const QLabel& label) { return label.heightForWidth(width) + inner.spacing(); };
  const int recent = m_recent->sizeHint().height() + layout()->spacing();
  const auto height = [this](QLayout& of) {
    of.invalidate();
    return of.hasHeightForWidth() ? of.totalHeightForWidth(this->width()) : of.totalSizeHint().height();
  };
  int room = this->height() - height(*layout()) + (m_hasArrow ? arrowRoom : 0);
  for (const auto& [part, pixels] : {std::pair<QWidget*, int>(m_title, wordsIn(*m_title)),
                                     {m_formats, wordsIn(*m_formats)},
                                     {m_recent, recent}})
    room += part->isHidden() ? 0 : pixels;
  const int margin = pageMargins.bottom(); // what covers the page has margins of its own
  const int bottom = std::max(coveredBelow(), margin);
  room -= bottom - margin;
  layout()->setContentsMargins(pageMargins.left(), pageMargins.top(), pageMargins.right(), bottom);
  const auto hasRoom = [&room](int pixels) {
    const bool has = room >= pixels;
    room -= has ? pixels : 0;
    return has;
  };
  m_recent->setVisible(m_hasRecent && hasRoom(recent));
  m_title->setVisible(hasRoom(wordsIn(*m_title)));
  m_formats->setVisible(hasRoom(wordsIn(*m_formats)));
  m_hasArrow = hasRoom(arrowRoom);
  inner.setContentsMargins(targetMargin, m_hasArrow ? arrowMargin : lowMargin, targetMargin,
                           m_hasArrow ? targetMargin : lowMargin);
  m_target->updateGeometry();
  // What it offers stands in the middle of the page and moves up no further than it has to: a button moves
  // only where something would lie on it, and not as that goes while the pointer is on its way.
  const int content = height(*layout()) - pageMargins.top() - bottom;
  const int asked = 2 * (bottom + margin) - (this->height() - pageMargins.top() - content);
  layout()->setContentsMargins(pageMargins.left(), pageMargins.top(), pageMargins.right(),
                               std::clamp(asked, margin, bottom));
  layout()->activate();
}

void EmptyPanel::showEvent(QShowEvent* event) {
  PicturePanel::showEvent(event);
  showLikeliest(true);
}

void EmptyPanel::setRecentSources(const QStringList& texts) {
  qDeleteAll(m_recent->children());
  auto* column = new QVBoxLayout(m_recent);
  column->setContentsMargins(0, 8, 0, 0);
  column->setSpacing(4);
  auto* title = new QLabel(tr("Opened before"), m_recent);
  title->setAlignment(Qt::AlignCenter);
  column->addWidget(title);
  for (int number = 0; number < std::min<int>(texts.size(), mostRecentShown); ++number) {
    const QString& name = texts[number];
    auto* button = panelButton(QString(name).replace(QLatin1Char('&'), QStringLiteral("&&")),
                               QStringLiteral("recent"), m_recent);
    button->setAccessibleName(tr("Open again: %1").arg(name));
    connect(button, &QPushButton::clicked, this, [this, number] { emit recentRequested(number); });
    auto* remove = new QAction(tr("Remove from this list"), button);
    remove->setShortcut(QKeySequence::Delete);
    remove->setShortcutContext(Qt::WidgetShortcut);
    button->addAction(remove);
    button->setContextMenuPolicy(Qt::ActionsContextMenu);
    // Later: the button goes with what is taken out.
    connect(
        remove, &QAction::triggered, this, [this, number] { emit recentRemovalRequested(number); },
        Qt::QueuedConnection);
    column->addWidget(button);
  }
  m_hasRecent = !texts.isEmpty();
  fit();
}

void EmptyPanel::paintEvent(QPaintEvent* event) {
  PicturePanel::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  // Whole within what it surrounds: where that was before it moved, nothing else is painted anew.
  const QRectF frame = QRectF(m_target->geometry()).adjusted(1.0, 1.0, -1.0, -1.0);
  painter.setPen(QPen(isContrast() ? panelColor("@line") : QColor(86, 95, 110), 1.5, Qt::DashLine));
  painter.drawRoundedRect(frame, 12, 12);
  if (!m_hasArrow)
    return;
  // An arrow into a tray: drop here.
  painter.setPen(QPen(panelColor("@accent"), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QPointF top(frame.center().x(), frame.top() + 36.0);
  const QPointF tip = top + QPointF(0, 24);
  painter.drawLine(top, tip);
  painter.drawPolyline(QPolygonF({tip + QPointF(-8, -8), tip, tip + QPointF(8, -8)}));
  painter.drawPolyline(QPolygonF(
      {tip + QPointF(-16, 2), tip + QPointF(-16, 10), tip + QPointF(16, 10), tip + QPointF(16, 2)}));
}

MessagePanel::MessagePanel(QWidget* parent) : PicturePanel(parent), m_text(new QLabel(this)) {
  setAttribute(Qt::WA_StyledBackground);
  auto* title = heading(tr("The picture cannot be drawn"), this);
  m_text->setObjectName(QStringLiteral("sentence"));
  m_text->setWordWrap(true);
  m_text->setAlignment(Qt::AlignCenter);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_text->setMaximumWidth(560);
  m_text->setMinimumWidth(200);
  auto* retry = panelButton(tr("Try again"), QStringLiteral("retry"), this);
  connect(retry, &QPushButton::clicked, this, &MessagePanel::retryRequested);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(32, 32, 32, 32);
  column->setSpacing(12);
  column->addStretch();
  column->addWidget(title);
  auto* row = new QHBoxLayout;
  row->addStretch();
  row->addWidget(m_text, 4);
  row->addStretch();
  column->addLayout(row);
  column->addSpacing(8);
  column->addWidget(retry, 0, Qt::AlignHCenter);
  column->addStretch();
}

void MessagePanel::setSentence(const QString& sentence) {
  m_text->setText(sentence);
}

LoadingPanel::LoadingPanel(QWidget* parent)
    : PicturePanel(parent), m_text(new QLabel(this)), m_bar(new QProgressBar(this)) {
  setAttribute(Qt::WA_StyledBackground);
  m_bar->setTextVisible(false);
  m_bar->setFixedHeight(4);
  m_bar->setAccessibleName(tr("Loading progress"));
  auto* cancel = panelButton(tr("Cancel"), QStringLiteral("cancel"), this);
  connect(cancel, &QPushButton::clicked, this, &LoadingPanel::cancelled);

  auto* row = new QHBoxLayout;
  row->setContentsMargins(12, 6, 12, 6);
  row->setSpacing(12);
  row->addWidget(m_text, 1);
  row->addWidget(cancel);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(row);
  column->addWidget(m_bar);
}

void LoadingPanel::setProgress(double fraction, const QString& text) {
  m_text->setText(text);
  m_bar->setRange(0, fraction < 0.0 ? 0 : 1000);
  if (fraction >= 0.0)
    m_bar->setValue(static_cast<int>(fraction * 1000.0));
}

} // namespace limn
