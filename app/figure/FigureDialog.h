// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/figure/PanelList.h"

#include <QDialog>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace limn {

class FigureOptions;
class FigurePreview;

/// Asks what a figure shows, with a preview. It draws and saves nothing: it asks for it.
class FigureDialog : public QDialog {
  Q_OBJECT

public:
  explicit FigureDialog(QWidget* parent);

  PanelList& panelList() { return *m_panels; }
  FigureOptions& options() { return *m_options; }
  FigurePreview& preview() { return *m_preview; }

  /// The figure as asked for; its pictures are meant to be as exact as a screen shows where that is chosen.
  Figure figure() const;
  bool isExact() const;
  void setExact(bool isExact);

  /// Says what becomes of it: its size, its memory, what is wrong with it.
  void say(const QString& text, bool canBeMade);

  /// While a figure is made nothing else can be asked for but to cancel.
  void showProgress(double fraction, const QString& doing);
  void endProgress();
  bool isWorking() const;

signals:
  void edited();
  void saveRequested();
  void copyRequested();
  void cancelled();

protected:
  void done(int result) override;

private:
  QWidget* makeSide();
  QWidget* makeButtons();

  FigurePreview* m_preview;
  PanelList* m_panels;
  FigureOptions* m_options;
  QCheckBox* m_exact;
  QLabel* m_text;
  QProgressBar* m_bar;
  QPushButton* m_save = nullptr;
  QPushButton* m_copy = nullptr;
  QPushButton* m_close = nullptr;
  QWidget* m_side = nullptr;
};

} // namespace limn
