// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/ShaderProgram.h"
#include "raycaster/Decisions.h"
#include "scene/EffectSet.h"

#include <map>

namespace limn {

/// The programs compiled so far, by their effects. Compiling takes a driver long enough to be felt, so a
/// picture that a known program can draw does not wait for one of its own: that is asked for when there is
/// time.
class ProgramCache {
public:
  /// The programs of one set of decisions.
  explicit ProgramCache(const Decisions& decisions = {}) : m_decisions(decisions) {}

  /// The program of a canonical set; while there is none, the smallest that draws the same picture
  /// (`canStandIn`); without such, compiles it.
  const ShaderProgram& programFor(EffectSet effects);

  /// The program of a canonical set itself.
  const ShaderProgram& exactly(EffectSet effects);

  bool has(EffectSet effects) const { return m_programs.contains(effects); }

  /// Whether `programFor` would compile nothing.
  bool canDraw(EffectSet effects) const { return has(effects) || standInFor(effects) != nullptr; }

  /// Lets the driver compile a program in the background, where it can.
  void start(EffectSet effects);

  /// How many were compiled or are being compiled.
  int compiled() const { return static_cast<int>(m_programs.size()); }

private:
  const ShaderProgram* standInFor(EffectSet effects) const;

  Decisions m_decisions;
  std::map<EffectSet, ShaderProgram> m_programs;
};

} // namespace limn
