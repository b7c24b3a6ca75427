// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace limn {

/// How large work is done: on how many threads, who is told how far it is, and who may end it. The functions
/// may be empty; they are called on the thread that asked for the work.
struct Effort {
  int threads = 0;                             ///< of the processor, 0: all
  std::function<bool()> isCancelled;           ///< true: Cancelled is thrown after the pieces in hand
  std::function<void(double fraction)> report; ///< 0..1
};

/// The effort for a part of some work: what it reports as 0..1 is `from`..`to` of the whole.
Effort partOf(const Effort& whole, double from, double to);

/// So many voxels make a piece of work: even with hundreds of instructions each, it takes less than 10 ms.
inline constexpr int voxelsPerPiece = 1 << 16;

/// Hands out the pieces 0 … count-1 of some work, each once.
class Pieces {
public:
  Pieces(int count, const Effort& effort)
      : m_count(count), m_effort(effort), m_caller(std::this_thread::get_id()) {}

  /// A piece that nobody has taken; negative where none is left or the work was stopped.
  int next();

  void stop() { m_isStopped = true; }
  bool isCancelled() const { return m_isCancelled; }

private:
  int m_count;
  const Effort& m_effort;
  std::thread::id m_caller;
  std::atomic<int> m_next{0};
  std::atomic<bool> m_isStopped{false};
  bool m_isCancelled = false; // written on the caller's thread alone
};

/// Calls `worker` on several threads at a time, the caller's among them; each takes pieces until none is
/// left. Threads that the system refuses are done without. Throws Cancelled, and what a worker throws.
void shareOut(int count, const Effort& effort, const std::function<void(Pieces&)>& worker);

/// Calls `work` once for each piece of 0 … count-1.
void forEachPiece(int count, const Effort& effort, const std::function<void(int)>& work);

} // namespace limn
