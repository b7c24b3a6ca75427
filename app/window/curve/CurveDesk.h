// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/curve/HistogramDesk.h"
#include "scene/Scene.h"
#include "scene/volume/Histogram.h"

#include <QObject>

#include <stop_token>
#include <thread>

namespace limn {

class CurvePanel;

/// Shows in the curve panel what is open: the curves of the scene over the histograms of its volume.
class CurveDesk : public QObject {
  Q_OBJECT

public:
  CurveDesk(CurvePanel& panel, Settings& settings);

  /// Shows the curves of a scene.
  void showScene(const Scene& scene);

  /// Shows a volume that was opened; `histogram` is of its values. Null: none is open any more.
  void showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram);

signals:
  void failed(const QString& sentence);

private:
  void measureGradients();
  void countGradients(const std::shared_ptr<const Volume>& volume, const std::stop_token& stop);

  CurvePanel& m_panel;
  HistogramDesk m_histograms;
  std::shared_ptr<const Volume> m_volume;
  std::shared_ptr<const Volume> m_counted; ///< whose gradients were asked for last; null: of none
  std::vector<std::jthread> m_threads;
};

} // namespace limn
