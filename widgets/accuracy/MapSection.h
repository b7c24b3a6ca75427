// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/FoldingSection.h"

class QCheckBox;
class QLabel;

namespace limn {

struct ComparedPicture;
class WorkRow;

/// Switches the map of errors over the picture on and off, and says what it shows.
class MapSection : public FoldingSection {
  Q_OBJECT

public:
  explicit MapSection(QWidget* parent = nullptr);

  /// Why there is no map to be had; empty where there is.
  void setUnavailable(const QString& reason);

  /// What was compared; null takes the map back.
  void setCompared(const ComparedPicture* compared);

  /// While it is compared the box stays ticked.
  void setComparing(bool isComparing);

  /// Says why a comparison ended before there was a map.
  void sayEnded(const QString& sentence);

  /// How far the comparison is.
  WorkRow* work() const { return m_work; }

signals:
  /// The user wants the map, or no longer.
  void mapRequested(bool on);

private:
  QCheckBox* m_check;
  WorkRow* m_work;
  QLabel* m_sentence;
};

} // namespace limn
