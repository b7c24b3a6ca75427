// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/FoldingSection.h"

#include "widgets/theme/Icons.h"
#include "widgets/theme/Theme.h"

#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QEvent>
#include <QFocusEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QScrollBar>
#include <QStyle>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>

namespace limn {
namespace {

class AccessibleHeader : public QAccessibleWidget {
public:
  explicit AccessibleHeader(FoldingHeader* header)
      : QAccessibleWidget(header, QAccessible::Button), m_header(header) {}

  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.expandable = true;
    state.expanded = m_header->isChecked();
    state.collapsed = !m_header->isChecked();
    return state;
  }

  QStringList actionNames() const override { return {pressAction(), setFocusAction()}; }

  void doAction(const QString& name) override {
    if (name == pressAction())
      m_header->click();
    else
      QAccessibleWidget::doAction(name);
  }

private:
  FoldingHeader* m_header;
};

QAccessibleInterface* accessibleHeader(const QString&, QObject* object) {
  auto* header = qobject_cast<FoldingHeader*>(object);
  return header ? new AccessibleHeader(header) : nullptr;
}

void tellExpandedOrCollapsed(FoldingHeader& header) {
  QAccessible::State changed;
  changed.expanded = changed.collapsed = true;
  QAccessibleStateChangeEvent event(&header, changed);
  QAccessible::updateAccessibility(&event);
}

} // namespace

FoldingHeader::FoldingHeader(const QString& title, QWidget* parent)
    : QAbstractButton(parent), m_arrow(new QLabel), m_summary(new QLabel) {
  QAccessible::installFactory(accessibleHeader); // once, however often it is asked for
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 8, 12, 8);
  row->setSpacing(4);
  auto* name = new QLabel(title);
  QFont bold = name->font();
  bold.setWeight(QFont::DemiBold);
  name->setFont(bold);
  row->addWidget(m_arrow);
  row->addWidget(name);
  row->addStretch(1);
  row->addWidget(m_summary);
  m_summary->setForegroundRole(QPalette::PlaceholderText);

  // The labels stand on the panel, not on the face of a button.
  setForegroundRole(QPalette::NoRole);
  setBackgroundRole(QPalette::NoRole);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setCheckable(true);
  setChecked(true);
  setAccessibleName(title);
  setToolTip(tr("Fold or unfold \"%1\"").arg(title));
  showArrow();
  connect(this, &QAbstractButton::toggled, this, [this] {
    showArrow();
    tellExpandedOrCollapsed(*this);
  });
}

void FoldingHeader::setSummary(const QString& summary) {
  m_summary->setText(summary);
}

void FoldingHeader::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  if (underMouse())
    painter.fillRect(rect(), colors.hover);
  painter.fillRect(0, 0, width(), 1, colors.border);
  if (hasFocus()) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.accent, 2.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
  }
}

void FoldingHeader::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    click();
  else if (event->key() == Qt::Key_Space)
    QAbstractButton::keyPressEvent(event);
  else
    event->ignore(); // arrows scroll the panel rather than walk the buttons
}

void FoldingHeader::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange)
    showArrow();
  QAbstractButton::changeEvent(event);
}

void FoldingHeader::showArrow() {
  const QString name = isChecked() ? QStringLiteral("unfold") : QStringLiteral("fold");
  m_arrow->setPixmap(themedIcon(name, palette()).pixmap(QSize(16, 16), devicePixelRatioF()));
}

FoldingSection::FoldingSection(const QString& title, QWidget* parent)
    : QWidget(parent), m_header(new FoldingHeader(title)), m_body(new QWidget),
      m_contents(new QVBoxLayout(m_body)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_header);
  layout->addWidget(m_body);
  m_contents->setContentsMargins(12, 4, 12, 12);
  m_contents->setSpacing(8);
  connect(m_header, &QAbstractButton::clicked, this, [this](bool open) {
    setFolded(!open);
    emit foldedByUser(!open);
  });
}

void FoldingSection::setFolded(bool folded) {
  m_header->setChecked(!folded);
  m_body->setVisible(!folded);
}

bool FoldingSection::isFolded() const {
  return !m_header->isChecked();
}

QSize FoldingSection::minimumSizeHint() const {
  const QSize size = QWidget::minimumSizeHint();
  return {std::max(size.width(), m_body->minimumSizeHint().width()), size.height()};
}

void FoldingSection::setSummary(const QString& summary) {
  m_header->setSummary(summary);
}

// Of the style sheet, pixels.
static constexpr int focusFrame = 1;

SectionPanel::SectionPanel(QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void SectionPanel::stack(const std::vector<QWidget*>& sections) {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (QWidget* section : sections)
    layout->addWidget(section);
  // Room left over stays below all sections. A policy that lets none grow would hold them to the height of
  // unwrapped text.
  layout->addStretch(1);
  setWidget(content);
}

void SectionPanel::scrollTo(const QWidget& section) {
  // A layout that changes asks the one around it with an event, and so on up to the scroll bar.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  verticalScrollBar()->setValue(section.mapTo(widget(), QPoint()).y());
}

std::vector<bool> SectionPanel::folded() const {
  std::vector<bool> folded;
  for (const FoldingSection* section : findChildren<FoldingSection*>())
    folded.push_back(section->isFolded());
  return folded;
}

void SectionPanel::setFolded(const std::vector<bool>& folded) {
  const QList<FoldingSection*> sections = findChildren<FoldingSection*>();
  for (std::size_t i = 0; i < std::min<std::size_t>(sections.size(), folded.size()); ++i)
    sections[static_cast<qsizetype>(i)]->setFolded(folded[i]);
}

// Nothing may hide under the scroll bar, nor beyond the frame that shows the focus.
QSize SectionPanel::minimumSizeHint() const {
  QSize size = QScrollArea::minimumSizeHint();
  if (widget())
    size.setWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width() +
                  2 * focusFrame);
  return size;
}

bool SectionPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest)
    updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

static constexpr int scrollingMs = 500; // from one turn of the wheel to the next

bool SectionPanel::isScrolling() const {
  return m_scrolled.isValid() && !m_scrolled.hasExpired(scrollingMs);
}

// At its end, too, where one turns on.
void SectionPanel::wheelEvent(QWheelEvent* event) {
  QScrollArea::wheelEvent(event);
  if (verticalScrollBar()->maximum() > verticalScrollBar()->minimum())
    m_scrolled.start();
}

bool takesWheel(const QWidget& control) {
  for (const QWidget* around = control.parentWidget(); around; around = around->parentWidget())
    if (const auto* panel = dynamic_cast<const SectionPanel*>(around); panel && panel->isScrolling())
      return false;
  return control.hasFocus();
}

void SectionPanel::focusInEvent(QFocusEvent* event) {
  QScrollArea::focusInEvent(event);
  if (event->reason() == Qt::ActiveWindowFocusReason || event->reason() == Qt::PopupFocusReason ||
      event->reason() == Qt::MenuBarFocusReason)
    return;                                                               // as it was
  setProperty("focusByPointer", event->reason() == Qt::MouseFocusReason); // theme.qss
  style()->unpolish(this);
  style()->polish(this);
}

} // namespace limn
