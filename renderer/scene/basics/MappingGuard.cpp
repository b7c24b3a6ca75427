// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/MappingGuard.h"

#include "scene/basics/Error.h"

#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <mutex>

namespace limn {
namespace {

// A few volumes at a time, each with some dozen arrays.
constexpr std::size_t mostMappings = 4096;

// Read by a signal's handler: nothing here takes a lock or memory.
struct Watched {
  std::atomic<std::uintptr_t> begin{0}; // 0: free
  std::atomic<std::uintptr_t> end{0};
  std::atomic<std::atomic<bool>*> isDamaged{nullptr};
};
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

std::array<Watched, mostMappings> watchedMappings;
std::atomic<std::size_t> mostWatched{0}; // all behind are free
std::mutex changingMappings;
struct sigaction actionBefore {};
std::uintptr_t bytesOfPage = 0;

// Where a whole file vanishes, each page would be a signal of its own.
constexpr std::uintptr_t replacedAtOnce = std::uintptr_t{1} << 20;

bool replace(const Watched& mapping, void* place) {
  char* const first = static_cast<char*>(place) - reinterpret_cast<std::uintptr_t>(place) % bytesOfPage;
  const std::uintptr_t bytes =
      std::min(replacedAtOnce, mapping.end.load() - reinterpret_cast<std::uintptr_t>(first));
  return ::mmap(first, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE,
                -1, 0) != MAP_FAILED;
}

bool isReplaced(void* place) {
  const auto address = reinterpret_cast<std::uintptr_t>(place);
  for (std::size_t i = 0; i < mostWatched; ++i) {
    const Watched& mapping = watchedMappings[i];
    const std::uintptr_t begin = mapping.begin;
    if (begin == 0 || address < begin || address >= mapping.end)
      continue;
    mapping.isDamaged.load()->store(true);
    return replace(mapping, place);
  }
  return false;
}

void onBusError(int signal, siginfo_t* info, void* context) {
  const int error = errno;
  const bool done = isReplaced(info->si_addr);
  errno = error;
  if (done)
    return;
  if ((actionBefore.sa_flags & SA_SIGINFO) != 0)
    actionBefore.sa_sigaction(signal, info, context);
  else if (actionBefore.sa_handler != SIG_DFL && actionBefore.sa_handler != SIG_IGN)
    actionBefore.sa_handler(signal);
  else
    ::sigaction(signal, &actionBefore, nullptr); // it comes again, and is not ours then
}

void install() {
  bytesOfPage = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  struct sigaction action {};
  action.sa_sigaction = onBusError;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGBUS, &action, &actionBefore);
}

} // namespace

void MappingGuard::watch(void* begin, std::size_t bytes, std::atomic<bool>& isDamaged) {
  const std::lock_guard lock(changingMappings);
  if (bytesOfPage == 0)
    install();
  const auto free =
      std::ranges::find_if(watchedMappings, [](const Watched& mapping) { return mapping.begin == 0; });
  if (free == watchedMappings.end())
    throw Error(Error::Kind::other, Message::tr("Too many volumes are open; close some of them."));
  free->isDamaged = &isDamaged;
  free->end = reinterpret_cast<std::uintptr_t>(begin) + bytes;
  free->begin = reinterpret_cast<std::uintptr_t>(begin);
  mostWatched =
      std::max<std::size_t>(mostWatched, static_cast<std::size_t>(free - watchedMappings.begin()) + 1);
}

void MappingGuard::forget(void* begin) noexcept {
  const std::lock_guard lock(changingMappings);
  for (Watched& mapping : watchedMappings)
    if (mapping.begin == reinterpret_cast<std::uintptr_t>(begin))
      mapping.begin = 0;
}

} // namespace limn
