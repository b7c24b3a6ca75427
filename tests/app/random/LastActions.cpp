// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/random/LastActions.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <unistd.h>

namespace limn::test {
namespace {

constexpr std::size_t keptActions = 40;
constexpr std::size_t longestAction = 160;
constexpr unsigned silenceSeconds = 120;

// Plain memory, which a signal handler may read.
std::array<std::array<char, longestAction>, keptActions> actions;
std::size_t noted = 0;
std::array<char, 64> heading;

template <class Write>
void forEachKept(Write write) {
  for (std::size_t i = noted > keptActions ? noted - keptActions : 0; i < noted; ++i)
    write(actions[i % keptActions].data());
}

void tell(const char* text) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text));
}

void die(int signal) {
  tell(signal == SIGALRM ? "\nThe window did nothing for two minutes" : "\nThe window died");
  tell(heading.data());
  forEachKept([](const char* action) { tell(action); });
  std::signal(signal, SIG_DFL);
  raise(signal);
}

} // namespace

void watchForDeath(unsigned seed) {
  std::snprintf(heading.data(), heading.size(), " with seed %u; it did last:\n", seed);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGALRM})
    std::signal(signal, die);
}

void noteAction(const QString& action) {
  std::snprintf(actions[noted % keptActions].data(), longestAction, "  %s\n", qPrintable(action));
  ++noted;
  alarm(silenceSeconds);
}

std::string lastActions() {
  std::string text;
  forEachKept([&](const char* action) { text += action; });
  return text;
}

} // namespace limn::test
