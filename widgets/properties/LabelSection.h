// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/FoldingSection.h"
#include "widgets/properties/LabelTable.h"

#include <memory>
#include <optional>
#include <string>

class QModelIndex;
class QPushButton;
class QRect;
class QSortFilterProxyModel;
class QTreeView;

namespace limn {

class LabelTree;
class SearchField;

/// The labels of a segmentation that is open beside the volume: each is shown, hidden or faded, with the
/// scene's curve or its own, which a colour begins that is picked for it. Many of one kind stand in a group,
/// which is shown and hidden at once.
class LabelSection : public FoldingSection {
  Q_OBJECT

public:
  explicit LabelSection(QWidget* parent = nullptr);

  void setScene(const Scene& scene);
  void setFigures(const std::vector<LabelFigures>& figures, const std::shared_ptr<const Volume>& volume) {
    m_labels->setFigures(figures, volume);
  }

  /// Selects the label at this place, if there is one, where it is seen.
  void select(std::size_t place);

signals:
  void keepEdited(const limn::Region& region, const limn::Gesture& gesture);
  void openRequested();
  /// A segmentation is listed that was not before.
  void opened();
  /// The curve of the label at this place shall be in hand.
  void curveRequested(std::size_t place);
  /// What was asked for cannot be, and why.
  void refused(const QString& sentence);

private:
  void fitTable();
  std::optional<std::size_t> labelAt(const QModelIndex& row) const;
  void pickColor(const QModelIndex& row, const QRect& square);
  void openMenu();

  LabelTable* m_labels;
  LabelTree* m_tree;
  QSortFilterProxyModel* m_found;
  SearchField* m_search;
  QTreeView* m_table;
  QPushButton* m_open;
  QPushButton* m_showAll;
  std::shared_ptr<const Volume> m_volume; ///< of which labels are listed, null where none are
  std::vector<std::string> m_sources;     ///< of these
};

} // namespace limn
