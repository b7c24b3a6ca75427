// SPDX-License-Identifier: GPL-3.0-or-later
#include "VolumeFuzz.h"

#include "io/formats/invesalius/InVesaliusProject.h"

#include <cstring>

namespace {

// An entry of a tar archive (POSIX ustar): its header, its bytes, and zeros up to the next block.
std::string tarEntry(const std::string& name, std::string_view bytes) {
  std::string entry(512, '\0');
  entry.replace(0, name.size(), name);
  char digits[13];
  std::snprintf(digits, sizeof digits, "%011o", static_cast<unsigned>(bytes.size()));
  entry.replace(124, 11, digits);
  entry[156] = '0';
  entry.replace(257, 8, "ustar\00000", 8);
  entry.replace(148, 8, 8, ' ');
  unsigned sum = 0;
  for (const char c : entry)
    sum += static_cast<unsigned char>(c);
  std::snprintf(digits, sizeof digits, "%06o", sum);
  entry.replace(148, 6, digits);
  entry[154] = '\0';
  return entry.append(bytes).append((512 - bytes.size() % 512) % 512, '\0');
}

} // namespace

// The list of an InVesalius project, beside a matrix of 48 bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  const std::string archive = tarEntry("main.plist", test::textOf(data, size)) +
                              tarEntry("matrix.dat", std::string(48, '\1')) + std::string(1024, '\0');
  test::readWhole(archive, readInVesalius);
  return 0;
}
