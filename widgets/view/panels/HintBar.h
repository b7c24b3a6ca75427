// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/panels/ViewPanels.h"

#include <QRect>
#include <QRectF>
#include <QTimer>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QBoxLayout;
class QHBoxLayout;
class QLabel;

namespace limn {

/// Lies over the lower edge of the pictures while a tool is in hand that takes more than a drag: what to do
/// next, and a button that lays the tool aside. It stands beside what is written there, as near to the middle
/// as that leaves room; where there is too little, above that in the middle. Dragged away it stays where it
/// was let go as long as its tool is in hand.
class HintBar : public PicturePanel {
  Q_OBJECT

public:
  /// `name` is what assistive technology calls it.
  HintBar(const QString& name, QWidget* parent);

  /// What to do next, in a few words; `tip` says the rest. Where there is little room, words that do not
  /// `stay` give way to the buttons, the others take a row.
  void showHint(const QString& text, const QString& tip, bool stays = true);
  QString hint() const;
  /// Whether its tool is in hand, be it out of the way or not.
  bool isOut() const { return m_isOut; }
  /// While this says so the bar is out of the way: what it lies on may be meant.
  void setDrawing(std::function<bool()> isDrawing) { m_isDrawing = std::move(isDrawing); }

  /// The place in a lane, nearest to a wished one, that lies on none of these; nothing where there is none.
  using Clear = std::function<std::optional<QRectF>(const QRectF& wished, const QRectF& lane,
                                                    const std::vector<QRectF>& places)>;
  /// Where something is written over the view at present, logical pixels, and how to keep clear of it.
  /// Nowhere at first.
  void setWritten(std::function<std::vector<QRectF>()> written, Clear clear) {
    m_written = std::move(written);
    m_clear = std::move(clear);
  }
  /// Over a lower view than this, logical pixels, it comes up only where it has room beside that: above it
  /// would cover what is meant. 0 at first.
  void setLeastHeight(int height) { m_leastHeight = height; }
  /// Whether it has room.
  bool hasRoom() const { return m_hasRoom; }

  /// Where else the view's lower edge is covered, in the view's pixels: it stands above what lies below it.
  /// Nowhere at first.
  void setCoveredBelow(std::function<std::vector<QRect>()> covered) { m_coveredBelow = std::move(covered); }
  /// Follows a widget that may cover the edge: where that moves, comes or goes it looks again, and as long as
  /// the pointer is on the bar it moves only from below that.
  void followCover(QWidget& cover);
  /// What covers it may be another now.
  void lookAgain() { follow(); }

  /// No such tool is in hand.
  void putAway();

signals:
  void closeRequested();

protected:
  /// The groups that stand beside each other, or below: the first begins with the words, the last ends with
  /// the button.
  QHBoxLayout* group(std::size_t number) const { return m_groups[number]; }

  bool eventFilter(QObject* watched, QEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

private:
  void place();
  bool placeBeside();
  int coveredBelow(int left, int width) const;
  bool isUnderPointer() const; ///< and nothing lies over it
  void follow();

  QBoxLayout* m_rows; ///< of the words with the first group, and of the others
  QBoxLayout* m_others;
  std::array<QHBoxLayout*, 3> m_groups{};
  QLabel* m_text;
  QTimer m_soon; ///< once the view has taken the events that wait
  std::function<bool()> m_isDrawing = [] { return false; };
  std::function<std::vector<QRect>()> m_coveredBelow = [] { return std::vector<QRect>(); };
  std::function<std::vector<QRectF>()> m_written = [] { return std::vector<QRectF>(); };
  Clear m_clear = [](const QRectF& wished, const QRectF&, const std::vector<QRectF>&) { return wished; };
  std::optional<QPoint> m_grip;       ///< while it is dragged, in the bar
  std::optional<QPoint> m_movedTo;    ///< by hand, its corner in the view
  std::vector<QRect> m_placedOver;    ///< what covered the lower edge then
  std::vector<QRectF> m_placedBeside; ///< what was written then
  int m_leastHeight = 0;
  bool m_hasRoom = true;
  bool m_stays = true;    ///< the text, where there is little room
  bool m_isOut = false;   ///< a tool is in hand
  bool m_isAside = false; ///< hidden until the button is let go
};

} // namespace limn
