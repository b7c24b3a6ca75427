// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/ProgramCache.h"

#include "glsl/programs/ShaderVariant.h"

#include <algorithm>

namespace limn {

ProgramCache::Held* ProgramCache::standInFor(EffectSet effects) {
  Held* smallest = nullptr;
  int fewest = effectCount + 1;
  for (auto& [its, held] : m_programs)
    if (held.program.isLinked() && its.count() < fewest && canStandIn(its, effects)) {
      smallest = &held;
      fewest = its.count();
    }
  return smallest;
}

bool ProgramCache::isAtHand(EffectSet effects) {
  const auto known = m_programs.find(effects);
  return (known != m_programs.end() && known->second.program.isLinked()) || standInFor(effects) != nullptr;
}

const ShaderProgram& ProgramCache::used(Held& held) {
  held.lastUse = ++m_uses;
  return held.program;
}

ProgramCache::ProgramCache(const Decisions& decisions, SourceOf sourceOf, std::size_t mostHeld)
    : m_sourceOf(std::move(sourceOf)), m_mostHeld(mostHeld) {
  if (!m_sourceOf)
    m_sourceOf = [decisions](EffectSet effects) { return fragmentSource(effects, decisions); };
}

const ShaderProgram& ProgramCache::programFor(EffectSet effects) {
  const auto known = m_programs.find(effects);
  const bool isAtHand =
      known != m_programs.end() && (known->second.program.isLinked() || known->second.program.isReady());
  if (Held* other = isAtHand ? nullptr : standInFor(effects))
    return used(*other);
  try {
    return exactly(effects);
  } catch (const DriverError&) {
    if (!effects.has(Effect::emptySpaceSkipping))
      throw;
    return exactly(canonical(effects.without(Effect::emptySpaceSkipping)));
  }
}

const ShaderProgram& ProgramCache::exactly(EffectSet effects) {
  const auto refused = m_refused.find(effects);
  if (refused != m_refused.end())
    throw DriverError(refused->second);
  start(effects);
  const auto program = m_programs.find(effects);
  try {
    program->second.program.finish();
  } catch (const DriverError& error) {
    m_programs.erase(program);
    --m_started;
    m_refused.emplace(effects, error);
    throw;
  }
  return used(program->second);
}

void ProgramCache::start(EffectSet effects) {
  if (has(effects))
    return;
  if (m_programs.size() >= m_mostHeld)
    dropOldest();
  ShaderProgram program(vertexSource(), m_sourceOf(effects), ShaderProgram::Linking::started);
  m_programs.emplace(effects, Held{std::move(program), ++m_uses});
  ++m_started;
}

void ProgramCache::dropOldest() {
  m_programs.erase(std::min_element(m_programs.begin(), m_programs.end(), [](const auto& a, const auto& b) {
    return a.second.lastUse < b.second.lastUse;
  }));
}

} // namespace limn
