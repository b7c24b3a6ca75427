// SPDX-License-Identifier: GPL-3.0-or-later
#include "Corpus.h"
#include "GoodBytes.h"

namespace limn::test {
namespace {

using enum Outcome;

const std::string legacyStart =
    "# vtk DataFile Version 3.0\na title\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 3 4\nORIGIN 10 20 "
    "30\n"
    "SPACING 2 3 4\nPOINT_DATA 24\nSCALARS values short 1\nLOOKUP_TABLE default\n";

std::string legacy(const std::string& start = legacyStart) {
  return start + goodVoxels(true);
}

void addLegacy(Corpus& corpus, const std::string& flaw, const std::string& from, const std::string& to,
               const Outcomes& allowed, const std::string& says = "") {
  corpus.addFile(flaw, "a.vtk", legacy(replaced(legacyStart, from, to)), allowed, says);
}

// `from` in a VTI file whose values are text.
std::string xml(const std::string& array, const std::string& more = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt32\"" +
         more +
         ">\n<ImageData WholeExtent=\"0 1 0 2 0 3\" Origin=\"10 20 30\" Spacing=\"2 3 4\" "
         "Direction=\"1 0 0 0 1 0 0 0 1\">\n<Piece Extent=\"0 1 0 2 0 3\"><PointData Scalars=\"v\">" +
         array + "</PointData></Piece></ImageData>\n";
}

const std::string zlib = " compressor=\"vtkZLibDataCompressor\"";
const std::string end = "</VTKFile>\n";

std::string array(const std::string& format, const std::string& inside) {
  return "<DataArray type=\"Int16\" Name=\"v\" format=\"" + format + "\">" + inside + "</DataArray>";
}

std::string base64(const std::string& bytes) {
  static const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j <= bytes.size() ? letters[bits >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

std::string textFile() {
  return xml(array("ascii", goodText())) + end;
}

std::string appendedFile(const std::string& bytes, const std::string& offset = "0",
                         const std::string& more = "") {
  return xml("<DataArray type=\"Int16\" Name=\"v\" format=\"appended\" offset=\"" + offset + "\"/>", more) +
         "<AppendedData encoding=\"raw\">_" + bytes + "</AppendedData>" + end;
}

std::string lengths(const std::vector<std::uint32_t>& values) {
  return bytesOf(values);
}

void addXml(Corpus& corpus, const std::string& flaw, const std::string& from, const std::string& to,
            const Outcomes& allowed, const std::string& says = "") {
  corpus.addFile(flaw, "a.vti", replaced(textFile(), from, to), allowed, says);
}

// The extent stands twice, of the whole and of its piece.
void addExtent(Corpus& corpus, const std::string& flaw, const std::string& extent) {
  const std::string once = replaced(textFile(), "0 1 0 2 0 3", extent);
  corpus.addFile(flaw, "a.vti", replaced(once, "Piece Extent=\"0 1 0 2 0 3", "Piece Extent=\"" + extent),
                 {refused});
}

void addXmlNumbers(Corpus& corpus) {
  for (const char* extent : {"0 -1 0 2 0 3", "0 -9 0 2 0 3", "1 0 1 0 1 0"})
    addExtent(corpus, "zero or negative size", extent);
  for (const char* extent :
       {"0 2147483647 0 2 0 3", "0 2097151 0 2097151 0 2097151", "0 4294967295 0 4294967295 0 0",
        "-9223372036854775808 9223372036854775807 0 2 0 3", "0 1e300 0 2 0 3", "nan nan 0 2 0 3",
        "0 0.5 0 2 0 3"})
    addExtent(corpus, "oversized dimensions", extent);
  addXml(corpus, "contradiction", "Piece Extent=\"0 1", "Piece Extent=\"0 0", {refused});
  for (const char* spacing : {"0 3 4", "nan 3 4", "inf 3 4", "1e-30 3 4", "1e30 3 4"})
    addXml(corpus, "spacing", "Spacing=\"2 3 4", std::string("Spacing=\"") + spacing, {refused});
  for (const char* direction : {"0 0 0 0 1 0 0 0 1", "1 1 0 0 0 0 0 0 1", "nan 0 0 0 1 0 0 0 1"})
    addXml(corpus, "orientation", "1 0 0 0 1 0 0 0 1", direction, {refused});
  addXml(corpus, "orientation", "10 20 30", "1e30 0 0", {refused});
  addXml(corpus, "orientation", "10 20 30", "nan 0 0", {refused});
}

void addXmlMeanings(Corpus& corpus) {
  addXml(corpus, "vector or colour", "Name=\"v\"", "Name=\"v\" NumberOfComponents=\"9\"", {refused});
  addXml(corpus, "vector or colour", "Name=\"v\"", "Name=\"v\" NumberOfComponents=\"3\"", {refused});
  addXml(corpus, "vector or colour", "Name=\"v\"", "Name=\"v\" NumberOfComponents=\"-1\"", {refused});
  addXml(corpus, "contradiction", "Int16", "String", {refused});
  addXml(corpus, "contradiction", "\n22 ", "\n", {refused});
  addXml(corpus, "contradiction", "ascii", "binary", {refused});
  addXml(corpus, "contradiction", "ascii", "appended", {refused});
  addXml(corpus, "not an image", "type=\"ImageData\"", "type=\"PolyData\"", {refused});
  addXml(corpus, "wrong magic", "<VTKFile", "<VTKfile", {refused});
  addXml(corpus, "truncated", "</DataArray>", "", {refused});
  corpus.addFile("contradiction", "a.vti.gz", deflated(textFile()), {refused}, "gzip");
  // An entity that would grow a thousandfold with each of ten levels; no entity of a file's own is read.
  std::string laughs = "<!DOCTYPE v [<!ENTITY a0 \"1 \">";
  for (int i = 1; i <= 10; ++i)
    laughs += "<!ENTITY a" + std::to_string(i) + " \"" + [&] {
      std::string text;
      for (int j = 0; j < 1000; ++j)
        text += "&a" + std::to_string(i - 1) + ";";
      return text;
    }() + "\">";
  addXml(corpus, "decompression bomb", "<VTKFile", laughs + "]><VTKFile", {correct, refused});
  std::string deep;
  for (int i = 0; i < 300000; ++i)
    deep += "<a>";
  addXml(corpus, "endless or cyclic", "<PointData", deep + "<PointData", {refused});
}

void addXmlArrays(Corpus& corpus) {
  const std::string size = lengths({48});
  for (const char* offset : {"1", "48", "18446744073709551615", "18446744073709551000", "-1", "99999999999"})
    corpus.addFile("contradiction", "a.vti", appendedFile(size + goodVoxels(), offset), {refused});
  corpus.addFile("contradiction", "a.vti", appendedFile(lengths({47}) + goodVoxels()), {refused});
  corpus.addFile("oversized dimensions", "a.vti", appendedFile(lengths({0xffffffff}) + goodVoxels()),
                 {refused});
  // Blocks: their number, the size of each, of the last, their lengths when packed.
  const std::string packed = deflated(goodVoxels(), false);
  const auto length = static_cast<std::uint32_t>(packed.size());
  for (const auto& head : {std::vector<std::uint32_t>{0, 48, 0, length},
                           {0xffffffff, 48, 0, length},
                           {1, 0, 0, length},
                           {1, 48, 0, 0xffffffff},
                           {1, 0xffffffff, 48, length},
                           {1, 48, 0xffffffff, length},
                           {2, 48, 0, length},
                           {1, 48, 0, 0},
                           {1, 48, 0, length - 1}})
    corpus.addFile("contradiction", "a.vti", appendedFile(lengths(head) + packed, "0", zlib), {refused});
  const std::string vast = bomb("", 64, 15);
  corpus.addFile("decompression bomb", "a.vti",
                 appendedFile(lengths({1, 48, 0, static_cast<std::uint32_t>(vast.size())}) + vast, "0", zlib),
                 {refused});
  const std::string claim =
      appendedFile(lengths({1, 1u << 30, 0, static_cast<std::uint32_t>(vast.size())}) + vast, "0", zlib);
  const std::string once = replaced(claim, "0 1 0 2 0 3", "0 1023 0 1023 0 511");
  corpus
      .addFile("decompression bomb", "a.vti",
               replaced(once, "Extent=\"0 1 0 2 0 3", "Extent=\"0 1023 0 1023 0 511"), {refused})
      .heldBytes = 64u << 20;
  corpus.addFile("contradiction", "a.vti", xml(array("binary", base64(size + goodVoxels()) + "AAAA")) + end,
                 {correct, warned, refused});
  corpus.addFile("truncated", "a.vti", xml(array("binary", base64(size + goodVoxels().substr(0, 40)))) + end,
                 {refused});
  corpus.addFile("wrong magic", "a.vti", xml(array("binary", "!!!!" + base64(size + goodVoxels()))) + end,
                 {refused});
}

} // namespace

void addVtkLegacyInputs(Corpus& corpus) {
  corpus.addSound("a.vtk", legacy());
  corpus.addSound("a.vtk", replaced(legacyStart, "BINARY", "ASCII") + goodText());
  corpus.addCuts("a.vtk", legacy(), legacy().size());
  for (const char* dims : {"0 3 4", "-2 3 4", "2 3"})
    addLegacy(corpus, "zero or negative size", "DIMENSIONS 2 3 4", std::string("DIMENSIONS ") + dims,
              {refused});
  for (const char* dims :
       {"2147483648 1 1", "2097152 2097152 2097152", "4294967296 4294967296 1", "1e300 3 4", "nan 3 4"})
    addLegacy(corpus, "oversized dimensions", "DIMENSIONS 2 3 4", std::string("DIMENSIONS ") + dims,
              {refused});
  for (const char* spacing : {"nan 3 4", "0 3 4", "inf 3 4", "1e-30 3 4", "1e30 3 4"})
    addLegacy(corpus, "spacing", "SPACING 2 3 4", std::string("SPACING ") + spacing, {refused});
  addLegacy(corpus, "spacing", "SPACING 2 3 4\n", "", {warned}, "Spacing unknown");
  addLegacy(corpus, "orientation", "10 20 30", "nan 0 0", {refused});
  addLegacy(corpus, "orientation", "10 20 30", "1e30 0 0", {refused});
  addLegacy(corpus, "contradiction", "POINT_DATA 24", "POINT_DATA 25", {refused}, "POINT_DATA");
  addLegacy(corpus, "contradiction", "POINT_DATA 24", "POINT_DATA -1", {refused});
  addLegacy(corpus, "contradiction", "short", "bit", {refused});
  for (const char* components : {"2", "9", "-1", "nan"})
    addLegacy(corpus, "vector or colour", "short 1", std::string("short ") + components, {refused});
  addLegacy(corpus, "vector or colour", "SCALARS values short 1\nLOOKUP_TABLE default", "VECTORS v short",
            {refused});
  for (const char* other : {"POLYDATA", "STRUCTURED_GRID", "UNSTRUCTURED_GRID", "RECTILINEAR_GRID", ""})
    addLegacy(corpus, "not an image", "STRUCTURED_POINTS", other, {refused});
  addLegacy(corpus, "wrong magic", "# vtk", "# vtq", {refused});
  corpus.addFile("contradiction", "a.vtk", legacy() + std::string(48, '\1'), {correct}); // another array
  corpus.addFile("contradiction", "a.vtk.gz", deflated(legacy()), {refused}, "gzip");
  corpus.addFile("endless or cyclic", "a.vtk", replaced(legacy(), "a title", std::string(1 << 20, 'x')),
                 {refused});
}

void addVtkXmlInputs(Corpus& corpus) {
  corpus.addSound("a.vti", textFile());
  corpus.addSound("a.vti", xml(array("binary", base64(lengths({48}) + goodVoxels()))) + end);
  const std::string appended = appendedFile(lengths({48}) + goodVoxels());
  corpus.addSound("a.vti", appended);
  const std::string packed = deflated(goodVoxels(), false);
  corpus.addSound(
      "a.vti",
      appendedFile(lengths({1, 48, 0, static_cast<std::uint32_t>(packed.size())}) + packed, "0", zlib));
  corpus.addCuts("a.vti", textFile(), textFile().size() - end.size() - 40);
  corpus.addCuts("a.vti", appended, appended.size() - end.size() - 15);
  addXmlNumbers(corpus);
  addXmlMeanings(corpus);
  addXmlArrays(corpus);
}

} // namespace limn::test
