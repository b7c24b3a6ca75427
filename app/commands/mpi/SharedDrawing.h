// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/mpi/Ranks.h"

namespace limn {

/// What a rank did so far.
struct RankCost {
  double samples = 0.0;     ///< of the pictures' rays, in its brick, those stepped over included
  double foldedBytes = 0.0; ///< what it gave to be folded
  double ownMb = 0.0;       ///< the most memory of its own (anonymous) seen between two strips, MB (10⁶)
};

/// Draws pictures on all ranks, the brick of each.
class SharedDrawing {
public:
  SharedDrawing(const Ranks& ranks, int threads) : m_ranks(ranks), m_renderer(threads) {}

  /// All ranks call it alike; `scene` gives them the same scene and may throw. The picture is the first
  /// rank's; others get an empty one. Throws on all ranks what fails on any.
  Image draw(const std::function<Scene()>& scene, const glm::ivec2& size);

  const Message& limitation() const { return m_renderer.limitation(); }
  const RankCost& cost() const { return m_cost; }

private:
  void drawStrip(const PixelRect& strip, const RanksInOrder& inOrder, Image& picture);
  void foldScalars(const PixelRect& strip, Image& picture);
  void noteMemory();

  const Ranks& m_ranks;
  BrickRenderer m_renderer;
  RankCost m_cost;
};

/// The memory that is this process's alone and lies in no file, MB (10⁶ bytes).
double ownMemoryMb();

} // namespace limn
