// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pictures/ContactSheet.h"

#include <QFontMetrics>
#include <QPainter>

namespace limn::test {
namespace {

constexpr int margin = 8;

} // namespace

std::vector<QImage> contactSheet(const std::vector<NamedPicture>& pictures, int columns, int rows,
                                 const QSize& cell) {
  std::vector<QImage> pages;
  const int textHeight = 2 * QFontMetrics(QFont()).lineSpacing();
  const QSize step = cell + QSize(margin, margin + textHeight);
  const auto perPage = static_cast<std::size_t>(columns * rows);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int place = static_cast<int>(i % perPage);
    if (place == 0) {
      const int left = static_cast<int>(std::min(perPage, pictures.size() - i));
      pages.emplace_back(columns * step.width() + margin,
                         (left + columns - 1) / columns * step.height() + margin, QImage::Format_RGB32);
      pages.back().fill(Qt::white);
    }
    QPainter painter(&pages.back());
    const QPoint at(margin + place % columns * step.width(), margin + place / columns * step.height());
    const QImage scaled = pictures[i].picture.scaled(cell, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    painter.drawImage(at + QPoint((cell.width() - scaled.width()) / 2, 0), scaled);
    painter.drawText(QRect(at + QPoint(0, cell.height()), QSize(cell.width(), textHeight)),
                     Qt::AlignHCenter | Qt::AlignTop, pictures[i].name);
  }
  return pages;
}

} // namespace limn::test
