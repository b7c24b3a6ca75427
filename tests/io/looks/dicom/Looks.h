// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/DicomLook.h"
#include "io/looks/dicom/DicomObjects.h"
#include "scene/basics/Error.h"
#include "scene/view/Camera.h"
#include "scene/volume/Phantom.h"
#include "support/DicomBuilder.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace limn::test {

/// The images of a series of three, of which the first is a file with a patient in it.
inline SeriesImages seriesIn(const std::filesystem::path& folder) {
  SeriesImages series{1, "1.2.3", "1.2.3.4", {}, folder / "first"};
  for (int number = 1; number <= 3; ++number)
    series.images.push_back({"1.2.840.10008.5.1.4.1.1.2", "1.2.3.4." + std::to_string(number)});
  DicomBuilder image;
  image.text(0x00080016, "UI", series.images[0].sopClass).text(0x00080018, "UI", "1.2.3.4.1");
  image.text(0x00080005, "CS", "ISO_IR 100")
      .text(0x00100010, "PN", "B\xE4r^Anna")
      .text(0x00100020, "LO", "7");
  image.text(0x00080020, "DA", "20240531").text(0x00080050, "SH", "A1").text(0x00101010, "AS", "044Y");
  image.text(0x0020000D, "UI", series.study).text(0x0020000E, "UI", series.series);
  image.text(0x00200052, "UI", "1.2.3.9").text(0x00080060, "CS", "CT");
  image.write(series.firstFile);
  return series;
}

/// A picture of 3 × 1 pixels: an odd number of bytes.
inline BytePicture smallPicture() {
  BytePicture picture;
  picture.size = {3, 1};
  picture.bytes = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  return picture;
}

inline DicomObjects objectsOf(const Scene& scene, bool isAnonymous = false) {
  TemporaryFolder folder;
  return dicomObjectsOf(scene, {seriesIn(folder.path()), smallPicture(), "1.2", {}, isAnonymous});
}

/// The head phantom, unlit, seen from the front.
inline Scene phantomScene(double spacingMm = 6.0) {
  Scene scene;
  PhantomSpec spec;
  spec.spacingMm = spacingMm;
  scene.volume = phantomVolume(spec, {});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.shading.model = ShadingModel::none;
  scene.image.width = scene.image.height = 48;
  scene.transferFunction.points = {
      {-300.0, {0.8, 0.5, 0.4}, 0.0}, {50.0, {0.9, 0.6, 0.4}, 0.05}, {700.0, {1.0, 0.95, 0.9}, 0.6}};
  return scene;
}

/// A look without what Limn keeps for itself, which stands last: as an archive leaves it that drops private
/// attributes.
inline std::string stripped(const std::string& look) {
  const std::size_t at = look.find(std::string("\x49\x4C\x10\x00LO", 6));
  EXPECT_NE(at, std::string::npos);
  return look.substr(0, at);
}

/// The sentence with which a look is refused; empty where it is read.
inline std::string lookRefusal(const std::string& bytes) {
  try {
    parseDicomLook(bytes, "look.dcm");
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input) << error.what();
    return error.what();
  }
}

inline bool says(const std::vector<Message>& sentences, const std::string& part) {
  for (const Message& sentence : sentences)
    if (sentence.english().find(part) != std::string::npos)
      return true;
  return false;
}

} // namespace limn::test
