// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/EffectCosts.h"

#include "scene/effects/UsualEffects.h"

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

class Measurement final : public EffectMeasurement {
public:
  Measurement(std::unique_ptr<CostedDrawing> drawing, const Scene& scene, const glm::ivec2& size,
              const EffectPlan& plan)
      : m_drawing(std::move(drawing)), m_costs(scene, size, effectRows(scene, plan)) {
    m_costs.addWhatIsOff(*m_drawing);
  }

  // What drew goes with the last step: it may hold the voxels once more, for light of its own.
  void step() override {
    if (!m_drawing || m_costs.step(*m_drawing))
      return;
    m_method = m_drawing->method();
    m_drawing.reset();
  }

  EffectFigures figures() const override {
    EffectFigures figures{
        m_costs.isComplete(), m_costs.fraction(), {}, 0.0, m_drawing ? m_drawing->method() : m_method};
    figures.isWaiting = m_costs.isWaiting();
    if (figures.isComplete) {
      figures.costs = m_costs.costs();
      figures.wouldCosts = m_costs.wouldCosts();
      figures.wholeMs = m_costs.wholeMs();
    }
    return figures;
  }

private:
  std::unique_ptr<CostedDrawing> m_drawing; // null once all is measured
  EffectCosts m_costs;
  std::string m_method;
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
    : m_scene(scene), m_rows(rows), m_size(size), m_frames(frames) {
  planPicture();
}

// The picture with all its effects, and without those of each row that is on.
void EffectCosts::planPicture() {
  m_variants.push_back({0, m_scene, m_scene, {}, false, {}, {}});
  m_turns.push_back({Purpose::calibrate, 0, true});
  bool comparesLight = false;
  for (std::size_t row = 0; row < m_rows.size(); ++row) {
    if (!m_rows[row].isOn)
      continue;
    Variant variant{row, m_scene, m_scene, m_rows[row].effects, false, {}, {}};
    if (m_rows[row].name == "crop")
      variant.without.crop = {};
    if (m_rows[row].name == "isosurface")
      variant.without.projection = Projection::composite;
    comparesLight = comparesLight || variant.leftOut.hasAny(travellingLight);
    m_variants.push_back(variant);
  }
  if (comparesLight)
    m_turns.push_back({Purpose::compare, 0, true});
  for (std::size_t i = 1; i < m_variants.size(); ++i)
    m_turns.push_back({Purpose::prepare, i, false});
  if (m_variants.size() > 1)
    return planRounds(1, m_variants.size());
  for (int frame = 0; frame < m_frames; ++frame)
    m_turns.push_back({Purpose::measure, 0, true});
}

void EffectCosts::addWhatIsOff(const CostedDrawing& drawing) {
  assert(m_next == 0);
  const SceneFacts facts = drawing.factsOf(m_scene);
  for (std::size_t row = 0; row < m_rows.size(); ++row)
    if (const std::optional<Scene> with = withUsualEffect(m_scene, m_rows[row], facts);
        with && drawing.canDraw(*with)) {
      m_variants.push_back({row, *with, m_scene, m_rows[row].effects, true, {}, {}});
      const std::size_t last = m_variants.size() - 1;
      m_turns.push_back({Purpose::compare, last, true});
      m_turns.push_back({Purpose::prepare, last, false});
      planRounds(last, m_variants.size());
    }
  // Whoever draws goes on with the picture: what that needs is there again.
  if (m_variants.back().isOff)
    m_turns.push_back({Purpose::prepare, 0, true});
}

// The picture with all effects comes first in one round and second in the next: neither gains from its place.
void EffectCosts::planRounds(std::size_t first, std::size_t end) {
  for (int round = 0; round < m_frames; ++round)
    for (std::size_t i = first; i < end; ++i)
      for (const bool isFirst : {true, false})
        m_turns.push_back({Purpose::measure, i, isFirst == (round % 2 == 0)});
}

bool EffectCosts::step(CostedDrawing& drawing) {
  if (isComplete())
    return false;
  const Turn& turn = m_turns[m_next];
  const Variant& variant = m_variants[turn.variant];
  const bool hasOwnLight = variant.isOff && variant.leftOut.hasAny(travellingLight);
  m_isWaiting = !drawing.useLightOf(hasOwnLight ? variant.with : m_scene);
  if (m_isWaiting)
    return true;
  draw(drawing, turn);
  ++m_next;
  return !isComplete();
}

void EffectCosts::draw(CostedDrawing& drawing, const Turn& turn) {
  Variant& variant = m_variants[turn.variant];
  const Scene& scene = turn.isWith ? variant.with : variant.without;
  const EffectSet leftOut = turn.isWith || variant.isOff ? EffectSet() : variant.leftOut;
  const auto all = [&] { drawing.draw(scene, leftOut, m_size, {{0, 0}, m_size}); };
  const bool bringsLight = variant.leftOut.hasAny(travellingLight);
  // What another scene needs is made ready outside the measured time.
  drawing.draw(scene, leftOut, m_size, {m_size / 2, {1, 1}});
  switch (turn.purpose) {
  case Purpose::calibrate:
    return drawing.calibrate(all);
  case Purpose::compare:
    if (!variant.isOff || bringsLight)
      m_with = drawing.picture(scene, leftOut, m_size);
    return;
  case Purpose::prepare:
    if (!turn.isWith && bringsLight)
      variant.brought = changeBetween(*m_with, drawing.picture(scene, leftOut, m_size));
    return;
  case Purpose::measure:
    (turn.isWith ? variant.withMs : variant.ms).push_back(drawing.measureMs(all));
    return;
  }
}

double EffectCosts::fraction() const {
  return static_cast<double>(m_next) / static_cast<double>(m_turns.size());
}

std::vector<std::optional<EffectCost>> EffectCosts::costsOf(bool areOff) const {
  std::vector<std::optional<EffectCost>> costs(m_rows.size());
  for (std::size_t i = 1; isComplete() && i < m_variants.size(); ++i) {
    const Variant& variant = m_variants[i];
    if (variant.isOff != areOff)
      continue;
    std::optional<EffectCost>& cost = costs[variant.row];
    cost = costBetween(variant.withMs, variant.ms);
    cost->brought = variant.brought;
  }
  return costs;
}

std::vector<std::optional<EffectCost>> EffectCosts::costs() const {
  return costsOf(false);
}

std::vector<std::optional<EffectCost>> EffectCosts::wouldCosts() const {
  return costsOf(true);
}

double EffectCosts::wholeMs() const {
  std::vector<double> all;
  if (isComplete())
    for (const Variant& variant : m_variants)
      if (!variant.isOff)
        all.insert(all.end(), variant.withMs.begin(), variant.withMs.end());
  return medianOf(all);
}

std::unique_ptr<EffectMeasurement> measurementOf(std::unique_ptr<CostedDrawing> drawing, const Scene& scene,
                                                 const glm::ivec2& size, const EffectPlan& plan) {
  return std::make_unique<Measurement>(std::move(drawing), scene, size, plan);
}

} // namespace limn
