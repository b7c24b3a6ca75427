// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/MeasureText.h"
#include "widgets/controls/FoldingSection.h"

#include <array>
#include <memory>
#include <vector>

class QPushButton;
class QToolButton;
class QTreeWidget;

namespace limn {

/// What was measured in the volume, in the order in which it was made: name and value, each can be shown,
/// hidden, renamed and deleted. Changes nothing: it asks.
class MeasureSection : public FoldingSection {
  Q_OBJECT

public:
  explicit MeasureSection(QWidget* parent = nullptr);

  /// Shows these, of a volume (null: none is open), and which is in hand.
  void setMeasured(const std::vector<Measured>& measured, const std::shared_ptr<const Volume>& volume,
                   std::optional<std::size_t> inHand);

  bool hasRows() const { return !m_measured.empty(); }

signals:
  void measurementsEdited(const limn::MeasurementsEdited& edited);
  /// Somebody has measured while nothing was measured yet.
  void begun();
  /// The one at this place of the list shall be gone to.
  void chosen(std::size_t number);
  void toolRequested(limn::Measurement::Kind kind);

protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void addTools();
  void showIcons();
  void showRows(std::optional<std::size_t> inHand);
  void showRow(std::size_t number);
  void takeRow(int row);
  void remove();

  std::vector<Measured> m_measured;
  std::shared_ptr<const Volume> m_volume;
  QTreeWidget* m_list;
  QPushButton* m_delete;
  std::array<QToolButton*, measurementKinds.size()> m_tools{};
};

} // namespace limn
