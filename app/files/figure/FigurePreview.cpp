// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/figure/FigurePreview.h"

#include "scene/basics/Error.h"
#include "widgets/figure/FigureLayout.h"
#include "widgets/figure/FigurePainting.h"
#include "widgets/figure/LabelLegend.h"

#include <QFontInfo>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int aroundPage = 12;

// What shows where a page is transparent, as image editors show it.
QBrush checkers() {
  constexpr int field = 8;
  QPixmap tile(2 * field, 2 * field);
  tile.fill(QColor(255, 255, 255));
  QPainter painter(&tile);
  painter.fillRect(0, 0, field, field, QColor(218, 220, 224));
  painter.fillRect(field, field, field, field, QColor(218, 220, 224));
  return QBrush(tile);
}

} // namespace

FigurePreview::FigurePreview(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Preview of the figure"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FigurePreview::setFigure(const Figure& figure) {
  if (figure.panels != m_figure.panels || figure.settings.marks != m_figure.settings.marks)
    m_labels = figureLabels(figure);
  m_figure = figure;
  update();
}

void FigurePreview::setPictures(const std::vector<QImage>& pictures) {
  m_pictures = pictures;
  update();
}

void FigurePreview::setAwaiting(const QString& text) {
  if (text == m_awaiting)
    return;
  m_awaiting = text;
  setAccessibleDescription(text);
  update();
}

std::optional<Figure> FigurePreview::asShown() const {
  if (m_figure.panels.empty())
    return std::nullopt;
  try {
    const QSize full = figureLayout(m_figure, m_labels).size;
    const QSizeF room = QSizeF(width() - 2 * aroundPage, height() - 2 * aroundPage) * devicePixelRatioF();
    Figure shown = m_figure;
    // Rounding may add some pixels to the height.
    constexpr double rounding = 8.0;
    shown.settings =
        scaledBy(m_figure.settings,
                 std::min({1.0, room.width() / full.width(), (room.height() - rounding) / full.height()}));
    figureLayout(shown, m_labels);
    return shown;
  } catch (const Error&) {
    return std::nullopt;
  }
}

void FigurePreview::paintEvent(QPaintEvent*) {
  const std::optional<Figure> shown = asShown();
  if (!shown)
    return;
  const FigureLayout layout = figureLayout(*shown, m_labels);
  QPainter painter(this);
  const double ratio = devicePixelRatioF();
  painter.scale(1.0 / ratio, 1.0 / ratio);
  painter.translate(std::round((width() * ratio - layout.size.width()) / 2.0),
                    std::round((height() * ratio - layout.size.height()) / 2.0));
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (shown->settings.page == FigureSettings::Page::transparent)
    painter.fillRect(QRect(QPoint(0, 0), layout.size), checkers());
  paintFigure(painter, *shown, layout, m_pictures);
  paintAwaiting(painter, layout);
}

// On a plate of its own, which any page leaves readable.
void FigurePreview::paintAwaiting(QPainter& painter, const FigureLayout& layout) const {
  if (m_awaiting.isEmpty())
    return;
  QFont font = this->font();
  font.setPixelSize(qRound(QFontInfo(font).pixelSize() * devicePixelRatioF()));
  painter.setFont(font);
  for (std::size_t i = 0; i < layout.pictures.size(); ++i) {
    if (i < m_pictures.size() && !m_pictures[i].isNull())
      continue;
    const QRectF picture(layout.pictures[i]);
    const QRectF words = painter.boundingRect(picture, Qt::AlignCenter | Qt::TextWordWrap, m_awaiting);
    painter.fillRect(words.adjusted(-6.0, -3.0, 6.0, 3.0), palette().window());
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(picture, Qt::AlignCenter | Qt::TextWordWrap, m_awaiting);
  }
}

void FigurePreview::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  emit resized();
}

} // namespace limn
