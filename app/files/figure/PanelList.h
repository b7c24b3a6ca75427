// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/FigureLayout.h"

#include <QWidget>

#include <array>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;

namespace limn {

/// What may stand in a panel of a figure. Whoever offers another kind of picture adds to the list of these.
struct PanelSource {
  QString text;      ///< in the list, and by which a choice is kept while the scenes change
  FigurePanel panel; ///< with its usual name
};

/// Chooses how many panels a figure has, what each shows and what stands above it.
class PanelList : public QWidget {
  Q_OBJECT

public:
  explicit PanelList(QWidget* parent = nullptr);

  /// What there is to choose from; choices stay where the list still has them.
  void setSources(const std::vector<PanelSource>& sources);

  /// Shows these of the sources, by their place in the list, each under its usual name.
  void choose(const std::vector<std::size_t>& sources);

  /// The panels as chosen, row by row.
  std::vector<FigurePanel> panels() const;

signals:
  void edited();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  struct Row {
    QLabel* letter = nullptr;
    QComboBox* source = nullptr;
    QLineEdit* name = nullptr;
    QString chosen;  ///< the source's text
    QString ownName; ///< typed; null: the usual one
  };

  const PanelSource& sourceOf(const Row& row) const;
  void addRow(std::size_t index);
  void setCount(int count);
  void showRow(Row& row);

  QComboBox* m_count;
  std::array<Row, mostPanels> m_rows;
  std::vector<PanelSource> m_sources;
};

} // namespace limn
