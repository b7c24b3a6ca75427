// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/Installed.h"

// The package that CPack makes of the installed tree: what it says, and that it goes as it came.
namespace limn {
namespace {

using test::Said;

class DebianPackage : public test::Installed {
protected:
  // A minute on a busy machine, so that one package serves a whole test.
  void pack() {
    const Said packed = run(
        "cpack -G DEB --config '" + (test::buildFolder() / "CPackConfig.cmake").string() +
        "' -B packed -D CPACK_INSTALL_CMAKE_PROJECTS= -D CPACK_INSTALLED_DIRECTORIES='" + tree().string() +
        ";/' -D CPACK_PACKAGING_INSTALL_PREFIX=/ -D CPACK_STRIP_FILES=OFF && mv packed/limn_*.deb limn.deb");
    ASSERT_EQ(packed.status, 0) << packed.text;
  }

  void expectDependencies() const {
    const std::string needed = run("dpkg-deb -f limn.deb Depends").text;
    // One of each kind: linked by the program, linked by its module, loaded while it runs.
    for (const char* package : {"libqt6widgets6", "libepoxy0", "libopenimageio", "libegl1", "libc6 (>= "})
      EXPECT_NE(needed.find(package), std::string::npos) << package << " is not in " << needed;
    EXPECT_EQ(needed.find("-dev"), std::string::npos) << needed;
  }

  // Into a tree with a database of its own, and out of it.
  void expectNothingLeft(const std::string& asRoot) const {
    ASSERT_EQ(run("mkdir -p root/var/lib/dpkg/info root/var/lib/dpkg/updates && touch "
                  "root/var/lib/dpkg/status")
                  .status,
              0);
    const std::string dpkg =
        asRoot + "dpkg --root='" + file("root").string() + "' --log=/dev/null --force-depends ";
    const Said installed = run(dpkg + "--install limn.deb");
    ASSERT_EQ(installed.status, 0) << installed.text;
    EXPECT_TRUE(std::filesystem::exists(file("root/usr/bin/limn")));
    const Said removed = run(dpkg + "--purge limn");
    ASSERT_EQ(removed.status, 0) << removed.text;
    for (const std::string& path : test::pathsBelow(file("root")))
      EXPECT_TRUE(path == "var" || path.starts_with("var/lib")) << path << " is left";
    EXPECT_EQ(run("cat root/var/lib/dpkg/status").text, "");
  }
};

TEST_F(DebianPackage, holdsWhatIsInstalledNamesWhatItNeedsAndLeavesNothing) {
  for (const char* program : {"cpack", "dpkg-deb", "dpkg-shlibdeps"})
    if (!test::isOnThePath(program))
      GTEST_SKIP() << program << " is not installed";
  const bool hasFakeRoot = test::isOnThePath("fakeroot");
  if (!hasFakeRoot && run("id -u").text != "0\n")
    GTEST_SKIP() << "dpkg needs root, or the package fakeroot";
  ASSERT_NO_FATAL_FAILURE(pack());
  expectDependencies();
  ASSERT_EQ(run("dpkg-deb -x limn.deb unpacked").status, 0);
  EXPECT_EQ(test::pathsBelow(file("unpacked")), test::pathsBelow(tree()));
  // No script runs with root's rights.
  EXPECT_EQ(run("dpkg-deb -I limn.deb postinst >/dev/null 2>&1 || echo none").text, "none\n");
  expectNothingLeft(hasFakeRoot ? "fakeroot " : "");
}

} // namespace
} // namespace limn
