// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/ProgramCache.h"

#include "glsl/programs/ShaderVariant.h"

namespace limn {

const ShaderProgram* ProgramCache::standInFor(EffectSet effects) const {
  const ShaderProgram* smallest = nullptr;
  int fewest = effectCount + 1;
  for (const auto& [held, program] : m_programs)
    if (program.isLinked() && held.count() < fewest && canStandIn(held, effects)) {
      smallest = &program;
      fewest = held.count();
    }
  return smallest;
}

ProgramCache::ProgramCache(const Decisions& decisions, SourceOf sourceOf) : m_sourceOf(std::move(sourceOf)) {
  if (!m_sourceOf)
    m_sourceOf = [decisions](EffectSet effects) { return fragmentSource(effects, decisions); };
}

const ShaderProgram& ProgramCache::programFor(EffectSet effects) {
  const auto known = m_programs.find(effects);
  const bool isAtHand = known != m_programs.end() && (known->second.isLinked() || known->second.isReady());
  const ShaderProgram* other = isAtHand ? nullptr : standInFor(effects);
  if (other)
    return *other;
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
    program->second.finish();
  } catch (const DriverError& error) {
    m_programs.erase(program);
    m_refused.emplace(effects, error);
    throw;
  }
  return program->second;
}

void ProgramCache::start(EffectSet effects) {
  if (!has(effects))
    m_programs.emplace(effects,
                       ShaderProgram(vertexSource(), m_sourceOf(effects), ShaderProgram::Linking::started));
}

} // namespace limn
