// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/ProgramCache.h"

#include "raycaster/ShaderVariant.h"

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

const ShaderProgram& ProgramCache::programFor(EffectSet effects) {
  const auto known = m_programs.find(effects);
  const bool isAtHand = known != m_programs.end() && (known->second.isLinked() || known->second.isReady());
  const ShaderProgram* other = isAtHand ? nullptr : standInFor(effects);
  return other ? *other : exactly(effects);
}

const ShaderProgram& ProgramCache::exactly(EffectSet effects) {
  start(effects);
  const auto program = m_programs.find(effects);
  try {
    program->second.finish();
  } catch (...) {
    m_programs.erase(program);
    throw;
  }
  return program->second;
}

void ProgramCache::start(EffectSet effects) {
  if (!has(effects))
    m_programs.emplace(effects, ShaderProgram(vertexSource(), fragmentSource(effects, m_decisions),
                                              ShaderProgram::Linking::started));
}

} // namespace limn
