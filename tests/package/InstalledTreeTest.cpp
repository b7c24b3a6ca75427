// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/Installed.h"

// The installed program, run from a tree that was moved after it was installed.
namespace limn {
namespace {

using InstalledTree = test::Installed;
using test::Said;

constexpr const char* drawTheSample = " render sample --size 64x64 --engine cpu --quiet -o '";

TEST_F(InstalledTree, worksFromWhereItIsMovedTo) {
  std::filesystem::rename(tree(), file("moved"));
  const std::string program = "cd / && '" + file("moved/usr/bin/limn").string() + "'";
  const Said version = run(program + " --version");
  EXPECT_EQ(version.status, 0) << version.text;
  EXPECT_EQ(version.text, run("'" + test::programPath() + "' --version").text);
  const Said drawn = run(program + drawTheSample + file("sample.png").string() + "'");
  EXPECT_EQ(drawn.status, 0) << drawn.text;
  EXPECT_EQ(test::bytesOfFile(file("sample.png")).substr(1, 3), "PNG");
  // It takes its own part for pictures other than PNG: without that there is none, though the build folder
  // has one.
  std::filesystem::remove_all(file("moved/usr/lib/limn"));
  const Said refused = run(program + drawTheSample + file("other.tif").string() + "'");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.text.find("install Limn again"), std::string::npos) << refused.text;
}

TEST_F(InstalledTree, namesNoFolderInWhichItWasMade) {
  const std::set<std::string> paths = test::pathsBelow(tree());
  ASSERT_TRUE(paths.contains("usr/bin/limn"));
  for (const std::string& path : paths) {
    if (!std::filesystem::is_regular_file(tree() / path))
      continue;
    const std::string bytes = test::bytesOfFile(tree() / path);
    EXPECT_FALSE(bytes.empty()) << path;
    for (const std::filesystem::path& folder : {test::buildFolder(), test::sourceFolder(), tree()})
      EXPECT_EQ(bytes.find(folder.string()), std::string::npos) << path << " names " << folder;
  }
}

// Qt's compiler of resources writes down when each file was checked out, but for its first format.
TEST(Resources, carryNoTimesOfFiles) {
  std::size_t compiled = 0;
  for (const char* folder : {"app", "widgets"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::buildFolder() / folder)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with("qrc_") || entry.path().extension() != ".cpp")
        continue;
      EXPECT_NE(test::bytesOfFile(entry.path()).find("int version = 1;"), std::string::npos) << entry.path();
      ++compiled;
    }
  EXPECT_GE(compiled, 3u); // presets, icons and words
}

TEST_F(InstalledTree, holdsWhatSystemsLookForAndNothingUnexpected) {
  std::set<std::string> files;
  for (const std::string& path : test::pathsBelow(tree()))
    if (std::filesystem::is_regular_file(tree() / path))
      files.insert(path);
  for (const char* path :
       {"usr/bin/limn", "usr/lib/limn/modules/liblimn_picture_files.so",
        "usr/share/applications/org.limn.Limn.desktop",
        "usr/share/icons/hicolor/scalable/apps/org.limn.Limn.svg", "usr/share/man/man1/limn.1.gz",
        "usr/share/metainfo/org.limn.Limn.metainfo.xml", "usr/share/mime/packages/org.limn.Limn.xml",
        "usr/share/bash-completion/completions/limn", "usr/share/fish/vendor_completions.d/limn.fish",
        "usr/share/zsh/site-functions/_limn"})
    EXPECT_EQ(files.erase(path), 1u) << path;
  EXPECT_EQ(files.erase("usr/bin/limn-mpi"), LIMN_MPI) << "installed where it is built, and only there";
  for (const std::string& path : files)
    EXPECT_TRUE(path.starts_with("usr/share/doc/limn/")) << path << " is installed without being expected";
  // Thumbnails of patients are kept by file managers: nobody gets them without having switched them on.
  EXPECT_FALSE(std::filesystem::exists(share("thumbnailers")));
}

TEST_F(InstalledTree, itsThumbnailerExampleDrawsAThumbnail) {
  std::string line =
      run("sed -n 's/^Exec=//p' '" + share("doc/limn/examples/limn.thumbnailer").string() + "'").text;
  const auto put = [&line](const std::string& place, const std::string& what) {
    for (std::size_t at = line.find(place); at != std::string::npos; at = line.find(place, at + what.size()))
      line.replace(at, place.size(), what);
  };
  put("%i", "phantom:16");
  put("%s", "48");
  put("%o", "'" + file("thumbnail.png").string() + "'");
  const Said drawn = run("PATH='" + (tree() / "usr/bin").string() + "':$PATH; " + line);
  EXPECT_EQ(drawn.status, 0) << drawn.text;
  EXPECT_EQ(test::bytesOfFile(file("thumbnail.png")).substr(1, 3), "PNG");
}

} // namespace
} // namespace limn
