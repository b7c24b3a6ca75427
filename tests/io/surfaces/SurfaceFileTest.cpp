// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceExport.h"

#include "SampledFields.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <cstring>

// What is written is read back by VTK.

namespace limn {
namespace {

namespace fs = std::filesystem;

SurfaceOrder orderAt(double isovalue) {
  SurfaceOrder order;
  order.isovalue = isovalue;
  return order;
}

class SurfaceFile : public testing::Test {
protected:
  SurfaceFile()
      : scene(test::sampledScene(test::centredGrid(24, 1.5, {100.0, -20.0, 60.0}),
                                 test::ball({100.0, -20.0, 60.0}, 14.0))) {}

  fs::path file(const char* name) const { return folder.path() / name; }

  template <class Reader>
  vtkSmartPointer<vtkPolyData> readBack(const char* name) const {
    vtkNew<Reader> reader;
    reader->SetFileName(file(name).c_str());
    reader->Update();
    return reader->GetOutput();
  }

  // The same corners, one after the other, to the last bit.
  static void expectSame(vtkPolyData& read, const SurfaceMesh& mesh) {
    ASSERT_EQ(read.GetNumberOfPolys(), static_cast<vtkIdType>(mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      vtkNew<vtkIdList> corners;
      read.GetCellPoints(static_cast<vtkIdType>(i), corners);
      ASSERT_EQ(corners->GetNumberOfIds(), 3);
      for (int corner = 0; corner < 3; ++corner) {
        double at[3];
        read.GetPoint(corners->GetId(corner), at);
        const glm::vec3& point = mesh.points[mesh.triangles[i][corner]];
        ASSERT_EQ(glm::vec3(at[0], at[1], at[2]), point) << i;
      }
    }
  }

  static void expectNormals(vtkPolyData& read, const SurfaceMesh& mesh) {
    vtkDataArray* normals = read.GetPointData()->GetNormals();
    ASSERT_TRUE(normals);
    ASSERT_EQ(normals->GetNumberOfTuples(), static_cast<vtkIdType>(mesh.normals.size()));
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
      double normal[3];
      normals->GetTuple(static_cast<vtkIdType>(i), normal);
      ASSERT_NEAR(glm::length(glm::dvec3(normal[0], normal[1], normal[2]) - glm::dvec3(mesh.normals[i])), 0.0,
                  1e-5)
          << i;
    }
  }

  test::TemporaryFolder folder;
  Scene scene;
};

TEST_F(SurfaceFile, ofStlIsReadBackEqualInMillimetres) {
  const auto written = exportSurfaces(scene, {orderAt(0.0)}, file("ball.stl"));
  ASSERT_EQ(written.size(), 1u);
  const auto read = readBack<vtkSTLReader>("ball.stl");
  expectSame(*read, written.front().made.mesh);
  // A ball of 14 mm about (100, -20, 60) mm in the patient; chords of 1.5 mm lie 0.02 mm inside.
  const double* bounds = read->GetBounds();
  EXPECT_NEAR(bounds[0], 86.0, 0.1);
  EXPECT_NEAR(bounds[3], -6.0, 0.1);
  EXPECT_NEAR(bounds[5], 74.0, 0.1);
  // Points that coincide are one for a reader of STL: every edge has two triangles there, too.
  EXPECT_EQ(read->GetNumberOfPoints(), static_cast<vtkIdType>(written.front().made.mesh.points.size()));
  const std::string bytes = test::bytesOfFile(file("ball.stl"));
  EXPECT_EQ(bytes.substr(0, 38), "Limn surface at 0, mm, axes LPS, withi");
  EXPECT_EQ(bytes.size(), 84 + 50 * written.front().made.mesh.triangles.size());
}

TEST_F(SurfaceFile, ofPlyIsReadBackEqualWithItsNormals) {
  const auto written = exportSurfaces(scene, {orderAt(0.0)}, file("ball.ply"));
  const auto read = readBack<vtkPLYReader>("ball.ply");
  expectSame(*read, written.front().made.mesh);
  expectNormals(*read, written.front().made.mesh);
  EXPECT_NE(test::bytesOfFile(file("ball.ply")).find("comment Limn surface at 0, mm, axes LPS"),
            std::string::npos);
}

TEST_F(SurfaceFile, ofObjIsReadBackEqualWithItsNormals) {
  const auto written = exportSurfaces(scene, {orderAt(0.0)}, file("ball.obj"));
  const auto read = readBack<vtkOBJReader>("ball.obj");
  expectSame(*read, written.front().made.mesh);
  expectNormals(*read, written.front().made.mesh);
}

TEST_F(SurfaceFile, ofObjHoldsSeveralSurfacesAsObjects) {
  const auto written = exportSurfaces(scene, {orderAt(0.0), orderAt(5.5)}, file("balls.obj"));
  ASSERT_EQ(written.size(), 2u);
  EXPECT_EQ(written[1].file, file("balls.obj"));
  EXPECT_EQ(test::entriesOf(folder.path()), 1u);
  const std::string text = test::bytesOfFile(file("balls.obj"));
  EXPECT_NE(text.find("\no value_0\n"), std::string::npos);
  EXPECT_NE(text.find("\no value_5.5\n"), std::string::npos);
  const auto read = readBack<vtkOBJReader>("balls.obj");
  SurfaceMesh both = written[0].made.mesh;
  const auto before = static_cast<std::uint32_t>(both.points.size());
  const SurfaceMesh& second = written[1].made.mesh;
  both.points.insert(both.points.end(), second.points.begin(), second.points.end());
  for (const glm::uvec3& triangle : second.triangles)
    both.triangles.push_back(triangle + before);
  expectSame(*read, both);
}

TEST_F(SurfaceFile, ofStlAndPlyIsOneForEachValue) {
  exportSurfaces(scene, {orderAt(-2.5), orderAt(3.0)}, file("ball.stl"));
  EXPECT_EQ(test::entriesOf(folder.path()), 2u);
  EXPECT_TRUE(fs::exists(file("ball_-2.5.stl")));
  EXPECT_TRUE(fs::exists(file("ball_3.stl")));
}

TEST_F(SurfaceFile, isWrittenWithAllOthersOrNotAtAll) {
  test::writeBytes(file("ball_3.stl"), "old");
  EXPECT_THROW(exportSurfaces(scene, {orderAt(3.0), orderAt(1000.0)}, file("ball.stl")), Error);
  fs::create_directory(file("ball_5.stl"));
  EXPECT_THROW(exportSurfaces(scene, {orderAt(3.0), orderAt(5.0)}, file("ball.stl")), Error)
      << "a folder is there";
  EXPECT_EQ(test::bytesOfFile(file("ball_3.stl")), "old");
  EXPECT_EQ(test::entriesOf(folder.path()), 2u);
}

TEST_F(SurfaceFile, isNotTouchedWhereItIsCancelledWhileItIsWritten) {
  // Large enough to be written in pieces.
  scene = test::sampledScene(test::centredGrid(96, 0.5), test::ball(glm::dvec3(0.0), 22.0));
  test::writeBytes(file("ball.obj"), "old");
  bool isWriting = false;
  Progress progress;
  progress.report = [&](double, const Message& what) { isWriting = what.english() == "Writing the surface"; };
  progress.isCancelled = [&] { return isWriting; };
  EXPECT_THROW(exportSurfaces(scene, {orderAt(0.0)}, file("ball.obj"), progress), Cancelled);
  EXPECT_TRUE(isWriting);
  EXPECT_EQ(test::bytesOfFile(file("ball.obj")), "old");
  EXPECT_EQ(test::entriesOf(folder.path()), 1u);
}

Error::Kind kindOfRefusal(const Scene& scene, const std::vector<SurfaceOrder>& orders, const fs::path& path) {
  try {
    exportSurfaces(scene, orders, path);
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "nothing was refused";
  return Error::Kind::other;
}

TEST_F(SurfaceFile, isRefusedForWrongUsage) {
  EXPECT_EQ(kindOfRefusal(scene, {orderAt(0.0)}, file("ball.3mf")), Error::Kind::usage);
  EXPECT_EQ(kindOfRefusal(scene, {orderAt(1.0), orderAt(1.0)}, file("ball.stl")), Error::Kind::usage);
  EXPECT_EQ(kindOfRefusal(scene, {orderAt(0.0)}, file("no folder/ball.stl")), Error::Kind::other);
  EXPECT_EQ(test::entriesOf(folder.path()), 0u);
}

} // namespace
} // namespace limn
