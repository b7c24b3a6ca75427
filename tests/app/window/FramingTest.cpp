// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/RegionController.h"
#include "scene/framing/VisibleVoxels.h"
#include "support/TestData.h"
#include "widgets/view/overlay/ViewGeometry.h"

#include <algorithm>
#include <cmath>

// How large what is visible stands in the pictures of the program's window: 88 % of the limiting side.

namespace limn {
namespace {

/// A volume by its name in the test; real ones lie below the shared folder.
struct Patient {
  const char* name;
  const char* source;
  bool isShared;
};

// The phantom at five spacings stands in where the shared volumes are not.
const Patient patients[] = {{"phantom3mm", "phantom:3", false},
                            {"phantom4mm", "phantom:4", false},
                            {"phantom5mm", "phantom:5", false},
                            {"phantom6mm", "phantom:6", false},
                            {"phantom8mm", "phantom:8", false},
                            {"ctHead", "data/ct_head_cranium/ct_head_cranium.nii.gz", true},
                            {"tiltedCt", "data/ct_head_phantom_tilt_dicom", true},
                            {"thorax", "data/ct_thorax_contrast/lidc2_uint8.vti", true},
                            {"cta", "data/cta_brain_avm/cta_brain_avm_uint8.nii.gz", true},
                            {"mrT1", "data/mr_t1_head/mr_t1_head.nii.gz", true},
                            {"mrPd", "data/mr_pd_head_dicom", true},
                            {"mrBrain", "data/mr_brain_nrrd/brain1_image.nrrd", true},
                            {"bonsai", "data/classic/bonsai.nii.gz", true},
                            {"engine", "data/classic/engine.nii.gz", true},
                            {"tooth", "data/classic/tooth/tooth.nhdr", true}};

std::string nameOfPatient(const testing::TestParamInfo<Patient>& patient) {
  return patient.param.name;
}

class Framing : public test::WindowHarness, public testing::WithParamInterface<Patient> {
protected:
  // Where the camera stands does not depend on who draws; the processor does so in half of the time.
  Framing() : WindowHarness(Engine::cpu) {}

  /// Where the counted voxels begin and end on both axes of a picture, as shares of its sides.
  struct Rectangle {
    double share;  ///< of the limiting side
    double astray; ///< the larger share by which its middle lies off the picture's
  };
  Rectangle rectangle(int position) const {
    const Grid& grid = scene().volume->grid();
    const QRectF picture = window->view().logicalRect(position);
    const ViewProjection seen = viewProjection(scene().camera, picture);
    std::vector<double> across, up;
    for (const glm::dvec3& index : m_sample) {
      const auto pixel = pixelOf(seen, indexToWorld(grid, index));
      across.push_back(pixel ? (pixel->x() - picture.center().x()) / picture.width() : INFINITY);
      up.push_back(pixel ? (pixel->y() - picture.center().y()) / picture.height() : INFINITY);
    }
    const auto [left, right] = endsOf(std::move(across));
    const auto [top, bottom] = endsOf(std::move(up));
    return {std::max(right - left, bottom - top),
            std::max(std::abs(left + right), std::abs(top + bottom)) / 2.0};
  }

  /// At most so many of the voxels that framing looks at, evenly chosen, and how many of these do not count
  /// on a side.
  void sampleVisible() {
    constexpr std::size_t most = 100000;
    const VisibleVoxels visible = visibleVoxels(scene());
    std::vector<glm::dvec3> all;
    for (const VisibleBlock& block : visible.blocks)
      for (int unit = 0; unit < 512; ++unit)
        if (block.units[static_cast<std::size_t>(unit / 64)] >> (unit % 64) & 1)
          all.emplace_back(8 * block.place + glm::ivec3(unit % 8, unit / 8 % 8, unit / 64));
    ASSERT_EQ(visible.unitVoxels, 1);
    const std::size_t step = 1 + all.size() / most;
    m_sample.clear();
    for (std::size_t i = 0; i < all.size(); i += step)
      m_sample.push_back(all[i]);
    m_left = static_cast<std::ptrdiff_t>(0.0005 * static_cast<double>(visible.voxels / step));
  }

  /// Every picture of every layout.
  void expectFramed(const char* what) {
    sampleVisible();
    for (const CompareLayout layout :
         {CompareLayout::sideBySide, CompareLayout::single, CompareLayout::wipe}) {
      setLayout(layout);
      QCoreApplication::processEvents(); // what the window arranges, and asks for behind it
      for (int position = 0; position < (layout == CompareLayout::sideBySide ? 2 : 1); ++position) {
        // 0.5 % of the definition, and what the outermost of a sample of a tenth may lie within those of all.
        const Rectangle seen = rectangle(position);
        EXPECT_NEAR(seen.share, 0.88, 0.01) << what << ", " << nameOf(layout);
        EXPECT_LT(seen.astray, 0.01) << what << ", " << nameOf(layout);
      }
    }
  }

  std::pair<double, double> endsOf(std::vector<double> places) const {
    std::nth_element(places.begin(), places.begin() + m_left, places.end());
    const double first = places[static_cast<std::size_t>(m_left)];
    std::nth_element(places.begin(), places.end() - 1 - m_left, places.end());
    return {first, *(places.end() - 1 - m_left)};
  }

  void press(const char* key) { window->findChild<QAction*>(QLatin1String(key))->trigger(); }

private:
  std::vector<glm::dvec3> m_sample; // centres, voxel index
  std::ptrdiff_t m_left = 0;
};

TEST_P(Framing, whatIsVisibleFillsThePictures) {
  const Patient& patient = GetParam();
  QString source = QLatin1String(patient.source);
  if (patient.isShared) {
    LIMN_NEEDS_SHARED(patient.source);
    source = QString::fromStdString((test::sharedFolder() / patient.source).string());
  }
  ASSERT_TRUE(open(source));
  ASSERT_TRUE(scene().volume);
  ASSERT_TRUE(rest()); // from now on the camera follows the pictures' shape
  expectFramed("as it is opened");

  // No edit moves the camera; R frames what is left.
  CropBox half;
  half.upper = {0.5, 1.0, 0.7};
  const Camera before = scene().camera;
  session().setCrop(half, {nextGestureId(), QStringLiteral("crop")});
  ASSERT_TRUE(rest());
  EXPECT_EQ(scene().camera, before) << "with a crop";
  window->view().resetCamera();
  expectFramed("with a crop");
  session().setCrop({}, {nextGestureId(), QStringLiteral("crop")});
  window->view().resetCamera();
  expectFramed("without the crop again");

  press("bodyOnly");
  RegionController& controller = *window->findChild<RegionController*>();
  ASSERT_TRUE(test::waitUntil([&] { return !controller.isBusy(); }));
  window->view().resetCamera();
  expectFramed("with the other region");

  press("pictureOnly");
  expectFramed("with the picture alone");
}

INSTANTIATE_TEST_SUITE_P(Of, Framing, testing::ValuesIn(patients), nameOfPatient);

} // namespace
} // namespace limn
