// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/Installed.h"

#include <regex>

// What menus, software centres and file managers are told, checked by their own tools.
namespace limn {
namespace {

using SystemEntries = test::Installed;
using test::Said;

#define SKIP_WITHOUT(program)                                                                                \
  if (!test::isOnThePath(program))                                                                           \
  GTEST_SKIP() << program << " is not installed"

std::set<std::string> matchesIn(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

TEST_F(SystemEntries, theMenuEntryIsValid) {
  SKIP_WITHOUT("desktop-file-validate");
  const Said outcome =
      run("desktop-file-validate '" + share("applications/org.limn.Limn.desktop").string() + "'");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.text, "");
}

TEST_F(SystemEntries, theMetadataIsValidWithAndWithoutAnAddress) {
  SKIP_WITHOUT("appstreamcli");
  const std::string installed = share("metainfo/org.limn.Limn.metainfo.xml").string();
  const Said outcome = run("appstreamcli validate --no-net --strict '" + installed + "'");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  // Its script alone, with an address as packagers give it.
  std::ofstream(file("with.cmake")) << "set(PROJECT_VERSION 0.1.0)\nset(LIMN_DATE 2026-01-31)\n"
                                       "set(LIMN_HOMEPAGE https://example.org/limn)\n"
                                       "set(CMAKE_SOURCE_DIR "
                                    << test::sourceFolder() << ")\nset(CMAKE_CURRENT_SOURCE_DIR "
                                    << test::sourceFolder() / "app/packaging"
                                    << ")\ninclude(" << test::sourceFolder() / "app/packaging/Metainfo.cmake"
                                    << ")\n"
                                    << "limn_metainfo(" << file("org.limn.Limn.metainfo.xml") << ")\n";
  const Said made =
      run("cmake -P with.cmake && appstreamcli validate --no-net --strict org.limn.Limn.metainfo.xml");
  EXPECT_EQ(made.status, 0) << made.text;
  EXPECT_NE(test::bytesOfFile(file("org.limn.Limn.metainfo.xml")).find("/app/guide/window.png</image>"),
            std::string::npos);
  for (const char* picture : {"window.png", "slices.png"})
    EXPECT_TRUE(std::filesystem::exists(test::sourceFolder() / "app/guide" / picture)) << picture;
}

TEST_F(SystemEntries, nameTheSameTypes) {
  const std::string desktop = test::bytesOfFile(share("applications/org.limn.Limn.desktop"));
  const std::string metadata = test::bytesOfFile(share("metainfo/org.limn.Limn.metainfo.xml"));
  const std::string types = test::bytesOfFile(share("mime/packages/org.limn.Limn.xml"));
  std::set<std::string> declared = matchesIn(types, "<mime-type type=\"([^\"]+)\"");
  EXPECT_GE(declared.size(), 9u);
  declared.insert("application/dicom"); // which systems know
  EXPECT_EQ(matchesIn(matchesIn(desktop, "MimeType=(.*)").begin()->c_str(), "([^;]+);"), declared);
  EXPECT_EQ(matchesIn(metadata, "<mediatype>([^<]+)<"), declared);
}

// What a file manager takes files for.
TEST_F(SystemEntries, filesAreToldByTheirTypes) {
  SKIP_WITHOUT("update-mime-database");
  SKIP_WITHOUT("gio");
  const Said updated = run("update-mime-database '" + share("mime").string() + "'");
  ASSERT_EQ(updated.status, 0) << updated.text;
  const auto typeOf = [&](const std::string& name) {
    const Said told = run("XDG_DATA_HOME='" + (tree() / "usr/share").string() +
                          "' gio info -a standard::content-type '" + file(name).string() + "'");
    const std::set<std::string> type = matchesIn(told.text, "standard::content-type: (\\S+)");
    return type.empty() ? told.text : *type.begin();
  };
  const std::string program = "'" + (tree() / "usr/bin/limn").string() + "'";
  ASSERT_EQ(run(program + " render phantom:16 --size 8x8 --engine cpu --quiet -o a.png").status, 0);
  test::writeBytes(file("a.nii"), std::string(344, '\0') + std::string("n+1\0", 4) + std::string(100, '\1'));
  test::writeBytes(file("a.nii.gz"), "\x1f\x8b\x08");
  test::writeBytes(file("a.nrrd"), "NRRD0005\n");
  test::writeBytes(file("a.mha"), "ObjectType = Image\n");
  test::writeBytes(file("a.vti"), "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\"/>\n");
  test::writeBytes(file("a.vtk"), "# vtk DataFile Version 3.0\n");
  test::writeBytes(file("scene.limn.json"), "{\n  \"limn_scene\": 1\n}\n");
  test::writeBytes(file("session.limn.json"),
                   "{\n  \"limn_session\": 1,\n  \"scene\": {\n    \"limn_scene\": 1\n  }\n}\n");
  EXPECT_EQ(typeOf("a.nii"), "application/x-nifti");
  EXPECT_EQ(typeOf("a.nii.gz"), "application/x-nifti-compressed");
  EXPECT_EQ(typeOf("a.nrrd"), "application/x-nrrd");
  EXPECT_EQ(typeOf("a.mha"), "application/x-metaimage");
  EXPECT_EQ(typeOf("a.vti"), "application/x-vtk-image-data");
  EXPECT_EQ(typeOf("a.vtk"), "application/x-vtk");
  EXPECT_EQ(typeOf("scene.limn.json"), "application/x-limn-scene");
  EXPECT_EQ(typeOf("session.limn.json"), "application/x-limn-session");
  EXPECT_EQ(typeOf("a.png"), "image/png");
}

} // namespace
} // namespace limn
