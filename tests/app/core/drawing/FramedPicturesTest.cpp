// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/PictureMaker.h"
#include "app/core/sources/SceneSource.h"
#include "scene/framing/Framing.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

// How large what is visible stands in pictures, and where, measured on the voxels and on what is drawn.

namespace limn {
namespace {

// A volume by its name in the test; real ones lie below the shared folder.
struct Patient {
  const char* name;
  const char* source;
  bool isShared;
  // Of vessels and twigs a picture shows less than their voxels, of thick slices half of one beyond the
  // outermost centres; here neither matters.
  bool isSolid;
};

const Patient patients[] = {
    {"phantom", "phantom:3", false, false},
    {"ctHead", "data/ct_head_cranium/ct_head_cranium.nii.gz", true, true},
    {"tiltedCt", "data/ct_head_phantom_tilt_dicom", true, true},
    {"thorax", "data/ct_thorax_contrast/lidc2_uint8.vti", true, true},
    {"cta", "data/cta_brain_avm/cta_brain_avm_uint8.nii.gz", true, false},
    {"mrT1", "data/mr_t1_head/mr_t1_head.nii.gz", true, true},
    {"mrPd", "data/mr_pd_head_dicom", true, true},
    {"mrBrain", "data/mr_brain_nrrd/brain1_image.nrrd", true, false},
    {"bonsai", "data/classic/bonsai.nii.gz", true, false},
    {"engine", "data/classic/engine.nii.gz", true, true},
    {"tooth", "data/classic/tooth/tooth.nhdr", true, true},
};

std::string nameOfPatient(const testing::TestParamInfo<Patient>& patient) {
  return patient.param.name;
}

// The centres of the visible voxels, one after the other.
std::vector<glm::dvec3> visibleCentres(const Scene& scene) {
  std::vector<glm::dvec3> centres;
  const Volume& volume = *scene.volume;
  const glm::ivec3 dims = volume.grid().dims;
  visitVoxels(volume, [&](const auto& stored) {
    for (int k = 0; k < dims.z; ++k)
      for (int j = 0; j < dims.y; ++j)
        for (int i = 0; i < dims.x; ++i) {
          const double scalar =
              volume.rescale().slope * static_cast<double>(stored[voxelOffset(dims, i, j, k)]) +
              volume.rescale().intercept;
          if (classify(scene.transferFunction, scalar).opacity >= 0.02)
            centres.push_back(indexToWorld(volume.grid(), {i, j, k}));
        }
  });
  return centres;
}

// Places drawn at random at which the field between voxels is visible, which is what a picture shows: a voxel
// whose neighbours are clear fills less than its own room there, one among others all of it.
std::vector<glm::dvec3> visiblePlaces(const Scene& scene) {
  constexpr std::size_t wanted = 1'000'000; // 500 of them beyond each end
  const Grid& grid = scene.volume->grid();
  std::mt19937_64 random(88);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<glm::dvec3> places;
  while (places.size() < wanted) {
    const glm::dvec3 at(share(random), share(random), share(random));
    const glm::dvec3 index = at * glm::dvec3(grid.dims) - 0.5;
    if (classify(scene.transferFunction, valueAt(*scene.volume, index)).opacity >= visibleOpacity)
      places.push_back(indexToWorld(grid, index));
  }
  return places;
}

// Where something begins and ends along one side of a picture, -1..1.
struct Extent {
  double from;
  double to;
};

Extent extentOf(std::vector<double> places) {
  const auto left = static_cast<std::ptrdiff_t>(0.0005 * static_cast<double>(places.size()));
  std::nth_element(places.begin(), places.begin() + left, places.end());
  const double from = places[static_cast<std::size_t>(left)];
  std::nth_element(places.begin(), places.end() - 1 - left, places.end());
  return {from, *(places.end() - 1 - left)};
}

// Of the places across and up at which a camera sees voxels.
std::array<Extent, 2> extentsOf(const std::vector<glm::dvec3>& centres, const Camera& camera, double aspect) {
  const CameraBasis basis = basisOf(camera);
  std::array<std::vector<double>, 2> places;
  for (const glm::dvec3& centre : centres) {
    const glm::dvec3 seen = centre - camera.position;
    const double unit = halfHeight(camera) * glm::dot(seen, basis.forward);
    places[0].push_back(glm::dot(seen, basis.right) / unit / aspect);
    places[1].push_back(glm::dot(seen, basis.up) / unit);
  }
  return {extentOf(std::move(places[0])), extentOf(std::move(places[1]))};
}

// The same voxels are visible, all alike and so faint that a picture tells how many lie behind each pixel.
TransferFunction faint(const TransferFunction& function) {
  TransferFunction result = function;
  result.points.clear();
  const auto add = [&](double value, bool isVisible) {
    result.points.push_back({value, glm::dvec3(1.0), isVisible ? visibleOpacity : 0.0});
  };
  const ControlPoint* before = nullptr;
  for (const ControlPoint& point : function.points) {
    const bool isVisible = point.opacity >= visibleOpacity;
    if (before && isVisible != (before->opacity >= visibleOpacity)) {
      const double crossing = before->value + (point.value - before->value) *
                                                  (visibleOpacity - before->opacity) /
                                                  (point.opacity - before->opacity);
      add(crossing, !isVisible);
      add(crossing, isVisible);
    }
    add(point.value, isVisible);
    before = &point;
  }
  return result;
}

constexpr double speck = 0.0005; // of all, on each side, does not count (DEFINITION section 8)

// Of what lies in columns or rows of a picture, one after the other, without a share at each end.
Extent extentOfSums(const std::vector<double>& sums, double without) {
  const double left = without * std::accumulate(sums.begin(), sums.end(), 0.0);
  const auto size = static_cast<double>(sums.size());
  // How much of a side lies before the given sum, within pixels as if it were spread evenly.
  const auto placeOf = [&](auto begin, auto end) {
    double sum = 0.0;
    auto at = begin;
    while (sum + *at <= left && at + 1 != end)
      sum += *at++;
    return (static_cast<double>(at - begin) + (left - sum) / *at) / size;
  };
  return {2.0 * placeOf(sums.begin(), sums.end()) - 1.0, 1.0 - 2.0 * placeOf(sums.rbegin(), sums.rend())};
}

// Columns, then rows.
using Sums = std::array<std::vector<double>, 2>;

Sums noSums(const glm::ivec2& size) {
  return {std::vector<double>(static_cast<std::size_t>(size.x)),
          std::vector<double>(static_cast<std::size_t>(size.y))};
}

// The optical thickness that the picture's alpha tells.
Sums thicknessesDrawn(Scene scene, const glm::ivec2& size) {
  scene.transferFunction = faint(scene.transferFunction);
  const Image image = makePictures({scene}, size, Engine::cpu, 0).front().image;
  Sums sums = noSums(size);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const double thickness = -std::log1p(-static_cast<double>(image.at(x, y).a));
      sums[0][static_cast<std::size_t>(x)] += thickness;
      sums[1][static_cast<std::size_t>(size.y - 1 - y)] += thickness;
    }
  return sums;
}

// Each place with the pixels that what is around it covers, more of them where perspective draws it larger.
Sums placesSeen(const std::vector<glm::dvec3>& places, const Camera& camera, const glm::ivec2& size) {
  const CameraBasis basis = basisOf(camera);
  const bool isPerspective = camera.projection == Camera::Projection::perspective;
  Sums sums = noSums(size);
  for (const glm::dvec3& at : places) {
    const glm::dvec3 seen = at - camera.position;
    const double unit = halfHeight(camera) * (isPerspective ? glm::dot(seen, basis.forward) : 1.0);
    const glm::dvec2 place(glm::dot(seen, basis.right) / unit / size.x * size.y,
                           glm::dot(seen, basis.up) / unit);
    for (int axis = 0; axis < 2; ++axis) {
      const auto pixel = static_cast<int>(std::floor((place[axis] + 1.0) / 2.0 * size[axis]));
      if (pixel >= 0 && pixel < size[axis])
        sums[static_cast<std::size_t>(axis)][static_cast<std::size_t>(pixel)] += 1.0 / (unit * unit);
    }
  }
  return sums;
}

class Framing : public testing::TestWithParam<Patient> {
protected:
  std::string source() const {
    const Patient& patient = GetParam();
    return patient.isShared ? (test::sharedFolder() / patient.source).string() : patient.source;
  }

  // Calls `check(scene, size)` for three views and two shapes of picture.
  template <class Check>
  void expectOfEachPicture(Scene scene, const Check& check) {
    for (const StandardView view : {StandardView::anterior, StandardView::left, StandardView::superior})
      for (const glm::ivec2 size : {glm::ivec2(480, 320), glm::ivec2(240, 360)}) {
        SCOPED_TRACE(std::to_string(static_cast<int>(view)) + ", " + std::to_string(size.x) + " wide");
        scene.camera = framedView(scene, view, 1.0 * size.x / size.y);
        check(scene, size);
      }
  }
};

TEST_P(Framing, visibleVoxelsFillTheShareOfTheLimitingSideAndAreCentred) {
  if (GetParam().isShared)
    LIMN_NEEDS_SHARED(GetParam().source);
  const Scene scene = loadScene(source(), {}, {}).scene;
  const std::vector<glm::dvec3> centres = visibleCentres(scene);
  expectOfEachPicture(scene, [&](const Scene& shown, const glm::ivec2& size) {
    const auto [across, up] = extentsOf(centres, shown.camera, 1.0 * size.x / size.y);
    // Both are exact but for rounding; of the definition's 0.5 % nothing is used.
    EXPECT_NEAR(std::max(across.to - across.from, up.to - up.from) / 2.0, 0.88, 1e-9);
    EXPECT_NEAR(across.from + across.to, 0.0, 1e-9);
    EXPECT_NEAR(up.from + up.to, 0.0, 1e-9);
  });
}

// Saved pictures agree: what their alpha tells of each column and row ends where the voxels end, weighed as
// the picture weighs them.
TEST_P(Framing, picturesShowIt) {
  if (GetParam().isShared)
    LIMN_NEEDS_SHARED(GetParam().source);
  Scene scene = loadScene(source(), {}, {}).scene;
  const std::vector<glm::dvec3> places = visiblePlaces(scene);
  for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic}) {
    scene.camera.projection = projection;
    expectOfEachPicture(scene, [&](const Scene& shown, const glm::ivec2& size) {
      const Sums drawn = thicknessesDrawn(shown, size);
      const Sums seen = placesSeen(places, shown.camera, size);
      const Grid& grid = shown.volume->grid();
      const double voxel = std::max({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z});
      const double depth = shown.camera.projection == Camera::Projection::perspective
                               ? glm::length(shown.camera.target - shown.camera.position)
                               : 1.0;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const Extent shows = extentOfSums(drawn[axis], speck);
        // 500 places that do not count are known to 3 x 4.5 %.
        const Extent most = extentOfSums(seen[axis], 0.865 * speck);
        const Extent least = extentOfSums(seen[axis], 1.135 * speck);
        // A voxel's width, and whole pixels, in halves of the picture's side.
        const double side = axis == 0 ? 1.0 * size.x / size.y : 1.0;
        const double bound =
            voxel / (depth * halfHeight(shown.camera) * side) + 2.0 / size[static_cast<int>(axis)];
        EXPECT_GE(shows.from, most.from - bound) << axis;
        EXPECT_LE(shows.from, least.from + bound) << axis;
        EXPECT_GE(shows.to, least.to - bound) << axis;
        EXPECT_LE(shows.to, most.to + bound) << axis;
      }
      // In parallel rays no part counts for more than its voxels: what was asked for holds of the alpha
      // alone.
      if (GetParam().isSolid && projection == Camera::Projection::orthographic) {
        const Extent across = extentOfSums(drawn[0], speck), up = extentOfSums(drawn[1], speck);
        const double share = std::max(across.to - across.from, up.to - up.from) / 2.0;
        EXPECT_GE(share, 0.86);
        EXPECT_LE(share, 0.90);
      }
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Framing, testing::ValuesIn(patients), nameOfPatient);

} // namespace
} // namespace limn
