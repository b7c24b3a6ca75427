// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/Places.h"
#include "support/Sanitizers.h"
#include "support/Shell.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>

// The SPDX document of what the program is linked with and made of.
namespace limn {
namespace {

TEST(LinkedPackages, areListedWithVersionAndLicence) {
  if (test::isSanitised)
    GTEST_SKIP() << "a program under a sanitizer is linked with what is never installed";
  for (const char* program : {"dpkg-query", "ninja", "ldd"})
    if (!test::isOnThePath(program))
      GTEST_SKIP() << program << " is not installed";
  if (!std::filesystem::exists(test::buildFolder() / ".ninja_deps"))
    GTEST_SKIP() << "this build was not made by ninja, which knows the headers that were read";
  const test::TemporaryFolder folder;
  const test::Said said =
      test::said(folder.path(), "'" + (test::sourceFolder() / "app/packaging/sbom.sh").string() + "' '" +
                                    test::buildFolder().string() + "' 1.2.3");
  ASSERT_EQ(said.status, 0) << said.text;

  std::map<std::string, std::string> described; // by identifier
  static const std::regex package(
      R"(PackageName: (\S+)\nSPDXID: (\S+)\nPackageVersion: \S+\n(?:[^\n]+\n)*?PackageLicense(?:Comments: <text>Licences in its copyright file: |Declared: GPL)[^\n]+\n)");
  for (std::sregex_iterator match(said.text.begin(), said.text.end(), package), end; match != end; ++match)
    described.emplace((*match)[2], (*match)[1]);
  EXPECT_EQ(described.count("SPDXRef-limn"), 1u);

  std::map<std::string, int> linked, madeOf;
  static const std::regex relation(
      R"(Relationship: (?:SPDXRef-limn DYNAMIC_LINK (\S+)|(\S+) BUILD_DEPENDENCY_OF SPDXRef-limn))");
  for (std::sregex_iterator match(said.text.begin(), said.text.end(), relation), end; match != end; ++match) {
    const std::string id = (*match)[1].matched ? (*match)[1] : (*match)[2];
    EXPECT_TRUE(described.contains(id)) << id;
    ++((*match)[1].matched ? linked : madeOf)[described[id]];
  }
  // Linked by the program, by its module alone, and by one of their libraries alone; then headers alone.
  const auto openImageIo = linked.lower_bound("libopenimageio");
  EXPECT_TRUE(openImageIo != linked.end() && openImageIo->first.starts_with("libopenimageio"));
  for (const char* name : {"libepoxy0", "libc6"})
    EXPECT_EQ(linked[name], 1) << name;
  for (const char* name : {"libglm-dev", "nlohmann-json3-dev", "libcli11-dev"})
    EXPECT_EQ(madeOf[name], 1) << name;
  EXPECT_EQ(described.size(), 1 + linked.size() + madeOf.size());
}

} // namespace
} // namespace limn
