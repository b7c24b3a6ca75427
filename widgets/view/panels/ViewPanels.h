// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>
#include <QStringList>

#include <optional>
#include <vector>

class QBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace limn {

/// Lies where pictures lie, so that it is dark in every theme; in that of high contrast it has its colours.
class PicturePanel : public QFrame {
  Q_OBJECT

public:
  explicit PicturePanel(QWidget* parent);

protected:
  void changeEvent(QEvent* event) override;

private:
  std::optional<bool> m_isContrast; ///< for which it is dressed
  void dress();
};

/// Covers the view while there is no volume: where to drop one, three ways to open one, what was left
/// unfinished, and what was opened before. In a low view what is only told gives way, never a button that
/// opens something for the first time. The keyboard stands on what is likeliest, so that Enter does it.
class EmptyPanel : public PicturePanel {
  Q_OBJECT

public:
  explicit EmptyPanel(QWidget* parent);

  /// Latest first; the first few are offered, which Del or a right click take out of the list.
  void setRecentSources(const QStringList& texts);

  /// What was left with unsaved changes, as a few words; empty: nothing. The keyboard stands on it where it
  /// `isLatest`, newer than all that was opened before; else it stands below that.
  void setUnfinished(const QString& text, bool isLatest = true);

  /// What it offers stands above this, which may lie over its lower edge, as long as that is seen.
  void keepClearOf(QWidget& cover);

  /// Gives the keyboard to what is likeliest to be wanted.
  void takeFocus() { showLikeliest(true); }

signals:
  void continueRequested(); ///< with what was left unfinished
  void openFolderRequested();
  void openFileRequested();
  void sampleRequested();
  void recentRequested(int number); ///< of setRecentSources, from 0 on
  void recentRemovalRequested(int number);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void fit();
  int coveredBelow() const; ///< of its height, pixels
  QPushButton* likeliest() const;
  void showLikeliest(bool takesFocus);

  QWidget* m_target = nullptr;
  QBoxLayout* m_ways = nullptr; ///< to open one
  QPushButton* m_folder = nullptr;
  QPushButton* m_continue = nullptr;
  QLabel* m_title = nullptr;
  QLabel* m_formats = nullptr;
  QWidget* m_recent = nullptr;
  std::vector<QPointer<QWidget>> m_covers;
  bool m_isUnfinishedLatest = true;
  bool m_hasRecent = false;
  bool m_hasArrow = true;
};

/// Covers the view where drawing failed: the sentence, and a way to try again.
class MessagePanel : public PicturePanel {
  Q_OBJECT

public:
  explicit MessagePanel(QWidget* parent);
  void setSentence(const QString& sentence);

signals:
  void retryRequested();

private:
  QLabel* m_text = nullptr;
};

/// A thin line at the lower edge of the view that says what loads, how far it is, and can be cancelled.
class LoadingPanel : public PicturePanel {
  Q_OBJECT

public:
  explicit LoadingPanel(QWidget* parent);
  /// `fraction` 0..1, or less than 0 where it is unknown.
  void setProgress(double fraction, const QString& text);

signals:
  void cancelled();

private:
  QLabel* m_text = nullptr;
  QProgressBar* m_bar = nullptr;
};

/// A button of a panel that lies over the pictures: `text` is its label and what assistive technology reads,
/// `name` its object name.
QPushButton* panelButton(const QString& text, const QString& name, QWidget* parent);

} // namespace limn
