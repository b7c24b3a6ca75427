// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace limn {

class FoldingHeader;

/// A titled part of a panel that folds away; click, Enter or Space on the header folds it. The header can say
/// in a few words what is inside ("off").
class FoldingSection : public QWidget {
  Q_OBJECT

public:
  explicit FoldingSection(const QString& title, QWidget* parent = nullptr);

  /// Where the section's controls go, 8 px apart.
  QVBoxLayout* contents() const { return m_contents; }

  void setFolded(bool folded);
  bool isFolded() const;

  /// A few words at the right of the header; empty for none.
  void setSummary(const QString& summary);

  /// As wide as it is unfolded, so that folding moves nothing beside it.
  QSize minimumSizeHint() const override;

signals:
  /// The user folded or unfolded the section.
  void foldedByUser(bool folded);

private:
  FoldingHeader* m_header;
  QWidget* m_body;
  QVBoxLayout* m_contents;
};

} // namespace limn
