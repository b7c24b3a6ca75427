// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/Tolerance.h"

#include <optional>
#include <vector>

namespace limn {

/// The search of `withinTolerance`, a picture at a time: for who cannot draw at once what it asks for.
class ToleranceSearch {
public:
  /// `scene.quality.toleranceLevels` must be set.
  ToleranceSearch(const Scene& scene, const glm::ivec2& size, StepControl control = StepControl::local,
                  int filterBits = mostFilterBits);

  /// A picture that is needed.
  struct Wanted {
    Scene scene;
    glm::ivec2 size{0};
  };

  /// What to draw next; absent once all is found.
  const std::optional<Wanted>& wanted() const { return m_wanted; }

  /// Goes on with the picture wanted, drawn. Compares pictures, which takes some milliseconds.
  void give(Image picture);

  /// What `withinTolerance` returns, once nothing is wanted any more.
  const WithinTolerance& found() const { return *m_found; }

private:
  struct Drawn {
    Wanted wanted;
    Image picture;
  };
  void goOn();

  Scene m_scene;
  glm::ivec2 m_size;
  StepControl m_control;
  int m_filterBits;
  std::vector<Drawn> m_drawn;
  std::optional<Wanted> m_wanted;
  std::optional<WithinTolerance> m_found;
};

} // namespace limn
