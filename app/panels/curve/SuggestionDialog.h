// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Suggestion.h"

#include <QDialog>
#include <QString>

#include <optional>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace limn {

/// How the values of a volume are told.
struct ValueNames {
  QString unit;
  bool isHounsfield = false; ///< tissues have names
};

/// What a boundary is called: "Bone", "Fat to soft tissue, blood", "Surface at 460".
QString boundaryName(const Boundary& boundary, const ValueNames& names);

/// Where it lies and how much of all boundaries it is.
QString boundaryExplained(const Boundary& boundary, const ValueNames& names);

/// Lists the bands that are proposed for a volume. A row under the pointer, or with the focus, is previewed;
/// its button takes it over.
class SuggestionDialog : public QDialog {
  Q_OBJECT

public:
  explicit SuggestionDialog(QWidget* parent);

  /// Boundaries are being looked for; nothing is proposed yet.
  void showProgress(double fraction);

  /// One sentence in place of proposals.
  void showSentence(const QString& sentence);

  void setSuggestions(const std::vector<Suggestion>& suggestions, const ValueNames& names);

  /// Which of them the curve shows already.
  void setShown(const std::vector<bool>& shown);

signals:
  /// The picture is to show a band, or none any more.
  void previewed(const std::optional<std::size_t>& index);
  void chosen(std::size_t index);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void clearRows();
  QWidget* rowFor(const Suggestion& suggestion, std::size_t index, const ValueNames& names);
  void preview(const std::optional<std::size_t>& index);

  QLabel* m_text;
  QProgressBar* m_bar;
  QVBoxLayout* m_rows;
  std::vector<QPushButton*> m_buttons; ///< of the rows
  bool m_isSettling = false;           ///< buttons change by themselves
  std::optional<std::size_t> m_previewed;
};

} // namespace limn
