// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"

#include <map>

namespace limn {

/// What stands for a label in lists and legends, so that one looks as it does in the picture: the colour that
/// its file gives it, or, of one with a curve of its own, the mean colour of its voxels by that, each as much
/// as the curve makes it opaque, of some thousand of them (where it makes all of them transparent, of all
/// alike). `place` is one of the region's labels.
glm::dvec3 shownColor(const Volume& volume, const Region& region, std::size_t place);

/// The same of all labels of what is kept, as that changes: a colour is found anew only where the label's
/// curve or its voxels are others than before.
class ShownColors {
public:
  /// The colours of `region` from now on; null: there is no volume.
  void follow(const std::shared_ptr<const Volume>& volume, const Region& region);

  /// Of one of the labels of that region, which has some.
  glm::dvec3 of(std::size_t place) const;

private:
  struct Found {
    TransferFunction look;
    glm::dvec3 color;
  };
  std::shared_ptr<const Volume> m_volume;
  std::shared_ptr<const LabelMap> m_labels;
  std::map<std::size_t, Found> m_found; ///< of labels with curves of their own
};

} // namespace limn
