// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/RealFolder.h"

#include <sys/vfs.h>

#include <algorithm>
#include <array>

namespace limn {

bool isPseudoFolder(const std::filesystem::path& folder) {
  // Linux, include/uapi/linux/magic.h: proc, sysfs, debugfs, tracefs, cgroup, cgroup2, securityfs, selinuxfs,
  // bpf, configfs, pstore, efivarfs, binfmt_misc.
  constexpr std::array<unsigned, 13> magics = {0x9fa0,     0x62656572, 0x64626720, 0x74726163, 0x27e0eb,
                                               0x63677270, 0x73636673, 0xf97cff8c, 0xcafe4a11, 0x62656570,
                                               0x6165676c, 0xde5e81e4, 0x42494e4d};
  struct statfs facts {};
  return statfs(folder.c_str(), &facts) == 0 &&
         std::find(magics.begin(), magics.end(), static_cast<unsigned>(facts.f_type)) != magics.end();
}

} // namespace limn
