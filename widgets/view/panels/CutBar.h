// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/panels/ViewPanels.h"

#include <functional>
#include <utility>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace limn {

/// Lies over the lower edge of the pictures while a tool that cuts is in hand: what to do next, and how it is
/// done. Stays in the middle of its parent's width.
class CutBar : public PicturePanel {
  Q_OBJECT

public:
  explicit CutBar(QWidget* parent);

  /// For scissors: whether a line takes away what it goes around, and how deep.
  void showScissors(bool removesInside, bool onlySeen);
  /// For pieces: `text` says which piece lies ready, or what to do; only one that does can be hidden.
  void showPiece(const QString& text, bool isPicked);
  /// While this says so the bar is out of the way: what it lies on may be drawn around.
  void setDrawing(std::function<bool()> isDrawing) { m_isDrawing = std::move(isDrawing); }

  /// No tool that cuts is in hand.
  void putAway();

signals:
  void insideChosen(bool removesInside);
  void depthChosen(bool onlySeen);
  void hideRequested();
  void aloneRequested();
  void lookRequested();
  void closeRequested();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void place();
  void follow();

  QBoxLayout* m_rows = nullptr;
  QLabel* m_text;
  QPushButton* m_inside;
  QPushButton* m_outside;
  QPushButton* m_through;
  QPushButton* m_seen;
  QPushButton* m_hide;
  QPushButton* m_alone;
  QPushButton* m_look;
  std::function<bool()> m_isDrawing = [] { return false; };
  bool m_tellsPiece = false; ///< the text, which no tip does
  bool m_isOut = false;      ///< a tool is in hand
  bool m_isAside = false;    ///< hidden until the button is let go
};

} // namespace limn
