// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/CutController.h"
#include "app/picture/RegionController.h"
#include "io/VolumeReader.h"
#include "support/ShortVolume.h"
#include "support/TestData.h"
#include "widgets/view/panels/CutBar.h"

#include <QPushButton>

#include <iostream>

// The bone of a CT angiography, taken away in the program's window. The shared angiography holds vessels
// alone: here they lie within a real skull, wherever that leaves them room, four voxels from bone. Vessels
// that touch the base of the skull are another matter: a cut between comes first.

namespace limn {
namespace {

class Angiography : public test::WindowHarness {
protected:
  static constexpr const char* headFile = "data/ct_head_cranium/ct_head_cranium.nii.gz";
  static constexpr const char* vesselsFile = "data/cta_brain_avm/cta_brain_avm_uint8.nii.gz";
  static constexpr double boneHu = 300.0;   // in skulls all above is bone
  static constexpr double vesselHu = 150.0; // in what is left of the second volume all above is vessel

  // Vessels at three quarters of their size, so that they fit, in what is brain for four voxels around.
  void writeAngiography(const std::filesystem::path& file) {
    head = readVolume(test::sharedFolder() / headFile);
    const auto vessels = readVolume(test::sharedFolder() / vesselsFile);
    const Grid& grid = head->grid();
    const glm::dvec3 from = indexToWorld(grid, glm::dvec3(grid.dims) * glm::dvec3(0.5, 0.5, 0.62));
    const Grid& vesselGrid = vessels->grid();
    const glm::dvec3 to = indexToWorld(vesselGrid, 0.5 * glm::dvec3(vesselGrid.dims - 1));
    test::writeShorts(file, grid.dims, grid.spacingMm, [&](const glm::ivec3& voxel) {
      const double tissue = head->value(voxel);
      const glm::dvec3 world = (indexToWorld(grid, glm::dvec3(voxel)) - from) / 0.75 + to;
      const glm::dvec3 index = worldToIndex(vesselGrid, world);
      const bool isInside = glm::all(glm::greaterThanEqual(index, glm::dvec3(0.0))) &&
                            glm::all(glm::lessThanEqual(index, glm::dvec3(vesselGrid.dims - 1)));
      const double contrast = isInside ? valueAt(*vessels, index) : 0.0;
      const bool isVessel = contrast > vesselHu && isBrainAround(voxel);
      if (isVessel)
        vesselVoxels.push_back(voxel);
      else if (tissue > boneHu)
        boneVoxels.push_back(voxel);
      return static_cast<int>(isVessel ? contrast : tissue);
    });
  }

  bool isBrainAround(const glm::ivec3& voxel) const {
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-4, -2, 0, 2, 4}) {
        glm::ivec3 beside = voxel;
        beside[axis] = std::clamp(beside[axis] + step, 0, head->grid().dims[axis] - 1);
        const double hu = head->value(beside);
        if (hu < -50.0 || hu > 100.0)
          return false;
      }
    return true;
  }

  double shareKept(const std::vector<glm::ivec3>& voxels) const {
    double kept = 0.0;
    for (const glm::ivec3& voxel : voxels)
      kept += weightAt(scene().keep, glm::dvec3(voxel));
    return kept / static_cast<double>(voxels.size());
  }

  [[nodiscard]] bool ready() {
    auto* regions = window->findChild<RegionController*>();
    auto* cuts = window->findChild<CutController*>();
    return test::waitUntil([=] { return !regions->isBusy() && !cuts->isBusy(); });
  }

  void press(Qt::Key key) {
    view().setFocus();
    QTest::keyClick(&view(), key);
    QCoreApplication::processEvents();
  }
  void clickPicture(const QPointF& share) {
    const QRectF picture = view().logicalRect(0);
    const QPointF at = picture.topLeft() + QPointF(share.x() * picture.width(), share.y() * picture.height());
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, view().mapTo(window.get(), at.toPoint()));
    QCoreApplication::processEvents();
  }
  void clickButton(const QString& text) {
    for (QPushButton* button : view().findChild<CutBar*>()->findChildren<QPushButton*>())
      if (button->text() == text) {
        QTest::mouseClick(button, Qt::LeftButton);
        return;
      }
    ADD_FAILURE() << "no button " << text.toStdString();
  }
  std::shared_ptr<const Volume> head;
  std::vector<glm::ivec3> boneVoxels, vesselVoxels;
};

TEST_F(Angiography, boneGoesByThreeGesturesAndNoVesselWithIt) {
  LIMN_NEEDS_SHARED(headFile);
  LIMN_NEEDS_SHARED(vesselsFile);
  const std::filesystem::path file = folder.path() / "angiography.nrrd";
  writeAngiography(file);
  ASSERT_GT(vesselVoxels.size(), 5000u);
  ASSERT_TRUE(openAlone(QString::fromStdString(file.string())));
  ASSERT_TRUE(rest());
  // Three gestures: a key, a click, a button.
  press(Qt::Key_K);
  clickPicture({0.5, 0.35});
  ASSERT_TRUE(ready());
  ASSERT_TRUE(window->findChild<CutController*>()->hasPiece());
  clickButton(QStringLiteral("Hide"));
  ASSERT_TRUE(ready());
  ASSERT_TRUE(rest());
  const double bone = shareKept(boneVoxels), vessels = shareKept(vesselVoxels);
  std::cout << "kept of " << boneVoxels.size() << " voxels of bone: " << bone << ", of "
            << vesselVoxels.size() << " of vessels: " << vessels << '\n';
  EXPECT_EQ(vessels, 1.0);
  EXPECT_LT(bone, 0.05);
}

} // namespace
} // namespace limn
