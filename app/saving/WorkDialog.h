// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QPointer>

#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace limn {

class BackgroundWork;

/// A dialog that asks for work, and says below its fields how far that is and what came of it. While it
/// works, its button to close says "Cancel": whoever closes it then asks for the work to end, and closes it
/// by a second step.
class WorkDialog : public QDialog {
  Q_OBJECT

public:
  /// Shows how far `work` is, and the sentence with which it fails.
  void follow(const BackgroundWork& work);

  void showProgress(double fraction); ///< 0..1
  /// Nothing is worked at any more; `text` says what came of it.
  void endProgress(const QString& text);
  bool isWorking() const;

signals:
  void workingChanged(bool isWorking);
  void cancelled();

protected:
  /// `name` begins the object names of its parts; `work` names the bar for those who cannot see it.
  WorkDialog(const QString& name, const QString& work, QWidget* parent);

  /// Adds what is said, the bar and the buttons: one that starts the work, one that starts `other` work.
  void addFoot(QVBoxLayout* column, QPushButton* start, QPushButton* other = nullptr);

  void say(const QString& text);
  /// Whether its fields ask for something that can be made.
  void setStartable(bool isStartable);
  QLabel* text() const { return m_text; }

  void done(int result) override;

private:
  /// What is being done at `fraction`.
  virtual QString doing(double fraction) const = 0;

  QLabel* m_text;
  QProgressBar* m_bar;
  QPushButton* m_close;
  QPointer<QWidget> m_before; ///< what had the keyboard when work began
  std::vector<QPushButton*> m_starts;
};

} // namespace limn
