// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Effort.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <system_error>
#include <vector>

namespace limn {

void stopIfCancelled(const Effort& effort) {
  if (effort.isCancelled && effort.isCancelled())
    throw Cancelled();
}

int Pieces::next() {
  if (std::this_thread::get_id() == m_caller) {
    if (m_effort.isCancelled && m_effort.isCancelled()) {
      m_isCancelled = true;
      stop();
    } else if (m_effort.report) {
      m_effort.report(static_cast<double>(std::min(m_next.load(), m_count)) / m_count);
    }
  }
  if (m_isStopped)
    return -1;
  const int piece = m_next++;
  return piece < m_count ? piece : -1;
}

void shareOut(int count, const Effort& effort, const std::function<void(Pieces&)>& worker) {
  Pieces pieces(count, effort);
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      worker(pieces);
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = failure ? failure : std::current_exception();
      pieces.stop();
    }
  };
  {
    const int all =
        effort.threads > 0 ? effort.threads : static_cast<int>(std::thread::hardware_concurrency());
    std::vector<std::jthread> others;
    try {
      others.reserve(static_cast<std::size_t>(std::max(0, std::min(all, count) - 1)));
      while (others.size() < others.capacity())
        others.emplace_back(work);
    } catch (const std::system_error&) {
      // The caller's thread takes the pieces of those that the system refuses.
    }
    work();
  }
  if (failure)
    std::rethrow_exception(failure);
  if (pieces.isCancelled())
    throw Cancelled();
}

void forEachPiece(int count, const Effort& effort, const std::function<void(int)>& work) {
  shareOut(count, effort, [&work](Pieces& pieces) {
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      work(piece);
  });
}

} // namespace limn
