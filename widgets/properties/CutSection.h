// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/regions/Cut.h"
#include "widgets/controls/FoldingSection.h"

#include <memory>
#include <vector>

class QListWidget;
class QPushButton;

namespace limn {

/// What was cut away by hand, in order: each can be switched, moved and deleted. Changes nothing: it asks.
class CutSection : public FoldingSection {
  Q_OBJECT

public:
  explicit CutSection(QWidget* parent = nullptr);

  void setScene(const Scene& scene);

signals:
  /// The list shall be this; `gesture` is what undo calls that.
  void cutsEdited(const std::vector<limn::Cut>& cuts, const QString& gesture);
  void scissorsRequested();
  void pieceRequested();
  /// The curve of the label at this place, a piece's own, shall be in hand.
  void curveRequested(std::size_t label);

private:
  void showCuts();
  void showButtons();
  void moveBy(int rows);
  void remove();

  std::vector<Cut> m_cuts;
  Region m_keep; ///< with what the cuts take among its labels
  std::shared_ptr<const Volume> m_volume;
  QListWidget* m_list;
  QPushButton* m_scissors;
  QPushButton* m_piece;
  QPushButton* m_up;
  QPushButton* m_down;
  QPushButton* m_delete;
};

/// The range of a piece as far as the volume has values: what it was picked with may reach beyond.
ValueRange foundRange(const ConnectedPiece& piece, const Volume& volume);

/// What a list of cuts says of one of a volume: "Scissors, inside", "Piece 226 – 3071 HU, hidden".
QString cutText(const Cut& cut, const Volume& volume);

} // namespace limn
