// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/panels/HintBar.h"

#include <optional>

class QActionGroup;
class QPushButton;

namespace limn {

/// The bar of the tools that cut: what to do next, and how it is done.
class CutBar : public HintBar {
  Q_OBJECT

public:
  explicit CutBar(QWidget* parent);

  /// For scissors: whether a line takes away what it goes around, and how deep.
  void showScissors(bool removesInside, bool onlySeen);
  /// For pieces: `text` says which piece lies ready, or what to do; only one that does can be hidden.
  void showPiece(const QString& text, bool isPicked);
  /// How far from the place that was clicked a piece may reach, mm; nothing: anywhere.
  std::optional<double> reachMm() const;
  /// The next piece may reach anywhere.
  void forgetReach();

signals:
  /// Only values like those around the place that was clicked are meant.
  void similarRequested();
  void reachChosen();
  void insideChosen(bool removesInside);
  void depthChosen(bool onlySeen);
  void hideRequested();
  void aloneRequested();
  void lookRequested();

private:
  void makeMenuOfLess();
  void showButtons(bool ofScissors, bool ofPieces);

  QPushButton* m_inside;
  QPushButton* m_outside;
  QPushButton* m_through;
  QPushButton* m_seen;
  QPushButton* m_less;
  QActionGroup* m_reach;
  QPushButton* m_hide;
  QPushButton* m_alone;
  QPushButton* m_look;
};

} // namespace limn
