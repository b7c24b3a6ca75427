// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/FoldingSection.h"

#include "widgets/Icons.h"
#include "widgets/Theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace limn {
namespace {

// The header paints its own focus ring and hairline; everything else is labels.
class SectionHeader : public QWidget {
public:
  using QWidget::QWidget;

protected:
  void paintEvent(QPaintEvent*) override {
    const ThemeColors colors = themeColors(palette());
    QPainter painter(this);
    if (underMouse())
      painter.fillRect(rect(), colors.hover);
    painter.fillRect(0, 0, width(), 1, colors.border);
    if (hasFocus()) {
      painter.setPen(colors.accent);
      painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
  }
};

bool asksToFold(const QEvent& event) {
  if (event.type() == QEvent::MouseButtonRelease)
    return static_cast<const QMouseEvent&>(event).button() == Qt::LeftButton;
  if (event.type() != QEvent::KeyPress)
    return false;
  const int key = static_cast<const QKeyEvent&>(event).key();
  return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter;
}

} // namespace

FoldingSection::FoldingSection(const QString& title, QWidget* parent)
    : QWidget(parent), m_header(new SectionHeader), m_arrow(new QLabel), m_summary(new QLabel),
      m_body(new QWidget), m_contents(new QVBoxLayout(m_body)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_header);
  layout->addWidget(m_body);
  m_contents->setContentsMargins(12, 4, 12, 16);
  m_contents->setSpacing(12);

  auto* row = new QHBoxLayout(m_header);
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

  m_header->setFocusPolicy(Qt::TabFocus);
  m_header->setAttribute(Qt::WA_Hover);
  m_header->setAccessibleName(title);
  m_header->setToolTip(tr("Fold or unfold \"%1\"").arg(title));
  m_header->installEventFilter(this);
  m_summary->setForegroundRole(QPalette::PlaceholderText);
  showArrow();
}

void FoldingSection::setFolded(bool folded) {
  m_folded = folded;
  m_body->setVisible(!folded);
  showArrow();
}

void FoldingSection::setSummary(const QString& summary) {
  m_summary->setText(summary);
}

bool FoldingSection::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_header || !asksToFold(*event))
    return QWidget::eventFilter(watched, event);
  setFolded(!m_folded);
  emit foldedByUser(m_folded);
  return true;
}

void FoldingSection::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange)
    showArrow();
  QWidget::changeEvent(event);
}

void FoldingSection::showArrow() {
  const QString name = m_folded ? QStringLiteral("fold") : QStringLiteral("unfold");
  m_arrow->setPixmap(themedIcon(name, palette()).pixmap(QSize(16, 16), devicePixelRatioF()));
}

} // namespace limn
