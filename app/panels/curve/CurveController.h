// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/curve/HistogramController.h"
#include "scene/Scene.h"
#include "scene/volume/Histogram.h"

#include <QObject>

namespace limn {

class CurvePanel;
struct WindowContext;

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

private:
  void measureGradients();

  WindowContext& m_context;
  CurvePanel& m_panel;
  HistogramController m_histograms;
  std::shared_ptr<const Volume> m_volume;
  std::shared_ptr<const Volume> m_counted; ///< whose gradients were asked for last; null: of none
  BackgroundWork m_counting;
};

} // namespace limn
