// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/privacy/Marks.h"
#include "support/FileBytes.h"
#include "support/Places.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <elf.h>
#include <sys/wait.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>

// The program talks to nobody: its code names no function of the network and no library for it, and while it
// works, the kernel sees no socket but those to the display on this machine.

namespace limn {
namespace {

namespace fs = std::filesystem;

/// What an executable takes from libraries: functions by name, and the libraries that it names itself.
struct Needs {
  std::set<std::string> functions;
  std::set<std::string> libraries;
};

template <class T>
T readAt(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// Reads the dynamic section of a 64-bit ELF file (System V ABI, chapters 4 and 5).
Needs needsOf(const fs::path& executable) {
  const std::string bytes = test::bytesOfFile(executable);
  const auto header = readAt<Elf64_Ehdr>(bytes, 0);
  const auto section = [&](std::size_t i) {
    return readAt<Elf64_Shdr>(bytes, header.e_shoff + i * header.e_shentsize);
  };
  const auto textAt = [&](const Elf64_Shdr& strings, std::size_t offset) {
    return std::string(bytes.c_str() + strings.sh_offset + offset);
  };
  Needs needs;
  for (std::size_t i = 0; i < header.e_shnum; ++i) {
    const Elf64_Shdr here = section(i);
    for (std::size_t at = here.sh_offset; at < here.sh_offset + here.sh_size && here.sh_entsize > 0;
         at += here.sh_entsize) {
      if (here.sh_type == SHT_DYNSYM) {
        const auto symbol = readAt<Elf64_Sym>(bytes, at);
        if (symbol.st_shndx == SHN_UNDEF)
          needs.functions.insert(textAt(section(here.sh_link), symbol.st_name));
      } else if (here.sh_type == SHT_DYNAMIC) {
        const auto entry = readAt<Elf64_Dyn>(bytes, at);
        if (entry.d_tag == DT_NEEDED)
          needs.libraries.insert(textAt(section(here.sh_link), entry.d_un.d_val));
      }
    }
  }
  return needs;
}

std::set<std::string> networkFunctionsOf(const Needs& needs) {
  std::set<std::string> found;
  for (const char* name :
       {"socket", "connect", "bind", "listen", "accept", "accept4", "send", "sendto", "sendmsg", "recv",
        "recvfrom", "recvmsg", "getaddrinfo", "gethostbyname", "gethostbyname_r", "res_query"})
    if (needs.functions.contains(name))
      found.insert(name);
  return found;
}

TEST(Network, theProgramNamesNoFunctionOfIt) {
  const Needs needs = needsOf(test::programPath());
  ASSERT_TRUE(needs.functions.contains("fsync")) << "the symbols were not read";
  EXPECT_EQ(networkFunctionsOf(needs), std::set<std::string>());
}

TEST(Network, whatTheProgramLoadsLateNamesNoFunctionOfIt) {
  const Needs needs = needsOf((test::buildFolder() / "lib/liblimn_picture_files.so").string());
  ASSERT_FALSE(needs.libraries.empty()) << "the libraries were not read";
  EXPECT_EQ(networkFunctionsOf(needs), std::set<std::string>());
}

TEST(Network, theProgramNamesNoLibraryForIt) {
  const Needs needs = needsOf(test::programPath());
  ASSERT_TRUE(needs.libraries.contains("libQt6Core.so.6")) << "the libraries were not read";
  for (const std::string& library : needs.libraries)
    for (const char* kind :
         {"Network", "curl", "WebSockets", "WebEngine", "soup", "neon", "ssl", "dcmnet", "dcmtls"})
      EXPECT_EQ(library.find(kind), std::string::npos) << library;
}

class Traced : public testing::Test {
protected:
  void SetUp() override {
    if (std::system("strace -o /dev/null true >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "strace is not here or may not trace";
  }

  // The system calls (leaks cannot be looked for under a tracer) that made sockets of the Internet while a
  // command ran.
  std::string internetSockets(const std::string& command) {
    const std::string log = (folder.path() / "log").string();
    // Where there is no session bus the window must not launch one: it would stay, and strace wait for its
    // end.
    const std::string traced =
        "env HOME='" + folder.path().string() +
        "' DBUS_SESSION_BUS_ADDRESS=\"${DBUS_SESSION_BUS_ADDRESS:-unix:path=/nonexistent}\""
        " XDG_CONFIG_HOME= XDG_DATA_HOME= ASAN_OPTIONS=detect_leaks=0 strace -f -qq -e "
        "trace=network -o '" +
        log + "' " + command + " >/dev/null 2>&1 </dev/null";
    const int status = std::system(traced.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command;
    std::string found;
    std::istringstream lines(test::bytesOfFile(log));
    for (std::string line; std::getline(lines, line);)
      if (line.find("AF_INET") != std::string::npos)
        found += line + "\n";
    return found;
  }

  test::TemporaryFolder folder;
};

// The control: a connection that is there is seen.
TEST_F(Traced, aConnectionIsSeen) {
  EXPECT_NE(internetSockets("bash -c 'exec 3<>/dev/udp/127.0.0.1/9'"), "");
}

TEST_F(Traced, noCommandMakesOne) {
  const std::string program = "'" + test::programPath() + "' ";
  const std::string out = std::string("'").append(folder.path() / "a.png").append("'");
  EXPECT_EQ(internetSockets(program + "info phantom:8"), "");
  EXPECT_EQ(internetSockets(program + "info --system"), "");
  EXPECT_EQ(internetSockets(program + "render phantom:8 --size 32x32 -o " + out), "");
  EXPECT_EQ(internetSockets(program + "effects phantom:8 --size 32x32"), "");
  test::writeMarkedSeries(folder.path() / "series");
  const std::string at = folder.path().string();
  EXPECT_EQ(internetSockets(program + "dicom " + at + "/series --size 32x32 -o " + at + "/objects"), "");
  EXPECT_EQ(
      internetSockets(program + "render " + at + "/objects/look.dcm --volume " + at + "/series -o " + out),
      "");
}

TEST_F(Traced, theWindowMakesNone) {
  const std::string out = std::string("'").append(folder.path() / "a.png").append("'");
  EXPECT_EQ(internetSockets("'" + test::programPath() + "' phantom:8 --screenshot " + out), "");
  EXPECT_TRUE(fs::exists(folder.path() / "a.png"));
}

} // namespace
} // namespace limn
