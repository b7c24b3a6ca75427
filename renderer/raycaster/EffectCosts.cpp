// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/EffectCosts.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

// Draws whole pictures again, whatever happens.
struct LeftOut {
  LeftOut(RayCaster& ofCaster, EffectSet effects) : caster(ofCaster) { caster.leaveOut(effects); }
  ~LeftOut() { caster.leaveOut(std::nullopt); }
  LeftOut(const LeftOut&) = delete;
  LeftOut& operator=(const LeftOut&) = delete;
  RayCaster& caster;
};

} // namespace

double medianOf(std::vector<double> values) {
  if (values.empty())
    return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

EffectCost costBetween(const std::vector<double>& with, const std::vector<double>& without) {
  assert(with.size() == without.size());
  std::vector<double> differences;
  for (std::size_t i = 0; i < with.size(); ++i)
    differences.push_back(with[i] - without[i]);
  std::sort(differences.begin(), differences.end());
  EffectCost cost{medianOf(with) - medianOf(without), 0.0};
  if (!differences.empty()) {
    const std::size_t quarter = differences.size() / 4;
    cost.spreadMs = 0.5 * (differences[differences.size() - 1 - quarter] - differences[quarter]);
  }
  return cost;
}

EffectCosts::EffectCosts(const Scene& scene, const glm::ivec2& size, const std::vector<EffectRow>& rows,
                         int frames)
    : m_variants{{scene, {}, {}, {}}}, m_size(size), m_frames(frames) {
  for (const EffectRow& row : rows) {
    m_variantOfRow.push_back(row.isOn ? m_variants.size() : 0);
    if (!row.isOn)
      continue;
    Variant variant{scene, row.effects, {}, {}};
    if (row.name == "crop")
      variant.scene.crop = {};
    if (row.name == "isosurface")
      variant.scene.projection = Projection::composite;
    m_variants.push_back(variant);
  }
}

void EffectCosts::draw(RayCaster& caster, const Variant& variant) const {
  for (int y = 0; y < m_size.y; y += RayCaster::tileSize)
    for (int x = 0; x < m_size.x; x += RayCaster::tileSize) {
      const glm::ivec2 corner(x, y);
      caster.draw(variant.scene, m_size,
                  {corner, glm::min(glm::ivec2(RayCaster::tileSize), m_size - corner)});
    }
}

int EffectCosts::frameCount() const {
  const int rows = static_cast<int>(m_variants.size()) - 1;
  return rows + 1 + m_frames * (rows > 0 ? 2 * rows : 1);
}

// The whole picture comes first in one round and second in the next: neither gains from its place.
EffectCosts::Turn EffectCosts::turnAt(int measured) const {
  const int rows = static_cast<int>(m_variants.size()) - 1;
  if (rows == 0)
    return {};
  const int pair = measured / 2;
  const bool isFirst = measured % 2 == 0;
  const bool wholeIsFirst = pair / rows % 2 == 0;
  return {static_cast<std::size_t>(1 + pair % rows), isFirst == wholeIsFirst};
}

bool EffectCosts::step(RayCaster& caster) {
  if (isComplete())
    return false;
  const int count = static_cast<int>(m_variants.size());
  const bool isMeasured = m_next >= count;
  const Turn turn = isMeasured ? turnAt(m_next - count) : Turn{static_cast<std::size_t>(m_next), false};
  Variant& variant = m_variants[turn.variant];
  const Variant& drawn = turn.isWhole ? m_variants.front() : variant;
  const LeftOut leftOut(caster, drawn.leftOut);
  // What another scene needs on the graphics card is uploaded outside the measured time.
  caster.draw(drawn.scene, m_size, {m_size / 2, {1, 1}});
  if (m_next == 0) {
    m_timer.emplace();
    m_timer->calibrate([&] { draw(caster, drawn); });
  } else if (isMeasured) {
    (turn.isWhole ? variant.wholeMs : variant.ms).push_back(m_timer->measureMs([&] { draw(caster, drawn); }));
  }
  ++m_next;
  return !isComplete();
}

double EffectCosts::fraction() const {
  return static_cast<double>(m_next) / frameCount();
}

std::vector<std::optional<EffectCost>> EffectCosts::costs() const {
  std::vector<std::optional<EffectCost>> costs;
  for (const std::size_t row : m_variantOfRow) {
    const Variant& variant = m_variants[row];
    costs.push_back(row > 0 && isComplete() ? std::optional(costBetween(variant.wholeMs, variant.ms))
                                            : std::nullopt);
  }
  return costs;
}

double EffectCosts::wholeMs() const {
  std::vector<double> all;
  if (isComplete())
    for (const Variant& variant : m_variants)
      all.insert(all.end(), variant.wholeMs.begin(), variant.wholeMs.end());
  return medianOf(all);
}

} // namespace limn
