// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/figure/PanelList.h"
#include "app/saving/WorkDialog.h"

class QCheckBox;

namespace limn {

class FigureOptions;
class FigurePreview;

/// Asks what a figure shows, with a preview. It draws and saves nothing: it asks for it.
class FigureDialog : public WorkDialog {
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
  void describe(const QString& text, bool canBeMade);

signals:
  void edited();
  /// The preview has room for another number of pixels.
  void previewResized();
  void saveRequested();
  void copyRequested();

private:
  QString doing(double fraction) const override;
  QWidget* makeSide();
  void addButtons(QVBoxLayout* column);

  FigurePreview* m_preview;
  PanelList* m_panels;
  FigureOptions* m_options;
  QCheckBox* m_exact;
};

} // namespace limn
