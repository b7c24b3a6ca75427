// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QElapsedTimer>
#include <QScrollArea>
#include <QWidget>

#include <vector>

class QLabel;
class QVBoxLayout;

namespace limn {

/// The header of a FoldingSection: a button, checked while the section is open, with an arrow, the section's
/// name and a few words at the right. Enter presses it too. Assistive technology finds a button that is
/// expanded or collapsed rather than a check box, which would seem to switch on what the section is about.
class FoldingHeader : public QAbstractButton {
  Q_OBJECT

public:
  explicit FoldingHeader(const QString& title, QWidget* parent = nullptr);

  /// A few words at the right; empty for none.
  void setSummary(const QString& summary);

protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void showArrow();

  QLabel* m_arrow;
  QLabel* m_summary;
};

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

/// Parts of the window's business one below another; it scrolls down alone, and is never narrower than what
/// it holds needs beside the scroll bar. A frame shows that it has the keyboard, but not after a click
/// between its controls, where it would look like a selection.
class SectionPanel : public QScrollArea {
public:
  explicit SectionPanel(QWidget* parent = nullptr);

  /// Fills it with sections.
  void stack(const std::vector<QWidget*>& sections);

  /// Scrolls to where one of them begins at the top, or as near to that as the last of them lets it; what was
  /// unfolded or filled just now has its place first. The keyboard stays where it is.
  void scrollTo(const QWidget& section);

  /// Which of its sections are folded, from the first one; and folds those of the same panel elsewhere.
  std::vector<bool> folded() const;
  void setFolded(const std::vector<bool>& folded);

  /// Asked for anew whenever the panel is laid out: fonts and styles come later than panels.
  QSize minimumSizeHint() const override;

  /// The wheel is scrolling it, or was until a moment ago.
  bool isScrolling() const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  QElapsedTimer m_scrolled; ///< since the wheel was turned
};

/// Whether the wheel, turned over a control, is meant for it: it has the keyboard, which the wheel gives to
/// none, and did not come under the pointer just now as the panel around it was scrolled.
bool takesWheel(const QWidget& control);

} // namespace limn
