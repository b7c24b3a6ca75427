// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/ErrorByChance.h"
#include "widgets/view/pictures/SidePicture.h"
#include "widgets/view/pictures/StepSearch.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace limn {

/// Finds out, beside pictures that are final, what pixels drawn at random say of them
/// (accuracy/sweep/ErrorByChance): one after the other, each on another thread.
class ChanceCheck {
public:
  /// Nothing is found out where `makePrecise` is empty.
  explicit ChanceCheck(MakePrecise makePrecise) : m_makePrecise(std::move(makePrecise)) {}
  ~ChanceCheck() { reset(); }

  /// Other pictures come: what is under way ends.
  void reset();

  /// Forgets what was found out of pictures that have been replaced since.
  void follow(std::span<const SidePicture> sides);

  /// Goes on; `worked` where more is known than before, `nothing` once all is known that can be.
  RestTurn step(std::span<const SidePicture> sides);

  /// Of the picture of a side; absent until it is known, or where the exact pixels do not settle.
  std::optional<ErrorByChance> error(int side) const;

private:
  struct Job;
  std::shared_ptr<Job> begin(const SidePicture& side) const;

  MakePrecise m_makePrecise;
  std::vector<std::shared_ptr<Job>> m_jobs; ///< one per side, as far as they have begun
};

} // namespace limn
