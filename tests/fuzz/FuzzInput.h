// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Error.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

namespace limn::test {

/// The bytes of an input as text.
inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A file in memory that holds the input until the next call; no disk is touched.
inline std::filesystem::path fileOf(std::string_view bytes) {
  static const int file = memfd_create("input", 0);
  if (file < 0 || ftruncate(file, 0) != 0 ||
      pwrite(file, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    std::abort();
  return "/proc/self/fd/" + std::to_string(file);
}

/// Stops the fuzzer with a reason: what happened is a fault of ours.
[[noreturn]] inline void fault(const char* reason, const char* details = "") {
  std::fprintf(stderr, "fault: %s %s\n", reason, details);
  std::abort();
}

/// Runs a parser, which may refuse its input by an Error of kind input and end in no other way.
template <class Parser>
void harmless(Parser&& parse) {
  try {
    parse();
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::input)
      fault("an error that is not of the input:", error.what());
  }
}

} // namespace limn::test
