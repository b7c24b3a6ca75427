// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/FigureLayout.h"

#include <QImage>
#include <QWidget>

#include <vector>

namespace limn {

/// Shows a figure as large as it has room: the page with all its marks at once, the pictures as they come.
class FigurePreview : public QWidget {
  Q_OBJECT

public:
  explicit FigurePreview(QWidget* parent = nullptr);

  /// The figure as it shall be. One that cannot be laid out leaves the view empty.
  void setFigure(const Figure& figure);

  const Figure& figure() const { return m_figure; }

  /// Pictures of its panels in any number of pixels.
  void setPictures(const std::vector<QImage>& pictures);
  const std::vector<QImage>& pictures() const { return m_pictures; }

  /// What is said in the place of pictures that are still to come; empty: nothing.
  void setAwaiting(const QString& text);
  const QString& awaiting() const { return m_awaiting; }

  /// The figure with as many pixels as it has here; nothing where it cannot be laid out.
  std::optional<Figure> asShown() const;

  QSize sizeHint() const override { return {620, 560}; }
  QSize minimumSizeHint() const override { return {320, 280}; }

signals:
  /// There is room for another number of pixels.
  void resized();

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void paintAwaiting(QPainter& painter, const FigureLayout& layout) const;

  Figure m_figure;
  FigureLabels m_labels; ///< of it
  std::vector<QImage> m_pictures;
  QString m_awaiting;
};

} // namespace limn
