// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/EffectCosts.h"

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

class Measurement final : public EffectMeasurement {
public:
  Measurement(std::unique_ptr<CostedDrawing> drawing, const Scene& scene, const glm::ivec2& size,
              const EffectPlan& plan)
      : m_drawing(std::move(drawing)), m_costs(scene, size, effectRows(scene, plan)) {}

  void step() override { m_costs.step(*m_drawing); }

  EffectFigures figures() const override {
    EffectFigures figures{m_costs.isComplete(), m_costs.fraction(), {}, 0.0, m_drawing->method()};
    if (figures.isComplete) {
      figures.costs = m_costs.costs();
      figures.wholeMs = m_costs.wholeMs();
    }
    return figures;
  }

private:
  std::unique_ptr<CostedDrawing> m_drawing;
  EffectCosts m_costs;
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
  EffectCost cost{medianOf(with) - medianOf(without), 0.0, {}, medianOf(without)};
  if (!differences.empty()) {
    const std::size_t quarter = differences.size() / 4;
    cost.spreadMs = 0.5 * (differences[differences.size() - 1 - quarter] - differences[quarter]);
  }
  return cost;
}

EffectCosts::EffectCosts(const Scene& scene, const glm::ivec2& size, const std::vector<EffectRow>& rows,
                         int frames)
    : m_variants{{scene, {}, {}, {}, {}}}, m_size(size), m_frames(frames) {
  for (const EffectRow& row : rows) {
    m_variantOfRow.push_back(row.isOn ? m_variants.size() : 0);
    if (!row.isOn)
      continue;
    Variant variant{scene, row.effects, {}, {}, {}};
    if (row.name == "crop")
      variant.scene.crop = {};
    if (row.name == "isosurface")
      variant.scene.projection = Projection::composite;
    m_comparesLight = m_comparesLight || variant.leftOut.hasAny(travellingLight);
    m_variants.push_back(variant);
  }
}

int EffectCosts::frameCount() const {
  const int rows = static_cast<int>(m_variants.size()) - 1;
  return firstVariant() + rows + m_frames * (rows > 0 ? 2 * rows : 1);
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

bool EffectCosts::step(CostedDrawing& drawing) {
  if (isComplete())
    return false;
  const int count = firstVariant() + static_cast<int>(m_variants.size()) - 1;
  const bool isMeasured = m_next >= count;
  const Turn turn = isMeasured ? turnAt(m_next - count)
                    : m_next < firstVariant()
                        ? Turn{}
                        : Turn{static_cast<std::size_t>(m_next - firstVariant() + 1), false};
  Variant& variant = m_variants[turn.variant];
  const Variant& drawn = turn.isWhole ? m_variants.front() : variant;
  const auto draw = [&] { drawing.draw(drawn.scene, drawn.leftOut, m_size, {{0, 0}, m_size}); };
  // What another scene needs is made ready outside the measured time.
  drawing.draw(drawn.scene, drawn.leftOut, m_size, {m_size / 2, {1, 1}});
  if (m_next == 0)
    drawing.calibrate(draw);
  else if (isMeasured)
    (turn.isWhole ? variant.wholeMs : variant.ms).push_back(drawing.measureMs(draw));
  else if (m_next < firstVariant())
    m_whole = drawing.picture(drawn.scene, drawn.leftOut, m_size);
  else if (variant.leftOut.hasAny(travellingLight))
    variant.brought = changeBetween(*m_whole, drawing.picture(drawn.scene, drawn.leftOut, m_size));
  ++m_next;
  return !isComplete();
}

double EffectCosts::fraction() const {
  return static_cast<double>(m_next) / frameCount();
}

std::vector<std::optional<EffectCost>> EffectCosts::costs() const {
  std::vector<std::optional<EffectCost>> costs;
  for (const std::size_t row : m_variantOfRow) {
    std::optional<EffectCost>& cost = costs.emplace_back();
    if (row == 0 || !isComplete())
      continue;
    const Variant& variant = m_variants[row];
    cost = costBetween(variant.wholeMs, variant.ms);
    cost->brought = variant.brought;
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

std::unique_ptr<EffectMeasurement> measurementOf(std::unique_ptr<CostedDrawing> drawing, const Scene& scene,
                                                 const glm::ivec2& size, const EffectPlan& plan) {
  return std::make_unique<Measurement>(std::move(drawing), scene, size, plan);
}

} // namespace limn
