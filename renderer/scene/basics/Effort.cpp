// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Effort.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>

namespace limn {

Effort partOf(const Effort& whole, double from, double to) {
  Effort part = whole;
  if (whole.report)
    part.report = [report = whole.report, from, to](double fraction) {
      report(from + fraction * (to - from));
    };
  return part;
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

namespace {

// Threads come in as long as it is open, and are waited for only once they are in: a thread that a busy
// system starts late holds nobody up.
class Gate {
public:
  bool enter() {
    const std::lock_guard lock(m_mutex);
    m_inside += m_isOpen ? 1 : 0;
    return m_isOpen;
  }

  void leave() {
    const std::lock_guard lock(m_mutex);
    --m_inside;
    m_left.notify_one();
  }

  void closeAndWait() {
    std::unique_lock lock(m_mutex);
    m_isOpen = false;
    m_left.wait(lock, [this] { return m_inside == 0; });
  }

private:
  std::mutex m_mutex;
  std::condition_variable m_left;
  int m_inside = 0;
  bool m_isOpen = true;
};

} // namespace

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
  const auto gate = std::make_shared<Gate>();
  const int all = effort.threads > 0 ? effort.threads : static_cast<int>(std::thread::hardware_concurrency());
  try {
    for (int n = 1; n < std::min(all, count); ++n)
      std::thread([gate, &work] {
        if (!gate->enter())
          return;
        work();
        gate->leave();
      }).detach();
  } catch (const std::system_error&) {
    // The caller's thread takes the pieces of those that the system refuses.
  } catch (const std::bad_alloc&) {
  }
  work();
  gate->closeAndWait();
  if (failure)
    std::rethrow_exception(failure);
  if (pieces.isCancelled())
    throw Cancelled();
  if (effort.report)
    effort.report(1.0);
}

void forEachPiece(int count, const Effort& effort, const std::function<void(int)>& work) {
  shareOut(count, effort, [&work](Pieces& pieces) {
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      work(piece);
  });
}

} // namespace limn
