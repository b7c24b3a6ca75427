// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/bricks/BrickRenderer.h"
#include "scene/basics/Error.h"

#include <functional>
#include <mpi.h>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// The processes that draw a picture together, each a rank, and what they say to each other: a thin face of
/// MPI. Where nothing else is said, all ranks call a function alike. A rank that dies ends all of them.
class Ranks {
public:
  Ranks(int& argc, char**& argv);
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return m_rank; }
  int count() const { return m_count; }
  bool isFirst() const { return m_rank == 0; } ///< it decides, talks and writes

  /// How many of them share this one's machine, itself included.
  int onThisMachine() const;

  /// The text of the first rank, on every rank.
  std::string fromFirst(const std::string& text) const;

  /// Throws on every rank what failed on the lowest one that failed.
  void agree(const std::optional<Error>& failure) const;

  /// The smallest of all ranks, place by place, on every rank.
  void smallest(std::vector<float>& values) const;

  /// Folded place by place, on the first rank.
  std::vector<ScalarShare> folded(const std::vector<ScalarShare>& shares, Folding folding) const;

  /// The numbers of all ranks one behind the other, on the first.
  std::vector<double> gathered(const std::vector<double>& numbers) const;

private:
  int m_rank = 0;
  int m_count = 1;
};

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

/// What the work throws, as an error that can be told to other ranks; nothing where it succeeds.
std::optional<Error> failureOf(const std::function<void()>& work);

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
