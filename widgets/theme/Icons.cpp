// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/theme/Icons.h"

#include "widgets/theme/Theme.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

#include <cassert>

namespace limn {
namespace {

// The files hold every stroke as black; that one colour is what is replaced.
const QByteArray drawnColor = "#000000";

class ThemedIconEngine : public QIconEngine {
public:
  ThemedIconEngine(QByteArray svg, const ThemeColors& colors) : m_svg(std::move(svg)), m_colors(colors) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    QByteArray svg = m_svg;
    QSvgRenderer renderer(svg.replace(drawnColor, color(mode, state).name().toUtf8()));
    renderer.render(painter, QRectF(rect));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new ThemedIconEngine(*this); }

private:
  QColor color(QIcon::Mode mode, QIcon::State state) const {
    if (mode == QIcon::Disabled)
      return m_colors.disabledText;
    if (mode == QIcon::Selected)
      return m_colors.accentText;
    return state == QIcon::On ? m_colors.accent : m_colors.text;
  }

  QByteArray m_svg;
  ThemeColors m_colors;
};

QIcon iconIn(const QString& path, const QPalette& palette) {
  loadWidgetResources();
  QFile file(path);
  const bool opened = file.open(QIODevice::ReadOnly);
  assert(opened && "no such icon");
  if (!opened)
    return {};
  return QIcon(new ThemedIconEngine(file.readAll(), themeColors(palette)));
}

} // namespace

QIcon themedIcon(const QString& name, const QPalette& palette) {
  return iconIn(QStringLiteral(":/limn/icons/%1.svg").arg(name), palette);
}

QIcon programIcon() {
  return iconIn(QStringLiteral(":/limn/limn.svg"), {});
}

} // namespace limn
