// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/regions/LabelColor.h"
#include "scene/view/HistogramView.h"
#include "scene/volume/Histogram.h"
#include "widgets/Gesture.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>

#include <cstddef>
#include <memory>
#include <optional>

namespace limn {

class CurvePanel;
class HistogramButton;
class Settings;
class TransferFunctionEditor;
struct WindowContext;

/// The histogram behind the curve: of the voxels that were chosen, counted beside the event loop where that
/// is not known already. The choice is kept from run to run.
class HistogramController : public QObject {
  Q_OBJECT

public:
  HistogramController(TransferFunctionEditor& editor, Settings& settings);

  /// What is hidden, and what the curve shows; of a label in hand its voxels alone count, whatever was
  /// chosen.
  void showScene(const Scene& scene, std::optional<std::size_t> label);

  /// A volume that was opened, with the histogram of all its values; null: none is open any more.
  void showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& whole);

signals:
  void failed(const QString& sentence);

private:
  /// What a histogram of the kept voxels is of.
  struct Kept {
    std::shared_ptr<const Volume> volume;
    Region keep;
    CropBox crop;
    bool operator==(const Kept&) const = default;
  };

  void choose(const HistogramView& view);
  void show();
  void count();

  TransferFunctionEditor& m_editor;
  Settings& m_settings;
  HistogramButton* m_button;
  HistogramView m_view;
  Histogram m_whole;
  TransferFunction m_function;
  bool m_isOfLabel = false;
  std::optional<glm::dvec2> m_ofPiece; ///< of a label that is a piece: the values that it hangs together by
  Kept m_wanted;
  Kept m_known; ///< of which `m_kept` is
  Histogram m_kept;
  Histogram m_shown;
  Kept m_inWork;
  BackgroundWork m_counting;
};

/// Shows in the curve panel what is open: the curves of the scene over the histograms of its volume.
class CurveController : public QObject {
  Q_OBJECT

public:
  explicit CurveController(WindowContext& context);

  CurvePanel& panel() const { return m_panel; }

  /// Shows the curves of a scene.
  void showScene(const Scene& scene);

  /// Shows a volume that was opened; `histogram` is of its values. Null: none is open any more.
  void showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram);

  /// Takes the curve of a label that has its own in hand, by its place in the list; none: the one for all
  /// tissue.
  void takeInHand(std::optional<std::size_t> label);
  std::optional<std::size_t> labelInHand() const { return m_label; }

  const TransferFunction& curveInHand() const;

  /// The scene with `function` as the curve that is in hand; where labels would have too many looks that is
  /// said, and it is the scene as it is.
  Scene withCurveInHand(const TransferFunction& function) const;

private:
  void edit(const TransferFunction& function, const Gesture& gesture);
  void showLabels(const Scene& scene);
  void measureGradients();

  WindowContext& m_context;
  CurvePanel& m_panel;
  HistogramController m_histograms;
  std::shared_ptr<const Volume> m_volume;
  std::optional<std::size_t> m_label;      ///< whose curve is in hand
  ShownColors m_colors;                    ///< of labels that have curves
  std::shared_ptr<const Volume> m_counted; ///< whose gradients were asked for last; null: of none
  double m_smoothing = 0.0;                ///< of gradients, mm
  double m_countedSmoothing = 0.0;         ///< of those that were asked for
  BackgroundWork m_counting;
};

} // namespace limn
