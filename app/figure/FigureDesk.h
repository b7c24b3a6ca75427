// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/BackgroundWork.h"
#include "app/figure/FigureMaker.h"
#include "app/figure/FigureScenes.h"

#include <QPointer>
#include <QTimer>

class QAction;
class QWidget;

namespace limn {

class CompareView;
class ComparisonDesk;
class FigureDialog;
class OpenDocument;
class PresetDesk;
class SaveNotes;
class SavingDesk;
class Session;
class Settings;

/// Makes figures of what is open: previews them while they are put together, draws and writes them beside the
/// event loop, or copies them.
class FigureDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Parts {
    Session& session;
    const OpenDocument& document;
    const PresetDesk& presets;
    const CompareView& view;
    const ComparisonDesk& comparison;
    const SavingDesk& saving; ///< says how files call the volume
    Settings& settings;
    SaveNotes& notes;
    QAction& saveFigure; ///< asks for a figure
    QWidget& window;
  };

  explicit FigureDesk(const Parts& parts);

private:
  void show();
  void refreshSources();
  void refreshPreview();
  void drawPreview(double share);
  void estimatePreview(const Figure& figure);
  void sayWhatItIs();
  void save();
  void copy();
  void make(FigurePixels pixels, const std::function<BackgroundWork::Deliver(const MadeFigure&)>& finish);
  void endWork(const QString& sentence);
  Figure wanted() const;
  Figure withKnownErrors(Figure figure) const;

  Parts m_parts;
  QPointer<FigureDialog> m_dialog;
  Figure m_drawn;                       ///< whose pictures the preview shows
  std::vector<std::string> m_notes;     ///< on those pictures
  QString m_outcome;                    ///< of the last work, told until something is edited
  std::vector<FigurePanel> m_estimated; ///< panels whose errors are known
  bool m_isStale = false;               ///< the scene changed while a figure was made
  QTimer m_soon;                        ///< until the scene rests
  BackgroundWork m_work;
};

} // namespace limn
