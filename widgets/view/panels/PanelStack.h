// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QObject>

class QLabel;
class QWidget;

namespace limn {

/// Stands below the pictures where the graphics driver failed and the processor draws: why, with a way to try
/// again and to copy what a report needs.
class FailureBar : public QFrame {
  Q_OBJECT

public:
  explicit FailureBar(QWidget* parent);

  /// `details`: what the driver wrote, for the clipboard.
  void setReason(const QString& sentence, const QString& details);
  bool hasReason() const { return !m_sentence.isEmpty(); }

signals:
  void retryRequested();

private:
  void copyDetails() const;

  QLabel* m_text = nullptr;
  QString m_sentence;
  QString m_details;
};

class EmptyPanel;
class FailureBar;
class LoadingPanel;
class MessagePanel;

/// What covers the pictures of a view where there is nothing to show, where drawing failed, and while
/// something loads; and what stands below them where the driver failed.
class PanelStack : public QObject {
  Q_OBJECT

public:
  explicit PanelStack(QWidget* view);

  /// Lays everything over the view as it is now and shows what applies: `sentence` says why nothing is drawn
  /// and is empty where it is.
  void arrange(bool hasVolume, const QString& sentence);

  /// What stands there without a volume.
  EmptyPanel& emptyPanel() const { return *m_empty; }

  /// `fraction` 0..1, or less than 0 where it is unknown.
  void setLoading(double fraction, const QString& text);
  void clearLoading();

  /// Why the processor draws in the driver's place, and what the driver wrote; an empty sentence: it does
  /// not.
  void setFailure(const QString& sentence, const QString& details);

  /// What the panels below the pictures take of the view's height, logical pixels.
  int takenBelow() const;

  /// What the loading panel covers of the pictures' lower edge, logical pixels.
  int coveredBelow() const;

signals:
  void loadingCancelled();
  void retryRequested();       ///< after a failure of any kind
  void driverRetryRequested(); ///< while the processor draws

private:
  QWidget* m_view;
  EmptyPanel* m_empty;
  MessagePanel* m_message;
  LoadingPanel* m_loading;
  FailureBar* m_failure;
};

} // namespace limn
