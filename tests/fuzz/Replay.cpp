// SPDX-License-Identifier: GPL-3.0-or-later
// Gives a fuzz target, named first, every file of the folders named behind it, where no fuzzer is at hand:
// what was found once stays fixed.
#include "support/FileBytes.h"

#include <cstdint>
#include <cstdio>
#include <map>

using FuzzTarget = int(const std::uint8_t* data, std::size_t size);

// The build writes the list of targets.
#define FUZZ_TARGET(name) extern "C" FuzzTarget limn_fuzz_##name;
#include "FuzzTargets.inc"
#undef FUZZ_TARGET

namespace {

const std::map<std::string, FuzzTarget*> targets = {
#define FUZZ_TARGET(name) {#name, limn_fuzz_##name},
#include "FuzzTargets.inc"
#undef FUZZ_TARGET
};

} // namespace

int main(int argc, char** argv) {
  FuzzTarget* const target = argc > 1 ? targets.at(argv[1]) : nullptr;
  int inputs = 0;
  for (int i = 2; i < argc; ++i)
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      const std::string bytes = limn::test::bytesOfFile(entry.path());
      target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++inputs;
    }
  std::printf("%d inputs did no harm\n", inputs);
  return inputs > 0 ? 0 : 1;
}
