// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"

#include <QComboBox>
#include <QStringList>
#include <QWidget>

namespace limn {

class ResetLabel;

/// A drop-down list that the wheel changes only while it has the keyboard, which the wheel does not give it,
/// so that scrolling a panel changes nothing on the way. Longer words than there is room for end in an
/// ellipsis; the list that opens has them all, in rows with room around their words.
class QuietComboBox : public QComboBox {
public:
  explicit QuietComboBox(QWidget* parent = nullptr);

  void showPopup() override;

protected:
  void initStyleOption(QStyleOptionComboBox* option) const override;
  void wheelEvent(QWheelEvent* event) override;
};

/// One of a few: its name and a drop-down list. A double click on the name resets.
class ChoiceRow : public QWidget {
  Q_OBJECT

public:
  /// `help` is one sentence on what it does to the picture; `defaultIndex` is named in the tool tip.
  ChoiceRow(const QString& label, const QString& help, const QStringList& choices, int defaultIndex,
            QWidget* parent = nullptr);

  /// What undo calls the choice, where that is not its label.
  void setCalled(const QString& name) { m_called = name; }

  void setIndex(int index);

  /// Disables the control and says why in its tool tip; an empty reason enables it.
  void setUnavailable(const QString& reason);

  QComboBox* box() const { return m_box; }

signals:
  void indexEdited(int index, const limn::Gesture& gesture);

private:
  void edit(int index);

  QString m_called; ///< by undo
  QString m_toolTip;
  int m_default;
  int m_index = 0;
  ResetLabel* m_label;
  QComboBox* m_box;
};

} // namespace limn
