// SPDX-License-Identifier: GPL-3.0-or-later
#include "Includes.h"

#include <gtest/gtest.h>

// Who may include whom (ARCHITECTURE.md). Link lines enforce most of it; includes that need no linking are
// caught here.
namespace limn {
namespace {

namespace fs = std::filesystem;

const fs::path& root = test::sourceRoot;

// Fails for every include below `folder`, but for those below `except`, whose header matches the pattern.
void expectNoIncludes(const fs::path& folder, const std::string& pattern, const std::string& why,
                      const std::string& except = "nothing") {
  const std::vector<test::Include> includes = test::includesBelow(folder);
  ASSERT_FALSE(includes.empty()) << folder << " holds no includes: is the folder still there?";
  const std::regex forbidden(pattern);
  for (const test::Include& include : includes) {
    if (include.file.string().starts_with(except + "/"))
      continue;
    EXPECT_FALSE(std::regex_search(include.header, forbidden))
        << include.file << " includes " << include.header << ": " << why;
  }
}

TEST(Layering, rendererContainsNoQt) {
  expectNoIncludes("renderer", "^(Q[A-Z]|Qt)", "the renderer works without Qt");
}

TEST(Layering, sceneUsesOnlyTheStandardLibraryAndGlm) {
  expectNoIncludes(
      "renderer/scene",
      R"(^(io|gl|raycaster|slices|reference|accuracy|widgets|app)/|epoxy|vtk|itk|json|OpenImageIO)",
      "the scene is plain values");
}

TEST(Layering, regionsAreFoundFromTheSceneAlone) {
  expectNoIncludes("renderer/regions",
                   R"(^(io|gl|glsl|raycaster|slices|cpu|reference|accuracy|stability|widgets|app)/|vtk|itk)",
                   "a body is found from voxels");
}

TEST(Layering, slicesOfThePatientAreReadFromTheSceneAlone) {
  expectNoIncludes("renderer/planes",
                   R"(^(io|gl|glsl|raycaster|slices|cpu|reference|accuracy|stability|widgets|app)/|vtk|itk)",
                   "they are no picture of the scene, and nothing draws them but widgets");
}

TEST(Layering, referenceAndGlKnowOnlyTheScene) {
  expectNoIncludes("renderer/reference", "^(io|gl|raycaster|slices|widgets|app)/",
                   "the reference checks the others");
  expectNoIncludes("renderer/gl", "^(io|raycaster|slices|reference|widgets|app)/",
                   "gl knows nothing of volumes");
  expectNoIncludes("renderer/glsl", "^(io|reference|accuracy|raycaster|slices|stability|widgets|app)/",
                   "what renderers in GLSL share knows none of them");
  expectNoIncludes("renderer/raycaster", "^(io|slices|reference|widgets|app)/",
                   "the ray caster draws from the scene alone");
}

TEST(Layering, theCpuEngineDrawsFromTheSceneAlone) {
  expectNoIncludes("renderer/cpu",
                   "^(io|gl|glsl|raycaster|slices|reference|accuracy|stability|widgets|app)/|epoxy",
                   "the CPU engine needs no OpenGL and no other renderer");
}

TEST(Layering, slicesShareTheRayCastersTexturesAndBlocksAndKnowNothingElse) {
  expectNoIncludes("renderer/slices", "^(io|reference|accuracy|raycaster|widgets|app)/",
                   "slices draw from the scene alone");
}

TEST(Layering, accuracyTakesRenderersAsFunctions) {
  expectNoIncludes("renderer/accuracy", "^(io|gl|raycaster|slices|reference|widgets|app)/",
                   "a sweep measures any renderer");
}

TEST(Layering, stabilityDrawsWithEveryRendererAndReadsNoFiles) {
  expectNoIncludes("renderer/stability", "^(io|accuracy|widgets|app)/", "hard cases are scenes, not files");
  for (const char* folder :
       {"renderer/raycaster", "renderer/slices", "renderer/cpu", "renderer/reference", "renderer/gl"})
    expectNoIncludes(folder, "^stability/", "renderers do not know their examiner");
}

TEST(Layering, onlyIoTalksToFileLibraries) {
  for (const char* folder : {"renderer", "widgets", "app"})
    expectNoIncludes(
        folder, "^(vtk|itk|gdcm|dcmtk|OpenImageIO|nlohmann|json|pugixml|archive|tiff|zlib|QJson|QXml|QDom)",
        "files, JSON and XML are read and written in renderer/io", "renderer/io");
}

TEST(Layering, theWindowNeedsNoLaboratory) {
  for (const test::Include& include : test::includesBelow("app")) {
    if (include.file.string().starts_with("app/measure/") ||
        include.file.string().starts_with("app/commands/"))
      continue;
    EXPECT_FALSE(include.header.starts_with("app/measure/") || include.header.starts_with("stability/"))
        << include.file << " includes " << include.header << ": reports belong to the command line";
  }
}

TEST(Layering, widgetsIncludeNeitherIoNorApp) {
  expectNoIncludes("widgets", "^(io|app)/", "widgets show values and ask for edits");
}

TEST(Layering, readersShareWhatStandsBelowThemAndKnowNoOtherReader) {
  expectNoIncludes("renderer/io/reading", "^io/(?!reading/)", "what readers share stands below them");
  expectNoIncludes("renderer/io/dicom", "^io/(?!(reading|dicom)/)", "DICOM is read by itself");
  for (const auto& room : fs::directory_iterator(root / "renderer/io/formats"))
    if (room.is_directory())
      expectNoIncludes(fs::relative(room.path(), root),
                       "^io/(?!reading/|openimageio/|formats/(voxels|" + room.path().filename().string() +
                           ")/)",
                       "a format is read by itself");
}

TEST(Layering, ioIncludesNeitherRenderersNorWidgets) {
  expectNoIncludes("renderer/io", "^(gl|raycaster|slices|reference|widgets|app)/", "readers make values");
}

TEST(Layering, anEngineIsAnInterfaceOverScenes) {
  expectNoIncludes("renderer/engine",
                   "^(io|gl|raycaster|slices|reference|accuracy|stability|widgets|app)/|epoxy",
                   "whoever asks an engine need not know which it is");
}

TEST(Layering, theViewAsksEnginesAndKnowsNone) {
  expectNoIncludes("widgets", "^(raycaster|slices|reference|stability)/|^glsl/(?!PicturePresenter.h)",
                   "the program chooses what draws");
  expectNoIncludes("widgets/view/pictures", "^Q(Widget|OpenGLWidget|Application)|^widgets/view/(?!pictures/)",
                   "pictures are drawn without a window");
}

TEST(Sources, carryTheirLicence) {
  for (const char* folder : {"renderer", "widgets", "app", "tests", "shaders"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp" && extension != ".glsl")
        continue;
      std::ifstream file(entry.path());
      std::string first;
      std::getline(file, first);
      EXPECT_NE(first.find("SPDX-License-Identifier: GPL-3.0-or-later"), std::string::npos) << entry.path();
    }
}

} // namespace
} // namespace limn
