// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/rays/Threads.h"

#include "scene/basics/Error.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <optional>
#include <thread>

#ifdef LIMN_TELLS_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace limn::cpu {
namespace {

// Work begins after what its caller did before, and ends before what its caller does next. TBB sees to that
// where ThreadSanitizer does not look, which is therefore told of it here. The places stand for all calls,
// because reading anything that a caller made would need the order already.
#ifdef LIMN_TELLS_THREAD_SANITIZER
char forked, joined;
void workIsReady() {
  __tsan_release(&forked);
}
void workIsDone() {
  __tsan_acquire(&joined);
}
struct InOrder {
  InOrder() { __tsan_acquire(&forked); }
  ~InOrder() { __tsan_release(&joined); }
};
#else
void workIsReady() {}
void workIsDone() {}
struct InOrder {};
#endif

} // namespace

void forEach(int count, int threads, const std::function<void(int)>& work,
             const std::function<bool()>& isCancelled, int together) {
  // By itself TBB has no more threads than the processor.
  std::optional<tbb::global_control> limit;
  if (threads > tbb::this_task_arena::max_concurrency())
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  const std::thread::id caller = std::this_thread::get_id();
  tbb::task_group_context context;
  bool isStopped = false; // written on the caller's thread alone
  arena.execute([&] {
    const auto piece = [&](const tbb::blocked_range<int>& range) {
      [[maybe_unused]] const InOrder order;
      for (int i = range.begin(); i != range.end() && !context.is_group_execution_cancelled(); ++i) {
        if (isCancelled && std::this_thread::get_id() == caller && isCancelled()) {
          isStopped = true;
          context.cancel_group_execution();
          return;
        }
        work(i);
      }
    };
    workIsReady();
    tbb::parallel_for(tbb::blocked_range<int>(0, count, static_cast<std::size_t>(together)), piece,
                      tbb::simple_partitioner(), context);
  });
  workIsDone();
  if (isStopped)
    throw Cancelled();
}

} // namespace limn::cpu
