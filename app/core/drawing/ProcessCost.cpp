// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/ProcessCost.h"

#include <malloc.h>
#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

namespace limn {
namespace {

// What follows the colon of the first line of a file that starts with `key`.
std::string fieldOf(const char* file, const std::string& key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(key))
      if (const auto colon = line.find(':'); colon != std::string::npos)
        return line.substr(line.find_first_not_of(" \t", colon + 1));
  return {};
}

// /proc counts memory in units of 1024 bytes.
double megabytes(const char* key) {
  double count = 0.0;
  std::istringstream(fieldOf("/proc/self/status", key)) >> count;
  return count * 1024.0 / 1e6;
}

} // namespace

double processorMs() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double residentMb() {
  return megabytes("VmRSS");
}

double peakResidentMb() {
  return megabytes("VmHWM");
}

void forgetPeak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

std::string machineName() {
  std::string name = fieldOf("/proc/cpuinfo", "model name");
  // That of arm64 has but numbers for maker and part.
  if (utsname system{}; name.empty() && uname(&system) == 0)
    name = std::string(system.machine) + " processor";
  return name + ", " + std::to_string(std::thread::hardware_concurrency()) + " processors";
}

} // namespace limn
