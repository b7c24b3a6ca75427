// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/volume/Histogram.h"

#include <map>

namespace limn {

/// The curves of the kinds of pictures of one volume: maximum, minimum, average and X-ray say nothing with a
/// curve made for tissue, so each brings its own, and gives the one before back.
class ProjectionCurves {
public:
  /// Keeps what a scene shows for its kind of picture; the curves of another volume are forgotten.
  void note(const Scene& scene);

  /// The scene as another kind of picture (withProjection), with the curve last shown as that kind or, the
  /// first time, with its own; `histogram` is the volume's. Kinds that show tissue share one.
  Scene changed(const Scene& scene, Projection projection, const Histogram& histogram) const;

private:
  enum class Kind { tissue, maximum, minimum, average, xray };
  static Kind kindOf(Projection projection);
  static TransferFunction ownCurve(const Scene& scene, Kind kind, const Histogram& histogram);

  std::shared_ptr<const Volume> m_volume;
  std::map<Kind, TransferFunction> m_shown;
};

} // namespace limn
