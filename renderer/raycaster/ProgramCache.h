// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/DriverHealth.h"
#include "gl/ShaderProgram.h"
#include "glsl/decisions/Decisions.h"
#include "scene/effects/EffectSet.h"

#include <functional>
#include <map>

namespace limn {

/// The programs compiled so far, by their effects. Compiling takes a driver long enough to be felt, so a
/// picture that a known program can draw does not wait for one of its own: that is asked for when there is
/// time.
class ProgramCache {
public:
  /// The text of the fragment shader for effects.
  using SourceOf = std::function<ShaderSource(EffectSet)>;

  /// The programs of one set of decisions, or of other sources.
  explicit ProgramCache(const Decisions& decisions = {}, SourceOf sourceOf = {});

  /// The program of a canonical set; while there is none, the smallest that draws the same picture
  /// (`canStandIn`); without such, compiles it. One that the driver refuses is replaced by one that looks at
  /// empty space, too. Throws DriverError where that is refused as well.
  const ShaderProgram& programFor(EffectSet effects);

  /// The program of a canonical set itself. Throws DriverError, without asking again, where the driver
  /// refused it.
  const ShaderProgram& exactly(EffectSet effects);

  /// Whether there is nothing to compile for a set: it was compiled, or refused.
  bool has(EffectSet effects) const { return m_programs.contains(effects) || m_refused.contains(effects); }

  /// Whether `programFor` would compile nothing.
  bool canDraw(EffectSet effects) const { return has(effects) || standInFor(effects) != nullptr; }

  /// Lets the driver compile a program in the background, where it can.
  void start(EffectSet effects);

  /// How many were compiled or are being compiled.
  int compiled() const { return static_cast<int>(m_programs.size()); }

private:
  const ShaderProgram* standInFor(EffectSet effects) const;

  SourceOf m_sourceOf;
  std::map<EffectSet, ShaderProgram> m_programs;
  std::map<EffectSet, DriverError> m_refused;
};

} // namespace limn
