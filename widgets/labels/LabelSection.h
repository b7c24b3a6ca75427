// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

class QPushButton;
class QTreeView;

namespace limn {

class LabelTable;

/// The labels of a segmentation that is open beside the volume: each is shown, hidden or faded.
class LabelSection : public FoldingSection {
  Q_OBJECT

public:
  explicit LabelSection(QWidget* parent = nullptr);

  void setScene(const Scene& scene);

signals:
  void keepEdited(const limn::Region& region, const limn::Gesture& gesture);
  void openRequested();

private:
  LabelTable* m_labels;
  QTreeView* m_table;
  QPushButton* m_open;
  QPushButton* m_showAll;
};

} // namespace limn
