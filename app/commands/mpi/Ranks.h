// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/mpi/Carried.h"
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

  /// What all ranks found, joined two by two in a tree, on every rank. Ranks join alike: `join` gives the
  /// same whatever the grouping, and `text` is what it makes and takes.
  std::string joined(std::string text,
                     const std::function<std::string(std::string, std::string)>& join) const;

  /// Folded place by place, on the first rank.
  std::vector<ScalarShare> folded(const std::vector<ScalarShare>& shares, Folding folding) const;

  /// The numbers of all ranks one behind the other, on the first.
  std::vector<double> gathered(const std::vector<double>& numbers) const;

private:
  int m_rank = 0;
  int m_count = 1;
};

/// What the work throws, as an error that can be told to other ranks; nothing where it succeeds.
std::optional<Error> failureOf(const std::function<void()>& work);

/// What all ranks found, given what this one finds: parts of one value, joined by `joined`. All call alike;
/// what fails on any is thrown on all.
template <class Part>
Part ofAll(const Ranks& ranks, const std::function<Part()>& find) {
  Part own;
  ranks.agree(failureOf([&] { own = find(); }));
  return fromText<Part>(ranks.joined(asText(std::move(own)), [](const std::string& a, const std::string& b) {
    return asText(joined(fromText<Part>(a), fromText<Part>(b)));
  }));
}

} // namespace limn
