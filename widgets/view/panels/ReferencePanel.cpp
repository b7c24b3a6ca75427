// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/ReferencePanel.h"

#include "widgets/view/panels/ViewPanels.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace limn {
namespace {

// It lies where pictures lie, so it is dark in both themes, as the other panels are.
const QString barStyle = QStringLiteral(R"(
QFrame#graphicsFailure { background: #1d2027; border-top: 1px solid #434a57; }
QLabel { color: #f2f4f7; background: transparent; }
QPushButton { color: #f2f4f7; background: #262a33; border: 1px solid #434a57; border-radius: 4px;
              padding: 4px 12px; min-height: 20px; }
QPushButton:hover { background: #323844; }
QPushButton:focus { border-color: #4da3ff; }
)");

// The whole of a picture in a rectangle, as large as it goes.
QRect fitted(const QSize& picture, const QRect& place) {
  const QSize size = picture.scaled(place.size(), Qt::KeepAspectRatio);
  return {place.topLeft() + QPoint((place.width() - size.width()) / 2, (place.height() - size.height()) / 2),
          size};
}

} // namespace

ReferencePanel::ReferencePanel(QWidget* parent)
    : QWidget(parent), m_bar(new QFrame(parent)), m_text(new QLabel(m_bar)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Picture drawn by the processor"));
  m_bar->setObjectName(QStringLiteral("graphicsFailure"));
  m_bar->setStyleSheet(barStyle);
  m_text->setObjectName(QStringLiteral("failureReason"));
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* copy = panelButton(tr("Copy details"), QStringLiteral("copyFailure"), m_bar);
  copy->setToolTip(tr("What the driver wrote, for a report; it names nobody and no file"));
  connect(copy, &QPushButton::clicked, this, &ReferencePanel::copyDetails);
  auto* retry = panelButton(tr("Try again"), QStringLiteral("retryGraphics"), m_bar);
  connect(retry, &QPushButton::clicked, this, &ReferencePanel::retryRequested);
  auto* row = new QHBoxLayout(m_bar);
  row->setContentsMargins(12, 8, 12, 8);
  row->setSpacing(12);
  row->addWidget(m_text, 1);
  row->addWidget(copy);
  row->addWidget(retry);
  showParts(false);
}

void ReferencePanel::setReason(const QString& sentence, const QString& details) {
  m_sentence = sentence;
  m_details = details;
  m_text->setText(tr("%1 Until it works again, the processor draws the picture.").arg(sentence));
}

void ReferencePanel::setPictures(const std::vector<QImage>& pictures) {
  m_pictures = pictures;
  update();
}

void ReferencePanel::cover(const QRect& rect) {
  const int height = m_bar->heightForWidth(rect.width());
  m_bar->setGeometry(rect.left(), rect.bottom() + 1 - height, rect.width(), height);
  setGeometry(rect.adjusted(0, 0, 0, -height));
}

void ReferencePanel::showParts(bool visible) {
  setVisible(visible);
  m_bar->setVisible(visible);
  if (visible)
    m_bar->raise();
}

void ReferencePanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(13, 13, 20));
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const int count = static_cast<int>(m_pictures.size());
  for (int i = 0; i < count; ++i) {
    const QRect place(i * width() / count, 0, (i + 1) * width() / count - i * width() / count, height());
    const QImage& picture = m_pictures[static_cast<std::size_t>(i)];
    painter.drawImage(fitted(picture.size(), place), picture);
  }
}

void ReferencePanel::copyDetails() const {
  QGuiApplication::clipboard()->setText(m_details.isEmpty() ? m_sentence
                                                            : m_sentence + QLatin1Char('\n') + m_details);
}

} // namespace limn
