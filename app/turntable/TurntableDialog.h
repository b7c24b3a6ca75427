// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <glm/glm.hpp>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace limn {

class NumberField;

/// Asks how a turntable is saved. It draws nothing.
class TurntableDialog : public QDialog {
  Q_OBJECT

public:
  /// Without `hasVideo` it offers frames alone, and says why.
  TurntableDialog(bool hasVideo, QWidget* parent);

  void setSize(const glm::ivec2& pixels);
  glm::ivec2 size() const;
  int frames() const;
  double framesPerSecond() const;
  bool wantsVideo() const;

  void say(const QString& text);
  void showProgress(double fraction);
  void endProgress(const QString& text);
  bool isWorking() const;

signals:
  void saveRequested();
  void cancelled();

protected:
  void done(int result) override;

private:
  void showLength();

  NumberField* m_width;
  NumberField* m_height;
  NumberField* m_frames;
  NumberField* m_perSecond;
  QComboBox* m_kind;
  QLabel* m_text;
  QProgressBar* m_bar;
  QPushButton* m_save;
  QPushButton* m_close;
};

} // namespace limn
