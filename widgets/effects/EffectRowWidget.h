// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/effects/EffectRows.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace limn {

/// One effect: a mark (filled: on, ring: off), its title, what it costs, and below why.
class EffectRowWidget : public QWidget {
  Q_OBJECT

public:
  explicit EffectRowWidget(QWidget* parent = nullptr);

  void setRow(const EffectRow& row);
  void setCost(const std::optional<EffectCost>& cost);
  bool showsCost() const;

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void showColors();
  void describe();

  EffectRow m_row;
  QLabel* m_title;
  QLabel* m_cost;
  QLabel* m_reason;
};

} // namespace limn
