// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/effects/EffectRows.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/properties/EffectTimes.h"

#include <QWidget>

#include <optional>
#include <set>
#include <string>

class QCheckBox;
class QLabel;
class QPushButton;

namespace limn {

class WorkRow;

/// One effect: a mark (filled: on, ring: off) or, where it can be switched, a switch; its title, what it
/// costs, and below why.
class EffectRowWidget : public QWidget {
  Q_OBJECT

public:
  explicit EffectRowWidget(QWidget* parent = nullptr);

  void setRow(const EffectRow& row);
  /// What it costs, or, while it is off, what it would.
  void setCost(const std::optional<EffectCost>& cost, const std::optional<EffectCost>& wouldCost = {});
  bool showsCost() const;
  void setSwitchable(bool isSwitchable);

signals:
  void switched(const QString& effect, bool isOn);

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void showColors();
  void describe();

  EffectRow m_row;
  QCheckBox* m_switch;
  QLabel* m_title;
  QLabel* m_cost;
  QLabel* m_reason;
};

/// What the picture simulates: a row per effect, on or off, why, and on request what each costs.
class EffectsPanel : public SectionPanel {
  Q_OBJECT

public:
  explicit EffectsPanel(QWidget* parent = nullptr);

  /// Shows the rows of the picture called `picture` ("Enhanced", or "Enhanced (right)"); none without a
  /// volume.
  void setRows(const std::vector<EffectRow>& rows, const QString& picture);

  /// The names of the rows that can be switched now; none at first.
  void setSwitchable(const std::set<std::string>& effects);

  void setTimes(const EffectTimes& times);

  /// What the effect of this name is called; its name where no row has it.
  QString titleOf(const QString& effect) const;

  QSize sizeHint() const override { return {320, 600}; }

signals:
  void measureRequested();
  void cancelRequested();
  /// By the name of its row.
  void effectSwitched(const QString& effect, bool isOn);

private:
  void showSwitches();
  void showTimes();

  std::vector<EffectRow> m_shown;
  std::set<std::string> m_switchable;
  QString m_picture; ///< what it is called
  EffectTimes m_times;
  std::vector<EffectRowWidget*> m_rows;
  QWidget* m_list = nullptr;
  QLabel* m_heading = nullptr;
  QPushButton* m_measure = nullptr;
  WorkRow* m_work = nullptr;
  QLabel* m_method = nullptr;
};

} // namespace limn
