// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/RegionController.h"
#include "scene/framing/VisibleBox.h"
#include "support/TestData.h"
#include "widgets/view/overlay/ViewGeometry.h"

#include <array>

// How large what is visible stands in the pictures of the program's window: 85 % of the limiting side.

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
  /// The larger share of a picture's two sides over which the projected corners of the visible box reach,
  /// were it centred: twice the way of the farthest corner from the middle of the picture.
  double share(int position) const {
    const Scene& shown = scene();
    const Grid& grid = shown.volume->grid();
    const IndexBox box = visibleBox(shown);
    const QRectF picture = window->view().logicalRect(position);
    const ViewProjection seen = viewProjection(shown.camera, picture);
    double widest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 index = glm::mix(box.lower, box.upper, glm::bvec3(corner & 1, corner & 2, corner & 4));
      const auto pixel = pixelOf(seen, indexToWorld(grid, index + centreIndex(grid)));
      if (!pixel)
        return INFINITY;
      const QPointF away = *pixel - picture.center();
      widest =
          std::max({widest, std::abs(away.x()) / picture.width(), std::abs(away.y()) / picture.height()});
    }
    return 2.0 * widest;
  }

  /// Every picture of every layout.
  void expectFramed(const char* what) {
    for (const CompareLayout layout :
         {CompareLayout::sideBySide, CompareLayout::single, CompareLayout::wipe}) {
      setLayout(layout);
      QCoreApplication::processEvents(); // what the window arranges, and asks for behind it
      for (int position = 0; position < (layout == CompareLayout::sideBySide ? 2 : 1); ++position)
        EXPECT_NEAR(share(position), 0.85, 0.02) << what << ", " << nameOf(layout);
    }
  }

  void press(const char* key) { window->findChild<QAction*>(QLatin1String(key))->trigger(); }
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

  press("pictureAndCurveOnly");
  expectFramed("with picture and curve only");
}

INSTANTIATE_TEST_SUITE_P(Of, Framing, testing::ValuesIn(patients), nameOfPatient);

} // namespace
} // namespace limn
