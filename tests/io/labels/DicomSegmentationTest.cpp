// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomSegmentation.h"
#include "io/labels/LabelReader.h"
#include "io/labels/MaskFolder.h"
#include "scene/basics/Error.h"
#include "support/DicomBuilder.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <random>

namespace limn {
namespace {

using test::DicomBuilder;

constexpr int columns = 5, rows = 3; // 15 pixels: frames begin within bytes

DicomBuilder segment(int number, const std::string& name, const std::vector<std::uint16_t>& color) {
  DicomBuilder item;
  item.us(0x00620004, {static_cast<std::uint16_t>(number)}).text(0x00620005, "LO", name);
  if (!color.empty())
    item.us(0x0062000D, color);
  return item;
}

// The functional groups of a frame: which segment, at what height (mm).
DicomBuilder frameOf(int segment, double height) {
  DicomBuilder identification, position, groups;
  identification.us(0x0062000B, {static_cast<std::uint16_t>(segment)});
  position.text(0x00200032, "DS", "10\\20\\" + std::to_string(height));
  groups.sequence(0x0062000A, {identification}).sequence(0x00209113, {position});
  return groups;
}

// A segmentation of two segments in planes 2 mm apart, of which the second (at 32 mm) is left out: segment 1
// in the first pixel of the plane at 30 mm, segment 2 in the last of 30 mm and the second row of 34 mm.
DicomBuilder segmentation() {
  DicomBuilder orientation, measures, shared;
  orientation.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  measures.text(0x00280030, "DS", "1\\1").text(0x00180088, "DS", "2");
  shared.sequence(0x00209116, {orientation}).sequence(0x00289110, {measures});
  std::vector<std::uint8_t> bits(6, 0);
  const auto set = [&bits](int frame, int pixel) {
    const int bit = frame * columns * rows + pixel;
    bits[static_cast<std::size_t>(bit / 8)] |= static_cast<std::uint8_t>(1 << (bit % 8));
  };
  set(0, 0);
  set(1, 14);
  for (int x = 0; x < columns; ++x)
    set(2, columns + x);
  DicomBuilder file;
  // White is L* = 100; a word of 128/255 is 0.
  return file.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.4")
      .text(0x00080005, "CS", "ISO_IR 192")
      .text(0x00080060, "CS", "SEG")
      .text(0x00280008, "IS", "3")
      .us(0x00280010, {rows})
      .us(0x00280011, {columns})
      .us(0x00280002, {1})
      .us(0x00280100, {1})
      .us(0x00280101, {1})
      .us(0x00280102, {0})
      .us(0x00280103, {0})
      .text(0x00280004, "CS", "MONOCHROME2")
      .text(0x00620001, "CS", "BINARY")
      .sequence(0x00620002, {segment(1, "Größe", {65535, 32896, 32896}), segment(2, "Rib", {})})
      .sequence(0x52009229, {shared})
      .sequence(0x52009230, {frameOf(1, 30), frameOf(2, 30), frameOf(2, 34)})
      .pixels(bits);
}

Grid gridOfVolume() {
  Grid grid;
  grid.dims = {columns, rows, 4};
  grid.spacingMm = {1, 1, 2};
  grid.originMm = {10, 20, 30};
  return grid;
}

class DicomSegmentation : public testing::Test {
protected:
  std::filesystem::path written(const DicomBuilder& file) const {
    file.write(folder.path() / "seg.dcm");
    return folder.path() / "seg.dcm";
  }

  std::string refusalOf(const DicomBuilder& file) const {
    try {
      (void)readLabels(written(file), gridOfVolume());
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }

  test::TemporaryFolder folder;
};

int valueAt(const LabelMap& map, const glm::ivec3& voxel) {
  return map.labels()[map.placeAt(voxelOffset(map.dims(), voxel.x, voxel.y, voxel.z))].value;
}

TEST_F(DicomSegmentation, becomesLabelsWithNamesAndColours) {
  const Region region = readLabels(written(segmentation()), gridOfVolume());
  const LabelMap& map = *region.labels;
  ASSERT_EQ(map.labels().size(), 3u);
  EXPECT_EQ(map.labels()[1].name, "Größe");
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(map.labels()[1].color[channel], 1.0, 1e-3);
  EXPECT_EQ(map.labels()[2].name, "Rib");
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const glm::ivec3 voxel(x, y, z);
        const int expected = voxel == glm::ivec3(0, 0, 0)                         ? 1
                             : voxel == glm::ivec3(4, 2, 0) || (y == 1 && z == 2) ? 2
                                                                                  : 0;
        EXPECT_EQ(valueAt(map, voxel), expected) << x << " " << y << " " << z;
      }
}

TEST_F(DicomSegmentation, sayWhatTheySegmentWhereTheFileDoes) {
  const auto code = [](const char* meaning) {
    DicomBuilder item;
    item.text(0x00080100, "SH", "1").text(0x00080104, "LO", meaning);
    return item;
  };
  DicomBuilder first = segment(1, "Größe", {});
  first.sequence(0x00620003, {code("Anatomical Structure")}).sequence(0x0062000F, {code("Höhle")});
  DicomBuilder file = segmentation();
  file.sequence(0x00620002, {first, segment(2, "Rib", {})});
  const Region region = readLabels(written(file), gridOfVolume());
  const std::vector<Label>& labels = region.labels->labels();
  ASSERT_EQ(labels.size(), 3u);
  EXPECT_EQ(labels[1].category, "Anatomical Structure");
  EXPECT_EQ(labels[1].type, "Höhle") << "in the file's characters";
  EXPECT_EQ(labels[2].category, "");
  EXPECT_EQ(labels[2].type, "");
}

// Opened together, each keeps the name that its file gives it.
TEST_F(DicomSegmentation, ofOneSegmentEachAreMasksAmongOthers) {
  const auto oneOf = [](const char* name, int height) {
    DicomBuilder file = segmentation();
    file.text(0x00280008, "IS", "1")
        .sequence(0x00620002, {segment(1, name, {})})
        .sequence(0x52009230, {frameOf(1, height)})
        .pixels(std::vector<std::uint8_t>{1, 0});
    return file;
  };
  const std::vector<std::filesystem::path> files{folder.path() / "a.dcm", folder.path() / "b.dcm"};
  oneOf("Größe", 30).write(files[0]);
  oneOf("Rib", 34).write(files[1]);
  const Segmentation read = readSegmentations(files, gridOfVolume());
  const LabelMap& map = *read.region.labels;
  EXPECT_EQ(read.remark.english(), "");
  ASSERT_EQ(map.labels().size(), 3u);
  EXPECT_EQ(map.labels()[1].name, "Größe");
  EXPECT_EQ(map.labels()[2].name, "Rib");
  EXPECT_EQ(valueAt(map, {0, 0, 0}), 1);
  EXPECT_EQ(valueAt(map, {0, 0, 2}), 2);
  const Region alone = readSegmentation(files[0], gridOfVolume()).region;
  std::filesystem::remove(files[0]);
  EXPECT_TRUE(isOfMasks(alone)) << "another comes to it also once its file has gone";
}

TEST_F(DicomSegmentation, coloursAreThoseOfTheStandard) {
  // sRGB red in CIELab of D50 is (54.29, 80.80, 69.89), green (87.82, -79.27, 80.99), blue (29.57, 68.29,
  // -112.03): B. Lindbloom's calculator, Bradford adaptation.
  const auto word = [](double value, double from, double length) {
    return static_cast<std::uint16_t>(std::lround((value - from) / length * 65535.0));
  };
  const auto rgbOf = [&](double l, double a, double b) {
    return colorOfCieLab({word(l, 0, 100), word(a, -128, 255), word(b, -128, 255)});
  };
  const auto expectNear = [](const glm::dvec3& color, const glm::dvec3& expected) {
    EXPECT_LT(glm::length(color - expected), 0.02) << color.r << " " << color.g << " " << color.b;
  };
  expectNear(rgbOf(54.29, 80.80, 69.89), {1, 0, 0});
  expectNear(rgbOf(87.82, -79.27, 80.99), {0, 1, 0});
  expectNear(rgbOf(29.57, 68.29, -112.03), {0, 0, 1});
  expectNear(rgbOf(0, 0, 0), {0, 0, 0});
}

TEST_F(DicomSegmentation, ofFractionsCountsFromHalfOn) {
  DicomBuilder file = segmentation();
  std::vector<std::uint8_t> shares(46, 0); // a byte of padding makes the length even
  shares[0] = 50;
  shares[1] = 49;
  file.text(0x00620001, "CS", "FRACTIONAL").us(0x0062000E, {100}).us(0x00280100, {8}).pixels(shares);
  const Region region = readLabels(written(file), gridOfVolume());
  EXPECT_EQ(valueAt(*region.labels, {0, 0, 0}), 1);
  EXPECT_EQ(valueAt(*region.labels, {1, 0, 0}), 0);
}

TEST_F(DicomSegmentation, isRefusedInASentenceWhereItContradictsItself) {
  EXPECT_NE(refusalOf(segmentation().text(0x00280008, "IS", "400000000")).find("too short for the frames"),
            std::string::npos);
  EXPECT_NE(refusalOf(segmentation().us(0x00280100, {16})).find("contradicts itself"), std::string::npos);
  EXPECT_NE(refusalOf(segmentation().us(0x00280010, {0})).find("contradicts itself"), std::string::npos);
  EXPECT_NE(refusalOf(segmentation().without(0x52009230)).find("which segment each shows"),
            std::string::npos);
  EXPECT_NE(refusalOf(segmentation().without(0x52009229)).find("how its frames lie"), std::string::npos);
  EXPECT_NE(refusalOf(segmentation().without(0x7FE00010)).find("holds no segments"), std::string::npos);
  EXPECT_NE(refusalOf(segmentation().sequence(0x52009230, {frameOf(1, 30), frameOf(2, 33), frameOf(2, 34)}))
                .find("accepted"),
            std::string::npos)
      << "planes 1 mm apart, of which two are left out";
  EXPECT_NE(refusalOf(segmentation().sequence(0x52009230, {frameOf(1, 30), frameOf(2, 32.5), frameOf(2, 34)}))
                .find("no even stack"),
            std::string::npos);
}

TEST_F(DicomSegmentation, cutAnywhereIsRefusedOrRead) {
  const std::string whole = segmentation().bytes();
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    std::ofstream(folder.path() / "cut.dcm", std::ios::binary) << whole.substr(0, length);
    EXPECT_THROW((void)readLabels(folder.path() / "cut.dcm", gridOfVolume()), Error) << length;
  }
}

// Whatever bytes are changed: labels or a sentence.
TEST_F(DicomSegmentation, damagedAtRandomIsRefusedOrRead) {
  const std::string whole = segmentation().bytes();
  std::mt19937 random(14);
  int refused = 0;
  for (int run = 0; run < 500; ++run) {
    std::string damaged = whole;
    for (int n = 0; n < 4; ++n)
      damaged[128 + random() % (damaged.size() - 128)] = static_cast<char>(random());
    std::ofstream(folder.path() / "damaged.dcm", std::ios::binary) << damaged;
    try {
      EXPECT_EQ(readLabels(folder.path() / "damaged.dcm", gridOfVolume()).labels->dims(),
                gridOfVolume().dims);
    } catch (const Error& error) {
      EXPECT_FALSE(std::string(error.what()).empty());
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(refused, 500);
}

} // namespace
} // namespace limn
