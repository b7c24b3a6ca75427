// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/SectionPanel.h"
#include "widgets/effects/EffectTimes.h"

class QLabel;
class QPushButton;

namespace limn {

class EffectRowWidget;

/// What the picture simulates: a row per effect, on or off, why, and on request what each costs.
class EffectsPanel : public SectionPanel {
  Q_OBJECT

public:
  explicit EffectsPanel(QWidget* parent = nullptr);

  /// Shows the rows of the picture called `picture` ("Enhanced", or "Enhanced (right)"); none without a
  /// volume.
  void setRows(const std::vector<EffectRow>& rows, const QString& picture);

  void setTimes(const EffectTimes& times);

  QSize sizeHint() const override { return {320, 600}; }

signals:
  void measureRequested();

private:
  void showTimes();

  std::vector<EffectRow> m_shown;
  EffectTimes m_times;
  std::vector<EffectRowWidget*> m_rows;
  QWidget* m_list = nullptr;
  QLabel* m_heading = nullptr;
  QPushButton* m_measure = nullptr;
  QLabel* m_method = nullptr;
};

} // namespace limn
