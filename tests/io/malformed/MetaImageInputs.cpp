// SPDX-License-Identifier: GPL-3.0-or-later
#include "Corpus.h"
#include "GoodBytes.h"

namespace limn::test {
namespace {

using enum Outcome;

const std::string metaImageStart =
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 2 3 4\n"
    "ElementType = MET_SHORT\nElementSpacing = 2 3 4\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
    "Offset = 10 20 30\n";

std::string local(const std::string& header = metaImageStart) {
  return header + "ElementDataFile = LOCAL\n" + goodVoxels();
}

void addMetaImageChanged(Corpus& corpus, const std::string& flaw, const std::string& from,
                         const std::string& to, const Outcomes& allowed, const std::string& says = "") {
  corpus.addFile(flaw, "a.mha", local(replaced(metaImageStart, from, to)), allowed, says);
}

void addMetaImageNumbers(Corpus& corpus) {
  for (const char* size : {"0 3 4", "-2 3 4", "2 3"})
    addMetaImageChanged(corpus, "zero or negative size", "DimSize = 2 3 4", std::string("DimSize = ") + size,
                        {refused});
  for (const char* size : {"2147483648 3 4", "2147483647 2147483647 2147483647", "2097152 2097152 2097152",
                           "4294967296 4294967296 1", "1e400 3 4", "nan 3 4"})
    addMetaImageChanged(corpus, "oversized dimensions", "DimSize = 2 3 4", std::string("DimSize = ") + size,
                        {refused});
  for (const char* count : {"nan", "2.5", "-3", "0", "1e30", "9"})
    addMetaImageChanged(corpus, "oversized dimensions", "NDims = 3", std::string("NDims = ") + count,
                        {refused});
  for (const char* spacing : {"0 3 4", "nan 3 4", "inf 3 4", "1e-30 3 4", "2 3 1e30"})
    addMetaImageChanged(corpus, "spacing", "ElementSpacing = 2 3 4",
                        std::string("ElementSpacing = ") + spacing, {refused});
  for (const char* matrix : {"1 0 0 1 0 0 0 0 1", "0 0 0 0 0 0 0 0 0", "nan 0 0 0 1 0 0 0 1",
                             "1 0 0 0.5 1 0 0 0 1", "1 0 0 0 1 0 0 0"})
    addMetaImageChanged(corpus, "orientation", "1 0 0 0 1 0 0 0 1", matrix, {refused});
  for (const char* offset : {"nan 0 0", "1e300 0 0", "1e30 0 0"})
    addMetaImageChanged(corpus, "orientation", "10 20 30", offset, {refused});
}

void addMetaImageMeanings(Corpus& corpus) {
  const std::string series =
      replaced(replaced(replaced(replaced(replaced(metaImageStart, "NDims = 3", "NDims = 4"),
                                          "DimSize = 2 3 4", "DimSize = 2 3 4 2"),
                                 "Spacing = 2 3 4", "Spacing = 2 3 4 1"),
                        "1 0 0 0 1 0 0 0 1", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"),
               "10 20 30", "10 20 30 0");
  corpus.addFile("4D", "a.mha", local(series) + goodVoxels(), {warned}, "2 volumes");
  corpus.addFile("4D", "a.mha", local(series), {warned, refused});
  corpus.addFile("4D", "a.mha", local(replaced(series, "3 4 2\n", "3 4 2147483647\nHeaderSize = -1\n")),
                 {refused});
  for (const char* channels : {"2", "5", "-1", "nan", "0", "4294967297"})
    addMetaImageChanged(corpus, "vector or colour", "NDims",
                        std::string("ElementNumberOfChannels = ") + channels + "\nNDims", {refused});
  corpus
      .addFile("vector or colour", "a.mha",
               local(replaced(metaImageStart, "NDims", "ElementNumberOfChannels = 3\nNDims")) + goodVoxels() +
                   goodVoxels(),
               {warned}, "colours")
      .hasGoodVoxels = false;
  addMetaImageChanged(corpus, "contradiction", "MET_SHORT", "MET_STRING", {refused});
  for (const char* slope : {"nan", "inf", "1e400"})
    addMetaImageChanged(corpus, "contradiction", "NDims",
                        std::string("ElementToIntensityFunctionSlope = ") + slope + "\nNDims", {refused});
  corpus.addFile("contradiction", "a.mha", local() + std::string(48, '\1'), {warned}, "more");
  corpus.addFile("contradiction", "a.mha.gz", deflated(local()), {refused}, "gzip");
  for (const char* size : {"-7", "nan", "1e300", "0.5"})
    addMetaImageChanged(corpus, "contradiction", "NDims", std::string("HeaderSize = ") + size + "\nNDims",
                        {refused});
}

void addMetaImageDetached(Corpus& corpus, const std::string& flaw, const std::string& name,
                          const std::string& says) {
  const auto folder = corpus.newFolder();
  writeBytes(folder / "a.mhd", metaImageStart + "ElementDataFile = " + name + "\n");
  corpus.add(flaw, folder / "a.mhd", {refused}, says);
}

void addMetaImageFiles(Corpus& corpus) {
  corpus.addFile("wrong magic", "a.mha", replaced(local(), "ObjectType", "ObjectTipe"), {refused});
  addMetaImageDetached(corpus, "missing file", "a.raw", "a.raw");
  addMetaImageDetached(corpus, "missing file", "LIST", "several files");
  addMetaImageDetached(corpus, "missing file", "slice%03d.raw 1 4 1", "several files");
  for (const char* name : {"../../../../../../../../../etc/passwd", "/etc/passwd", "x/../../a.raw"})
    addMetaImageDetached(corpus, "path traversal", name, "not in the folder");
  addMetaImageDetached(corpus, "endless or cyclic", "a.mhd", "itself");
  const auto folder = corpus.newFolder();
  writeBytes(folder.parent_path() / "secret.raw", goodVoxels());
  std::filesystem::create_symlink(folder.parent_path() / "secret.raw", folder / "a.raw");
  writeBytes(folder / "a.mhd", metaImageStart + "ElementDataFile = a.raw\n");
  corpus.add("path traversal", folder / "a.mhd", {refused}, "out of the folder");

  const std::string packed = metaImageStart + "CompressedData = True\n";
  const std::string end = "ElementDataFile = LOCAL\n";
  corpus.addFile("decompression bomb", "a.mha", packed + end + bomb(goodVoxels(), 512, 15), {warned}, "more");
  corpus.addFile("decompression bomb", "a.mha",
                 replaced(packed, "DimSize = 2 3 4", "DimSize = 1024 1024 512") + end + bomb("", 64, 15),
                 {refused});
  corpus.addFile("decompression bomb", "a.mha",
                 replaced(packed, "BinaryData = True", "BinaryData = False") + end + bomb("1 2 3 ", 1024, 15),
                 {refused});
  corpus.addFile("wrong magic", "a.mha", packed + end + goodVoxels(), {refused});
  const std::string text = replaced(metaImageStart, "BinaryData = True", "BinaryData = False") + end;
  corpus
      .addFile("truncated", "a.mha", text + goodText().substr(0, goodText().size() - 2), {warned}, "cut off")
      .hasGoodVoxels = false;
  std::string header = metaImageStart;
  for (int i = 0; i < 100000; ++i)
    header += "Field" + std::to_string(i) + " = 1\n";
  corpus.addFile("endless or cyclic", "a.mha", local(header), {refused});
}

} // namespace

void addMetaImageInputs(Corpus& corpus) {
  corpus.addSound("a.mha", local());
  const std::string packed =
      metaImageStart + "CompressedData = True\nElementDataFile = LOCAL\n" + deflated(goodVoxels(), false);
  corpus.addSound("a.mha", packed);
  corpus.addSound("a.mha", replaced(metaImageStart, "BinaryData = True", "BinaryData = False") +
                               "ElementDataFile = LOCAL\n" + goodText());
  const auto folder = corpus.newFolder();
  writeBytes(folder / "a.mhd", metaImageStart + "ElementDataFile = a.raw\n");
  writeBytes(folder / "a.raw", goodVoxels());
  corpus.add("sound", folder / "a.mhd", {correct});
  corpus.addCuts("a.mha", local(), local().size());
  corpus.addCuts("a.mha", packed, packed.size() - 12);
  addMetaImageNumbers(corpus);
  addMetaImageMeanings(corpus);
  addMetaImageFiles(corpus);
}

} // namespace limn::test
