// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/figures/FigureMaker.h"
#include "app/files/exports/ExportDialog.h"
#include "app/files/figure/PanelList.h"
#include "scene/presets/Preset.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QTimer>

class QCheckBox;

namespace limn {

class FigureOptions;
class FigurePreview;
class SavingController;

/// Looks of the open volume beside the scene's own.
struct FigureLooks {
  std::optional<ComparedLook> compared; ///< unless models are
  std::optional<Preset> remembered;     ///< as "before"
  std::vector<Preset> presets;          ///< as they are shown, in the order of the list
  std::vector<std::string> fitted;      ///< names of those that were moved onto the volume's values
};

/// Asks what a figure of what is open shows, previews it while it is put together, and writes or copies it.
class FigureDialog : public ExportDialog {
  Q_OBJECT

public:
  /// `looks` tells which looks figures can show beside the scene's own; `saving` how files call the volume.
  FigureDialog(WindowContext& context, std::function<FigureLooks()> looks, const SavingController* saving);

  static ActionLook look();
  static bool suits(const Scene& scene) { return scene.volume != nullptr; }

  /// Shows the figure that was saved in a file, of the volume that is open, to be saved again.
  void reopen(const QString& file, const SourceOptions& options);

  FigureOptions& options() { return *m_options; }
  FigurePreview& preview() { return *m_preview; }

  /// The figure as asked for; its pictures are meant to be as exact as a screen shows where that is chosen.
  Figure askedFigure() const;
  bool isExact() const;
  void setExact(bool isExact);

private:
  QString doing(double fraction) const override;
  void begin(bool isNew) override;
  void showScene(const Scene& scene) override;
  void sayOutcome(const QString& sentence) override;
  void done(int result) override;
  QWidget* makeSide();
  void addButtons(QVBoxLayout* column);
  void forget();
  void connectParts();
  void refreshSources();
  void refreshPreview();
  void drawPreview(double share);
  void sayPreview(double fraction);
  void estimatePreview(const Figure& figure);
  void describe(const QString& text, bool canBeMade);
  void sayWhatItIs();
  void save();
  void copy();
  Figure wanted();
  Figure withWhatIsKnown(Figure figure) const;

  std::function<FigureLooks()> m_looks;
  const SavingController& m_saving;
  FigurePreview* m_preview;
  PanelList* m_panels;
  FigureOptions* m_options;
  QCheckBox* m_exact;
  Figure m_drawn;                        ///< whose pictures the preview shows
  std::vector<FigurePanel> m_made;       ///< its panels with what was found out as they were drawn
  std::vector<std::string> m_notes;      ///< on those pictures
  QString m_outcome;                     ///< of the last work, told until something is edited
  std::vector<FigurePanel> m_estimated;  ///< panels whose errors are known
  std::vector<PanelSource> m_saved;      ///< of the figure that was reopened
  std::weak_ptr<const Volume> m_savedOf; ///< the volume then
  bool m_showsSaved = false;             ///< they were chosen
  BackgroundWork m_reading;              ///< of that figure
  bool m_isStale = false;                ///< the scene changed while a figure was made
  QTimer m_soon;                         ///< until the scene rests
};

} // namespace limn
