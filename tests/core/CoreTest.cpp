// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/making/ChildProcess.h"
#include "io/ImageFile.h"
#include "scene/basics/Error.h"
#include "support/Places.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

// The core of the program by itself.

namespace limn {
namespace {

struct Ran {
  bool succeeded = false;
  std::string printed;
};

Ran ran(const std::string& program, const std::vector<std::string>& arguments) {
  ChildProcess process(program, arguments, ChildProcess::Errors::among);
  Ran result;
  while (const auto more = process.read(-1))
    result.printed += *more;
  result.succeeded = process.succeeded();
  return result;
}

std::string librariesOf(const std::string& program) {
  const Ran ldd = ran("ldd", {program});
  EXPECT_TRUE(ldd.succeeded) << ldd.printed;
  return ldd.printed;
}

// All of the core and the lab is linked into the program, used or not.
TEST(Core, linksNoQt) {
  EXPECT_EQ(librariesOf(LIMN_CORE_PROGRAM).find("libQt"), std::string::npos);
  EXPECT_NE(librariesOf(LIMN_CORE_PROGRAM).find("libvtkCommonCore"), std::string::npos);
  EXPECT_NE(librariesOf(test::programPath()).find("libQt6Widgets"), std::string::npos);
}

TEST(Core, drawsThePictureThatTheCommandDraws) {
  const test::TemporaryFolder folder;
  const std::string alone = folder.path() / "alone.exr", command = folder.path() / "command.exr";
  const Ran first = ran(LIMN_CORE_PROGRAM, {"phantom:4", alone});
  ASSERT_TRUE(first.succeeded) << first.printed;
  const Ran second = ran(test::programPath(), {"render", "phantom:4", "--engine", "cpu", "-o", command});
  ASSERT_TRUE(second.succeeded) << second.printed;
  const Image picture = readExr(alone);
  EXPECT_EQ(picture.size, glm::ivec2(512, 512));
  EXPECT_EQ(picture.pixels, readExr(command).pixels);
}

TEST(Core, saysInASentenceWhatCannotBeLoaded) {
  const Ran result = ran(LIMN_CORE_PROGRAM, {"/nowhere.nii", "out.png"});
  EXPECT_FALSE(result.succeeded);
  EXPECT_NE(result.printed.find("there is no such file or folder"), std::string::npos) << result.printed;
}

TEST(ChildProcess, answersLineByLineAndSaysWhatItSaidOfErrors) {
  ChildProcess process("sh", {"-c", "read a; echo \"one $a\"; echo two; echo odd >&2; read b; exit 3"},
                       ChildProcess::Errors::apart);
  process.write("word\n");
  EXPECT_EQ(process.readLine(), "one word");
  EXPECT_EQ(process.readLine(), "two");
  EXPECT_EQ(process.read(0), "");
  process.closeInput();
  EXPECT_EQ(process.readLine(), std::nullopt);
  EXPECT_FALSE(process.succeeded()) << "3 is no success";
  EXPECT_EQ(process.errors(), "odd\n");
}

TEST(ChildProcess, thatHasEndedHearsNothing) {
  ChildProcess process("true", {}, ChildProcess::Errors::among);
  EXPECT_TRUE(process.succeeded());
  process.write("nobody reads this"); // and this program goes on
}

TEST(ChildProcess, thatCannotBeStartedIsAnErrorAndOneThatRunsEndsWithItsOwner) {
  EXPECT_THROW(ChildProcess("/no/such/program", {}, ChildProcess::Errors::among), Error);
  EXPECT_EQ(findProgram("no-such-program-anywhere"), "");
  EXPECT_TRUE(findProgram("sh").ends_with("/sh"));
  std::optional<ChildProcess> endless;
  endless.emplace("sh", std::vector<std::string>{"-c", "echo $$; while :; do read x; done"},
                  ChildProcess::Errors::among);
  const std::string id = endless->readLine().value();
  EXPECT_TRUE(std::filesystem::exists("/proc/" + id));
  endless.reset();
  EXPECT_FALSE(std::filesystem::exists("/proc/" + id));
}

} // namespace
} // namespace limn
