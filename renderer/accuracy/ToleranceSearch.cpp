// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ToleranceSearch.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace limn {
namespace {

// Leaves a search that asks for a picture which is not there yet.
struct NotDrawnYet {
  ToleranceSearch::Wanted wanted;
};

} // namespace

ToleranceSearch::ToleranceSearch(const Scene& scene, const glm::ivec2& size, StepControl control,
                                 int filterBits)
    : m_scene(scene), m_size(size), m_control(control), m_filterBits(filterBits) {
  goOn();
}

void ToleranceSearch::give(Image picture) {
  assert(m_wanted);
  m_drawn.push_back({*std::exchange(m_wanted, std::nullopt), std::move(picture)});
  goOn();
}

// The search depends on nothing but its pictures: begun anew with those that are there, it comes to the same
// place and goes on from there.
void ToleranceSearch::goOn() {
  const DrawScene draw = [this](const Scene& scene, const glm::ivec2& size) {
    const auto found = std::ranges::find_if(m_drawn, [&](const Drawn& drawn) {
      return drawn.wanted.size == size && drawn.wanted.scene == scene;
    });
    if (found == m_drawn.end())
      throw NotDrawnYet{{scene, size}};
    return found->picture;
  };
  try {
    m_found = withinTolerance(m_scene, m_size, draw, m_control, m_filterBits);
  } catch (const NotDrawnYet& missing) {
    m_wanted = missing.wanted;
  }
}

} // namespace limn
