// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/VolumeBytes.h"

namespace limn {
namespace {

using namespace test;

std::string legacy(const std::string& encoding, const std::string& more) {
  return "# vtk DataFile Version 3.0\na title\n" + encoding +
         "\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 3 4\nORIGIN 10 20 30\nSPACING 2 3 4\nPOINT_DATA 24\n" +
         more;
}

const std::string scalars = "SCALARS values short 1\nLOOKUP_TABLE default\n";

TEST(VtkLegacy, binaryAndTextHoldTheSameVolume) {
  std::string text;
  for (int i = 0; i < 24; ++i)
    text += std::to_string(i) + " ";
  const auto a = openedAs("a.vtk", legacy("BINARY", scalars + bytesOf(rising<std::int16_t>(24), true)));
  const auto b = openedAs("a.vtk", legacy("ASCII", scalars + text));
  EXPECT_EQ(a->stored(), b->stored());
  EXPECT_EQ(a->value({1, 2, 3}), 23.0);
  expectNear(indexToWorld(a->grid(), {1, 2, 3}), {12, 26, 42});
  EXPECT_FALSE(a->info().orientationKnown);
  EXPECT_TRUE(warns(*a, "Orientation unknown"));
}

TEST(VtkLegacy, shortFilesAndOtherDataSetsAreRefused) {
  EXPECT_NE(refusalAs("a.vtk", legacy("BINARY", scalars + std::string(47, '\0'))).find("holds only"),
            std::string::npos);
  EXPECT_NE(refusalAs("a.vtk", legacy("ASCII", scalars + std::string(60, '1'))).find("number"),
            std::string::npos);
  std::string other = legacy("BINARY", scalars + std::string(48, '\0'));
  other.replace(other.find("STRUCTURED_POINTS"), 17, "POLYDATA");
  EXPECT_NE(refusalAs("a.vtk", other).find("STRUCTURED_POINTS"), std::string::npos);
  EXPECT_NE(refusalAs("a.vtk", legacy("BINARY", "")).find("SCALARS"), std::string::npos);
}

std::string xml(const std::string& extent, const std::string& array, const std::string& more = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt32\">\n<ImageData WholeExtent=\"" +
         extent + "\" Origin=\"10 20 30\" Spacing=\"2 3 4\"" + more + ">\n<Piece Extent=\"" + extent +
         "\"><PointData Scalars=\"v\">" + array + "</PointData></Piece></ImageData>\n";
}

std::string textArray(const std::string& type) {
  std::string text = "<DataArray type=\"" + type + "\" Name=\"v\" format=\"ascii\">";
  for (int i = 0; i < 24; ++i)
    text += std::to_string(i) + " ";
  return text + "</DataArray>";
}

TEST(VtkXml, placesItsPointsByExtentSpacingAndDirection) {
  const auto volume = openedAs("a.vti", xml("0 1 0 2 0 3", textArray("Int16")) + "</VTKFile>");
  EXPECT_EQ(voxelTypeName(volume->stored()), "int16");
  EXPECT_EQ(volume->value({1, 2, 3}), 23.0);
  expectNear(indexToWorld(volume->grid(), {1, 2, 3}), {12, 26, 42});
  EXPECT_FALSE(volume->info().orientationKnown);
  // An extent that starts at 5 moves the first point; the direction is written row by row.
  const auto turned = openedAs(
      "a.vti", xml("5 6 0 2 0 3", textArray("Float64"), " Direction=\"0 -1 0 1 0 0 0 0 1\"") + "</VTKFile>");
  expectNear(turned->grid().originMm, {10, 30, 30});
  expectNear(indexToWorld(turned->grid(), {1, 2, 3}), {10 - 6, 30 + 2, 30 + 12});
}

TEST(VtkXml, readsBase64AndLongLengths) {
  const auto array = [](const std::string& text) {
    return "<DataArray type=\"UInt8\" Name=\"v\" format=\"binary\">\n  " + text + "\n</DataArray>";
  };
  // The length 2 in four bytes, then the voxels 7 and 9: 02 00 00 00 07 09.
  const auto plain = openedAs("a.vti", xml("0 1 0 0 0 0", array("AgAAAAcJ")) + "</VTKFile>");
  EXPECT_EQ(plain->value({0, 0, 0}), 7.0);
  EXPECT_EQ(plain->value({1, 0, 0}), 9.0);
  // The same with a length of eight bytes: 02 00 00 00 00 00 00 00 07 09.
  std::string text = xml("0 1 0 0 0 0", array("AgAAAAAAAAAHCQ==")) + "</VTKFile>";
  text.replace(text.find("UInt32"), 6, "UInt64");
  EXPECT_EQ(openedAs("a.vti", text)->stored(), plain->stored());
  // A letter that is none, and a length that does not fit.
  refusalAs("a.vti", xml("0 1 0 0 0 0", array("AgAA!AcJ")) + "</VTKFile>");
  refusalAs("a.vti", xml("0 1 0 0 0 0", array("AwAAAAcJ")) + "</VTKFile>");
}

TEST(VtkXml, valuesOfCellsLieBetweenThePoints) {
  std::string text =
      xml("0 2 0 1 0 1", "<DataArray type=\"Int16\" Name=\"v\" format=\"ascii\">5 6</DataArray>");
  for (std::size_t at = 0; (at = text.find("PointData", at)) != std::string::npos;)
    text.replace(at, 9, "CellData");
  const auto volume = openedAs("a.vti", text + "</VTKFile>");
  EXPECT_EQ(volume->grid().dims, glm::ivec3(2, 1, 1));
  expectNear(volume->grid().originMm, {11, 21.5, 32});
}

TEST(VtkXml, damagedFilesAreRefused) {
  const std::string appended = "<DataArray type=\"Int16\" Name=\"v\" format=\"appended\" offset=\"0\"/>";
  const std::string start = xml("0 1 0 2 0 3", appended) + "<AppendedData encoding=\"raw\">_";
  const std::string end = "</AppendedData></VTKFile>";
  const std::string size = bytesOf<std::uint32_t>({48});
  EXPECT_EQ(openedAs("a.vti", start + size + bytesOf(rising<std::int16_t>(24)) + end)->value({1, 2, 3}),
            23.0);
  refusalAs("a.vti", start + size + std::string(10, '\1'));
  refusalAs("a.vti", start);
  refusalAs("a.vti", xml("0 1 0 2 0 3", "").substr(0, 150));
  EXPECT_NE(
      refusalAs("a.vti", xml("0 30000 0 30000 0 3", textArray("Int16")) + "</VTKFile>").find("too short"),
      std::string::npos);
  refusalAs("a.vti", xml("0 1 0 2 0 3", "") + "</VTKFile>");
}

TEST(VtkXml, otherDataSetsAreRefusedByName) {
  std::string text = xml("0 1 0 2 0 3", textArray("Int16")) + "</VTKFile>";
  text.replace(text.find("ImageData"), 9, "PolyData");
  EXPECT_NE(refusalAs("a.vti", text).find("PolyData"), std::string::npos);
}

} // namespace
} // namespace limn
