// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/SectionPanel.h"

#include <QEvent>
#include <QScrollBar>
#include <QVBoxLayout>

namespace limn {

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
  layout->addStretch(1);
  setWidget(content);
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

} // namespace limn
