// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/regions/LabelFigures.h"
#include "scene/regions/Region.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

#include <QAbstractTableModel>

#include <map>

class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace limn {

class LabelTree;

/// The labels of a region as rows: colour and name with a mark (shown, hidden, or between), the weight in
/// percent, and whether the label has a curve of its own. Edits change nothing here: they are asked for, and
/// the answer comes by setScene.
class LabelTable : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { nameColumn, weightColumn, curveColumn, columns };
  /// Of the name: what the label is, and of which sort, as its file says.
  enum Role { typeRole = Qt::UserRole, categoryRole };

  using QAbstractTableModel::QAbstractTableModel;

  /// With the opacities of the scene's function, in the label's colour, a label's own curve begins; rows have
  /// the colour in which the scene shows their label.
  void setScene(const Scene& scene);
  const Region& region() const { return m_region; }

  /// What the voxels of each label say of `volume`, for their tool tips; null: nothing is known yet.
  void setFigures(const std::vector<LabelFigures>& figures, const std::shared_ptr<const Volume>& volume);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// Asks for labels, rows of the table, to be shown or hidden; `name` is what undo calls them.
  void showRows(const std::vector<int>& rows, bool isShown, const QString& name);

signals:
  void regionEdited(const limn::Region& region, const limn::Gesture& gesture);
  /// The label at this place was given a curve of its own.
  void curveGiven(std::size_t place);
  void refused(const QString& sentence);

private:
  bool setCurve(std::size_t place, bool isOwn);
  void findColors(const Scene& scene);
  QVariant nameData(std::size_t place, int role) const;
  QVariant weightData(std::size_t place, int role) const;
  QVariant curveData(std::size_t place, int role) const;

  Region m_region;
  TransferFunction m_function;
  std::map<std::size_t, glm::dvec3> m_colors; ///< of labels with curves of their own
  std::vector<LabelFigures> m_figures;
  std::shared_ptr<const Volume> m_volume; ///< of which they are
};

/// The labels of a segmentation that is open beside the volume: each is shown, hidden or faded, with the
/// scene's curve or its own. Many of one kind stand in a group, which is shown and hidden at once.
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
  /// Labels are listed that were not before.
  void opened();
  /// The curve of the label at this place shall be in hand.
  void curveRequested(std::size_t place);
  /// What was asked for cannot be, and why.
  void refused(const QString& sentence);

private:
  void fitTable();

  LabelTable* m_labels;
  LabelTree* m_tree;
  QSortFilterProxyModel* m_found;
  QLineEdit* m_search;
  QTreeView* m_table;
  QPushButton* m_open;
  QPushButton* m_showAll;
};

} // namespace limn
