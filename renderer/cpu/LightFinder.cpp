// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/LightFinder.h"

#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/LightingTerms.h"

#include <algorithm>
#include <utility>

namespace limn {
namespace {

Scene withDetail(Scene lit, LightDetail detail) {
  lit.quality.light = detail;
  return lit;
}

// Pictures side by side, and what was found of each before.
constexpr std::size_t mostWanted = 2;
constexpr std::size_t mostKnown = 6;

// How many of its points a function has otherwise.
int differences(const TransferFunction& one, const TransferFunction& other) {
  const std::size_t shared = std::min(one.points.size(), other.points.size());
  int count = static_cast<int>(std::max(one.points.size(), other.points.size()) - shared);
  for (std::size_t i = 0; i < shared; ++i)
    count += one.points[i] != other.points[i];
  return count;
}

// In how many respects scenes differ that a gesture changes one of: a gesture's scenes lie nearer to each
// other than to those of a picture beside them.
int differences(const Scene& one, const Scene& other) {
  Shading shading = other.shading;
  shading.lightDirection = one.shading.lightDirection;
  return (one.shading != shading) + (one.shading.lightDirection != other.shading.lightDirection) +
         (one.gradientOpacity != other.gradientOpacity) + (one.crop != other.crop) +
         (one.keep != other.keep) + (one.projection != other.projection) + (one.isovalue != other.isovalue) +
         differences(one.transferFunction, other.transferFunction);
}

// A grid has two details.
LightDetail gridDetail(const Quality& quality) {
  const bool isCoarse = quality.light == LightDetail::coarse || quality.light == LightDetail::moving;
  return isCoarse ? LightDetail::coarse : LightDetail::fine;
}

} // namespace

Scene litPart(const Scene& scene) {
  Scene lit = scene;
  const LightingTerms terms = lightingTerms(scene.shading);
  lit.shading.lightDirection.reset();
  if (terms.shadow.strength > 0.0)
    lit.shading.lightDirection = lightTravels(scene.shading, scene.camera);
  lit.shading.lightAxes = LightAxes::world;
  // How much is dimmed, and what colour it has, is asked where it is drawn.
  if (terms.shadow.strength > 0.0)
    lit.shading.shadow.strength = 1.0;
  if (terms.occlusion.strength > 0.0)
    lit.shading.occlusion.strength = 1.0;
  lit.transferFunction = cpu::withoutColors(lit.transferFunction);
  lit.keep = cpu::withoutColors(lit.keep);
  lit.camera = {};
  lit.fog = {};
  lit.image = {};
  lit.quality = {};
  lit.quality.light = gridDetail(scene.quality);
  return lit;
}

LightFinder::LightFinder(int threads)
    : m_data(threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency())),
             true) {}

LightVolumes LightFinder::find(const Scene& scene, const std::function<bool()>& isCancelled) {
  const Scene lit = litPart(scene);
  if (lit == m_of)
    return m_found;
  m_of = {};
  m_data.update(lit, isCancelled);
  const EffectPlan plan = requiredEffects(lit, m_data.facts(lit));
  m_found = {};
  if (plan.isVisible && plan.effects.hasAny(travellingLight))
    m_found = m_data.terms(lit, {1, 1}, plan.effects, isCancelled).travel.found;
  m_of = lit;
  return m_found;
}

LightInBackground::LightInBackground(int threads) : m_finder(threads) {
  m_thread = std::thread([this] { work(); });
}

LightInBackground::~LightInBackground() {
  {
    const std::lock_guard lock(m_mutex);
    m_ends = true;
  }
  m_changed.notify_all();
  m_thread.join();
}

LightVolumes LightInBackground::known(const Scene& scene) {
  const Scene lit = litPart(scene);
  const std::lock_guard lock(m_mutex);
  if (m_problem)
    std::rethrow_exception(std::exchange(m_problem, nullptr));
  std::erase_if(m_known, [&](const Known& known) { return known.of.volume != lit.volume; });
  std::erase_if(m_wanted, [&](const Scene& wanted) { return wanted.volume != lit.volume; });
  want(lit);
  const Known* known = exactly(lit);
  if (!known)
    known = instead(lit);
  if (!known)
    return {};
  // What is used stays longest: that of a side at rest, too.
  const auto place = std::ranges::find(m_known, known->of, &Known::of);
  std::rotate(m_known.begin(), place, place + 1);
  return m_known.front().light;
}

bool LightInBackground::isFinding(const Scene& scene) {
  const Scene lit = litPart(scene);
  const std::lock_guard lock(m_mutex);
  if (m_problem || exactly(lit))
    return false;
  if (!missing())
    want(lit); // another took its turn
  return true;
}

void LightInBackground::want(const Scene& lit) {
  const Scene fine = withDetail(lit, LightDetail::fine);
  std::erase_if(m_wanted, [&](const Scene& wanted) { return withDetail(wanted, LightDetail::fine) == fine; });
  m_wanted.push_front(lit);
  while (m_wanted.size() > mostWanted)
    m_wanted.pop_back();
  if (missing())
    m_changed.notify_all();
}

// Fine light serves a picture that asks for coarse one.
const LightInBackground::Known* LightInBackground::exactly(const Scene& lit) const {
  const Scene fine = withDetail(lit, LightDetail::fine);
  const auto found =
      std::ranges::find_if(m_known, [&](const Known& known) { return known.of == lit || known.of == fine; });
  return found == m_known.end() ? nullptr : &*found;
}

// The same more coarsely, else what is nearest to it.
const LightInBackground::Known* LightInBackground::instead(const Scene& lit) const {
  if (const Known* coarse = exactly(withDetail(lit, LightDetail::coarse)))
    return coarse;
  const auto nearest =
      std::ranges::min_element(m_known, {}, [&](const Known& known) { return differences(known.of, lit); });
  return nearest == m_known.end() ? nullptr : &*nearest;
}

// What is to be found next: coarse light of all, then fine light of what was asked for last. Of another that
// still shows it is asked for again (isFinding); of one that no longer does nobody waits for it.
std::optional<Scene> LightInBackground::missing() const {
  if (const std::optional<Scene> coarse = missingCoarse())
    return coarse;
  if (!m_wanted.empty() && !exactly(m_wanted.front()))
    return m_wanted.front();
  return std::nullopt;
}

std::optional<Scene> LightInBackground::missingCoarse() const {
  for (const Scene& wanted : m_wanted)
    if (const Scene coarse = withDetail(wanted, LightDetail::coarse); !exactly(coarse))
      return coarse;
  return std::nullopt;
}

void LightInBackground::work() {
  std::unique_lock lock(m_mutex);
  for (;;) {
    m_changed.wait(lock, [this] { return m_ends || missing(); });
    if (m_ends)
      return;
    findNext(lock);
  }
}

// Holds the lock but for the search.
void LightInBackground::findNext(std::unique_lock<std::mutex>& lock) {
  const Scene sought = *missing();
  const auto isInVain = [&] {
    const std::lock_guard inner(m_mutex);
    const bool isFine = sought.quality.light == LightDetail::fine;
    return m_ends || (isFine && missingCoarse()) || std::ranges::none_of(m_wanted, [&](const Scene& wanted) {
             return isFine ? wanted == sought : wanted.volume == sought.volume;
           });
  };
  lock.unlock();
  LightVolumes found;
  std::exception_ptr problem;
  bool isFound = true;
  try {
    found = m_finder.find(sought, isInVain);
  } catch (const Cancelled&) {
    isFound = false;
  } catch (...) {
    problem = std::current_exception();
  }
  lock.lock();
  if (!isFound)
    return;
  // What failed would fail again: its light is taken to be known, at its own detail alone, and what was known
  // of it more coarsely goes on to serve.
  if (problem && sought.quality.light == LightDetail::fine)
    if (const Known* coarse = exactly(withDetail(sought, LightDetail::coarse)))
      found = coarse->light;
  m_known.push_front({sought, found});
  if (m_known.size() > mostKnown)
    m_known.pop_back();
  m_problem = problem;
}

} // namespace limn
