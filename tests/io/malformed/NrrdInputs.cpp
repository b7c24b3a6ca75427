// SPDX-License-Identifier: GPL-3.0-or-later
#include "Corpus.h"
#include "GoodBytes.h"

namespace limn::test {
namespace {

using enum Outcome;

const std::string nrrdStart =
    "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
    "space directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (10,20,30)\n"
    "kinds: domain domain domain\nendian: little\n";

std::string raw(const std::string& header = nrrdStart) {
  return header + "encoding: raw\n\n" + goodVoxels();
}

void addNrrdChanged(Corpus& corpus, const std::string& flaw, const std::string& from, const std::string& to,
                    const Outcomes& allowed, const std::string& says = "") {
  corpus.addFile(flaw, "a.nrrd", raw(replaced(nrrdStart, from, to)), allowed, says);
}

void addNrrdNumbers(Corpus& corpus) {
  for (const char* sizes : {"0 3 4", "-2 3 4", "2 3 -4", "2 3 0"})
    addNrrdChanged(corpus, "zero or negative size", "2 3 4", sizes, {refused}, "dimension");
  for (const char* sizes :
       {"2147483648 3 4", "2147483647 2147483647 2", "2097152 2097152 2097152", "4294967296 4294967296 1",
        "4611686018427387904 2 1", "1e300 3 4", "nan 3 4", "2.5 3 4", "99999999999999999999999 3 4"})
    addNrrdChanged(corpus, "oversized dimensions", "2 3 4", sizes, {refused});
  for (const char* directions :
       {"(nan,0,0)", "(inf,0,0)", "(0,0,0)", "(1e-200,0,0)", "(1e-30,0,0)", "(1e30,0,0)"})
    addNrrdChanged(corpus, "spacing", "(2,0,0)", directions, {refused});
  for (const char* directions : {"(0,3,0)", "(2,1,0)", "(0,0,2)"})
    addNrrdChanged(corpus, "orientation", "(2,0,0)", directions, {refused});
  for (const char* origin : {"(nan,0,0)", "(1e300,0,0)", "(1e30,0,0)"})
    addNrrdChanged(corpus, "orientation", "(10,20,30)", origin, {refused});
  const std::string plain = "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\n";
  for (const char* spacings : {"nan nan nan", "0 0 0", "2 3 inf"})
    corpus.addFile("spacing", "a.nrrd", raw(plain + "spacings: " + spacings + "\n"), {warned}, "Spacing");
  corpus.addFile("spacing", "a.nrrd", raw(plain + "spacings: 1e-30 1e-30 1e-30\n"), {refused}, "spacing");
}

void addNrrdMeanings(Corpus& corpus) {
  // A fourth axis of `size` moments.
  const auto series = [](const std::string& size) {
    return replaced(
        replaced(replaced(replaced(nrrdStart, "dimension: 3", "dimension: 4"), "2 3 4", "2 3 4 " + size),
                 "(0,0,4)", "(0,0,4) none"),
        "domain domain domain", "domain domain domain time");
  };
  corpus.addFile("4D", "a.nrrd", raw(series("2")) + goodVoxels(), {warned}, "2 volumes");
  corpus.addFile("4D", "a.nrrd", raw(series("2")), {warned, refused});
  corpus.addFile("4D", "a.nrrd", raw(series("2147483647")), {warned, refused});
  // The first of 2⁶⁴ volumes behind a byte skip of -1: an overflow would make them none.
  std::string all = replaced(nrrdStart, "domain domain domain", "domain domain domain time time time time");
  all = replaced(replaced(all, "dimension: 3", "dimension: 7"), "2 3 4", "2 3 4 65536 65536 65536 65536");
  all = replaced(all, "(0,0,4)", "(0,0,4) none none none none");
  corpus.addFile("oversized dimensions", "a.nrrd", raw(all + "byte skip: -1\n"), {refused});
  const std::string colour =
      replaced(replaced(replaced(nrrdStart, "dimension: 3", "dimension: 4"), "2 3 4", "3 2 3 4"),
               "domain domain", "RGB-color domain domain");
  corpus
      .addFile("vector or colour", "a.nrrd",
               raw(replaced(colour, "(2,0,0)", "none (2,0,0)")) + goodVoxels() + goodVoxels(), {warned},
               "colours")
      .hasGoodVoxels = false;
  const std::string tensor =
      replaced(replaced(colour, "3 2 3 4", "7 2 3 4"), "RGB-color", "3D-masked-symmetric-matrix");
  corpus.addFile("vector or colour", "a.nrrd", raw(replaced(tensor, "(2,0,0)", "none (2,0,0)")), {refused});
  addNrrdChanged(corpus, "contradiction", "dimension: 3", "dimension: 2", {refused});
  addNrrdChanged(corpus, "contradiction", "dimension: 3", "dimension: 3000000000", {refused});
  addNrrdChanged(corpus, "contradiction", "type: short", "type: block", {refused});
  addNrrdChanged(corpus, "contradiction", "endian: little\n", "", {refused}, "byte order");
  addNrrdChanged(corpus, "contradiction", "sizes: 2 3 4\n", "", {refused});
  corpus.addFile("contradiction", "a.nrrd", raw() + std::string(48, '\1'), {warned}, "more");
}

void addNrrdDetached(Corpus& corpus, const std::string& flaw, const std::string& name,
                     const std::string& says) {
  const auto folder = corpus.newFolder();
  writeBytes(folder / "a.nhdr", nrrdStart + "encoding: raw\ndata file: " + name + "\n\n");
  corpus.add(flaw, folder / "a.nhdr", {refused}, says);
}

void addNrrdFiles(Corpus& corpus) {
  corpus.addFile("wrong magic", "a.nrrd", replaced(raw(), "NRRD0004", "NRRX0004"), {refused});
  addNrrdDetached(corpus, "missing file", "a.raw", "a.raw");
  for (const char* name :
       {"../../../../../../../../../etc/passwd", "/etc/passwd", "./../x/../../a.raw", "x/../../a.raw", ".."})
    addNrrdDetached(corpus, "path traversal", name, "not in the folder");
  addNrrdDetached(corpus, "endless or cyclic", "a.nhdr", "itself");
  addNrrdDetached(corpus, "endless or cyclic", ".", "");
  const auto folder = corpus.newFolder();
  writeBytes(folder.parent_path() / "secret.raw", goodVoxels());
  std::filesystem::create_symlink(folder.parent_path() / "secret.raw", folder / "a.raw");
  writeBytes(folder / "a.nhdr", nrrdStart + "encoding: raw\ndata file: a.raw\n\n");
  corpus.add("path traversal", folder / "a.nhdr", {refused}, "out of the folder");
  const auto loop = corpus.newFolder();
  std::filesystem::create_symlink("b.raw", loop / "a.raw");
  std::filesystem::create_symlink("a.raw", loop / "b.raw");
  writeBytes(loop / "a.nhdr", nrrdStart + "encoding: raw\ndata file: a.raw\n\n");
  corpus.add("endless or cyclic", loop / "a.nhdr", {refused}, "a.raw");

  const std::string gz = nrrdStart + "encoding: gzip\n";
  corpus.addFile("decompression bomb", "a.nrrd", gz + "\n" + bomb(goodVoxels(), 512, 31), {warned}, "more");
  corpus.addFile("decompression bomb", "a.nrrd", gz + "byte skip: 999999999999\n\n" + bomb("", 512, 31),
                 {refused});
  corpus.addFile("decompression bomb", "a.nrrd",
                 replaced(gz, "2 3 4", "1024 1024 512") + "\n" + bomb("", 64, 31), {refused});
  corpus.addFile("decompression bomb", "a.nrrd", replaced(gz, "2 3 4", "1024 1024 512") + "\n" + deflated(""),
                 {refused});
  corpus.addFile("endless or cyclic", "a.nrrd",
                 nrrdStart + "encoding: raw\nline skip: 1e18\n\n" + goodVoxels(), {refused});
  corpus.addFile("contradiction", "a.nrrd.gz", deflated(raw()), {refused}, "gzip");
  corpus.addFile("contradiction", "a.nrrd", nrrdStart + "encoding: raw\nbyte skip: -7\n\n" + goodVoxels(),
                 {refused});
  std::string text = goodText();
  const std::string ascii = nrrdStart + "encoding: ascii\n\n";
  corpus.addFile("truncated", "a.nrrd", ascii + text.substr(0, text.size() - 2), {warned}, "cut off")
      .hasGoodVoxels = false;
  corpus.addFile("contradiction", "a.nrrd", ascii + replaced(text, "7\n", "7-"), {refused});
  corpus.addFile("contradiction", "a.nrrd", ascii + replaced(text, "7\n", "70000\n"), {refused});
}

} // namespace

void addNrrdInputs(Corpus& corpus) {
  corpus.addSound("a.nrrd", raw());
  const std::string gzip = nrrdStart + "encoding: gzip\n\n" + deflated(goodVoxels());
  corpus.addSound("a.nrrd", gzip);
  corpus.addSound("a.nrrd", nrrdStart + "encoding: ascii\n\n" + goodText());
  const auto folder = corpus.newFolder();
  writeBytes(folder / "a.nhdr", nrrdStart + "encoding: raw\ndata file: a.raw\n\n");
  writeBytes(folder / "a.raw", goodVoxels());
  corpus.add("sound", folder / "a.nhdr", {correct});
  corpus.addCuts("a.nrrd", raw(), raw().size());
  corpus.addCuts("a.nrrd", gzip, gzip.size() - 12);
  addNrrdNumbers(corpus);
  addNrrdMeanings(corpus);
  addNrrdFiles(corpus);
}

} // namespace limn::test
