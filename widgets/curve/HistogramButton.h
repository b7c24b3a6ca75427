// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/HistogramView.h"

#include <QToolButton>

namespace limn {

/// Chooses what stands behind the curve: how high, and of which voxels.
class HistogramButton : public QToolButton {
  Q_OBJECT

public:
  explicit HistogramButton(QWidget* parent = nullptr);

  void setView(const HistogramView& view);

signals:
  void viewChosen(const limn::HistogramView& view);

protected:
  void changeEvent(QEvent* event) override;

private:
  template <class Choice>
  void addChoice(Choice choice, Choice HistogramView::*part, const QString& text, const QString& help);
  void addHeading(const QString& text);

  void showIcon();

  HistogramView m_view;
};

} // namespace limn
