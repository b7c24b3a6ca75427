// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <array>
#include <string>

class QComboBox;

namespace limn {

/// Asks where the columns, rows and slices of a volume run to in the patient. Each answer is told at once, so
/// that the picture shows it; the three always go to three directions.
class OrientationDialog : public QDialog {
  Q_OBJECT

public:
  /// `letters` hold at present, or are assumed (Orientation.h).
  OrientationDialog(const std::string& letters, QWidget* parent);

  void setLetters(const std::string& letters);

signals:
  void lettersChosen(const std::string& letters);

private:
  void choose(std::size_t axis, char letter);
  void flip(std::size_t axis);

  std::string m_letters;
  std::array<QComboBox*, 3> m_boxes{};
};

} // namespace limn
