// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/DriverHealth.h"
#include "gl/ShaderProgram.h"
#include "glsl/decisions/Decisions.h"
#include "scene/effects/EffectSet.h"

#include <cstdint>
#include <functional>
#include <map>

namespace limn {

/// The programs compiled so far, by their effects. Compiling takes a driver long enough to be felt, so a
/// picture that a known program can draw does not wait for one of its own: that is asked for when there is
/// time. Of more than so many the one that was not used for longest goes: hours of work ask for hundreds, and
/// each takes megabytes in a software driver.
class ProgramCache {
public:
  static constexpr std::size_t most = 40;

  /// The text of the fragment shader for effects.
  using SourceOf = std::function<ShaderSource(EffectSet)>;

  /// The programs of one set of decisions, or of other sources; so many of them at most, 1 or more.
  explicit ProgramCache(const Decisions& decisions = {}, SourceOf sourceOf = {}, std::size_t mostHeld = most);

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
  bool canDraw(EffectSet effects) { return has(effects) || standInFor(effects) != nullptr; }

  /// Whether `programFor` has one at hand that is linked.
  bool isAtHand(EffectSet effects);

  /// Lets the driver compile a program in the background, where it can.
  void start(EffectSet effects);

  /// How many were compiled or are being compiled, those that went included and the refused left out.
  int compiled() const { return m_started; }

  /// How many are held.
  std::size_t held() const { return m_programs.size(); }

private:
  struct Held {
    ShaderProgram program;
    std::uint64_t lastUse = 0;
  };

  Held* standInFor(EffectSet effects);
  const ShaderProgram& used(Held& held);
  void dropOldest();

  SourceOf m_sourceOf;
  std::size_t m_mostHeld;
  std::map<EffectSet, Held> m_programs;
  std::uint64_t m_uses = 0;
  int m_started = 0;
  std::map<EffectSet, DriverError> m_refused;
};

} // namespace limn
