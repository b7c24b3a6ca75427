// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/mpi/Ranks.h"
#include "app/commands/mpi/SharedFacts.h"

#include <functional>
#include <memory>
#include <vector>

namespace limn {

/// The ranks in the order in which their bricks stand in front of each other. MPI folds in its own tree, and
/// keeps the order of an operation that does not commute.
class RanksInOrder {
public:
  /// `order` names the ranks from front to back.
  RanksInOrder(const Ranks& ranks, const std::vector<int>& order);
  ~RanksInOrder();
  RanksInOrder(const RanksInOrder&) = delete;
  RanksInOrder& operator=(const RanksInOrder&) = delete;

  /// Puts the pixels of all ranks over each other into `folded` of the first rank; others may give null.
  void over(const std::vector<glm::vec4>& share, glm::vec4* folded) const;

private:
  int m_first = 0; ///< the place of the first rank
  MPI_Comm m_ranks = MPI_COMM_NULL;
  MPI_Datatype m_pixel = MPI_DATATYPE_NULL;
  MPI_Op m_over = MPI_OP_NULL;
};

/// What a rank did so far.
struct RankCost {
  double samples = 0.0;     ///< of the pictures' rays, in its brick, those stepped over included
  double foldedBytes = 0.0; ///< what it gave to be folded
  double ownMb = 0.0;       ///< the most memory of its own (anonymous) seen between two strips, MB (10⁶)
  double addedMb = 0.0; ///< the most that it had at any time beyond what it had before it read a volume, MB;
                        ///< pages of files are among it, of voxels on the disk, too
};

/// What this process has asked the system to read so far, bytes; what it touches of mapped files is not
/// among them.
double bytesRead();

/// Draws pictures on all ranks, the brick of each.
class SharedDrawing {
public:
  /// Before this rank reads a volume: memory counts from here on.
  SharedDrawing(const Ranks& ranks, int threads);

  /// All ranks call it alike; `scene` gives them the same scene and may throw. The picture is the first
  /// rank's; others get an empty one. Throws on all ranks what fails on any.
  Image draw(const std::function<Scene()>& scene, const glm::ivec2& size);

  const Message& limitation() const { return m_renderer.limitation(); }
  const RankCost& cost() const { return m_cost; }

private:
  std::shared_ptr<const Volume> holding(const Scene& scene, const IndexBox& brick);
  void drawStrip(const PixelRect& strip, const RanksInOrder& inOrder, Image& picture);
  void foldScalars(const PixelRect& strip, Image& picture);
  void noteMemory();

  const Ranks& m_ranks;
  SharedFacts m_facts;
  std::shared_ptr<const Volume> m_reread; // where a scene needs other voxels than those that were read first
  BrickRenderer m_renderer;
  double m_startMb = 0.0;
  RankCost m_cost;
};

/// The memory that is this process's alone and lies in no file, MB (10⁶ bytes).
double ownMemoryMb();

} // namespace limn
