// SPDX-License-Identifier: GPL-3.0-or-later
// Gives a fuzz target every file of the folders named, where no fuzzer is at hand: what was found once stays
// fixed.
#include "support/FileBytes.h"

#include <cstdint>
#include <cstdio>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  int inputs = 0;
  for (int i = 1; i < argc; ++i)
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      const std::string bytes = limn::test::bytesOfFile(entry.path());
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++inputs;
    }
  std::printf("%d inputs did no harm\n", inputs);
  return inputs > 0 ? 0 : 1;
}
