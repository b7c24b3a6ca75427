// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/regions/LabelColor.h"
#include "scene/regions/LabelFigures.h"
#include "scene/regions/Region.h"
#include "widgets/Gesture.h"

#include <QAbstractTableModel>

#include <cstdint>

namespace limn {

/// The labels of a region as rows: colour and name with a mark (shown, hidden, or between), the weight in
/// percent, and whether the label has a curve of its own; dim where it has no voxel to show. Edits change
/// nothing here: they are asked for, and the answer comes by setScene.
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

  /// The colour of the square before a label's name.
  glm::dvec3 colorOf(std::size_t place) const { return m_colors.of(place); }

  /// Asks for this colour for a label, by a gesture that picks one: its own curve, which it has from then on,
  /// in that colour, with the opacities that it had. A place that is none asks for nothing.
  void setColor(std::size_t place, const glm::dvec3& color, std::uint64_t gestureId);

  /// What undo calls another colour of a label.
  QString colorText(std::size_t place) const;

  /// Asks for labels, rows of the table, to be shown or hidden; `name` is what undo calls them.
  void showRows(const std::vector<int>& rows, bool isShown, const QString& name);

  /// Asks for these labels alone, which undo calls `name`: every other one is hidden, and of these those that
  /// were hidden are shown wholly; one that is faded stays so.
  void showOnly(const std::vector<int>& rows, const QString& name);
  /// Whether that would change something and leave something to be seen.
  bool canShowOnly(const std::vector<int>& rows) const;

  /// Asks for every label to be shown wholly, where one is not.
  void showAll();
  bool areAllShown() const;

signals:
  void regionEdited(const limn::Region& region, const limn::Gesture& gesture);
  /// The label at this place was given a curve of its own.
  void curveGiven(std::size_t place);
  void refused(const QString& sentence);

private:
  bool setCurve(std::size_t place, bool isOwn);
  bool hasVoxels(std::size_t place) const;
  Region withOnly(const std::vector<int>& rows) const;
  QVariant nameData(std::size_t place, int role) const;
  QVariant weightData(std::size_t place, int role) const;
  QVariant curveData(std::size_t place, int role) const;

  Region m_region;
  TransferFunction m_function;
  ShownColors m_colors;
  std::vector<LabelFigures> m_figures;
  std::shared_ptr<const Volume> m_volume; ///< of which they are
};

} // namespace limn
