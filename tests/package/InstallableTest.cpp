// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/Places.h"
#include "support/Shell.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

// What has to be built before the program can be installed.
namespace limn {
namespace {

// The files of the build folder that `cmake --install` cannot do without, relative to it.
std::set<std::string> installedFromTheBuild() {
  std::set<std::string> files;
  static const std::regex command(R"(file\(INSTALL [^)]*\))"), quoted("\"([^\"]*)\"");
  for (const char* folder : {"app", "renderer"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::buildFolder() / folder)) {
      if (entry.path().filename() != "cmake_install.cmake")
        continue;
      const std::string script = test::bytesOfFile(entry.path());
      for (std::sregex_iterator match(script.begin(), script.end(), command), end; match != end; ++match)
        if (const std::string text = match->str(); text.find(" OPTIONAL ") == std::string::npos)
          for (std::sregex_iterator file(text.begin(), text.end(), quoted); file != end; ++file)
            if (std::string path = (*file)[1]; path.starts_with(test::buildFolder().string() + "/"))
              files.insert(path.substr(test::buildFolder().string().size() + 1));
    }
  return files;
}

TEST(Install, asksForNothingThatTheTargetOfTheProgramDoesNotMake) {
  if (!test::isOnThePath("ninja") || !std::filesystem::exists(test::buildFolder() / ".ninja_deps"))
    GTEST_SKIP() << "this build was not made by ninja, which knows what is made of what";
  const test::TemporaryFolder folder;
  const std::string ninja = "ninja -C '" + test::buildFolder().string() + "' -t ";
  const std::string made = test::said(folder.path(), ninja + "targets all").text;
  const std::string commands = test::said(folder.path(), ninja + "commands limn").text;
  int looked = 0;
  for (const std::string& file : installedFromTheBuild())
    if (made.find("\n" + file + ": ") != std::string::npos) { // the rest is made by configuring
      EXPECT_NE(commands.find(file), std::string::npos) << file << " is not made with the program";
      ++looked;
    }
  EXPECT_GE(looked, 7) << "program, module, manual page, three completions, change log";
}

} // namespace
} // namespace limn
