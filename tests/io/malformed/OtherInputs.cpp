// SPDX-License-Identifier: GPL-3.0-or-later
// What is no volume of any format.
#include "Corpus.h"
#include "GoodBytes.h"
#include "io/NiftiBytes.h"

#include <sys/stat.h>

namespace limn::test {
namespace {

namespace fs = std::filesystem;
using enum Outcome;

void addSpecialFiles(Corpus& corpus) {
  const fs::path pipe = corpus.newFolder() / "a.nii";
  mkfifo(pipe.c_str(), 0600);
  corpus.add("not an image", pipe, {refused}, "no file");
  const fs::path folder = corpus.newFolder();
  mkfifo((folder / "a.dcm").c_str(), 0600);
  corpus.add("not an image", folder, {refused});
  for (const char* device : {"/dev/zero", "/dev/null", "/dev/random"})
    corpus.add("not an image", device, {refused});
  const fs::path loop = corpus.newFolder();
  fs::create_symlink("b.nii", loop / "a.nii");
  fs::create_symlink("a.nii", loop / "b.nii");
  corpus.add("endless or cyclic", loop / "a.nii", {refused});
  corpus.add("missing file", corpus.newFolder() / "none.nii", {refused});
  corpus.add("not an image", corpus.newFolder(), {refused});
}

void addTexts(Corpus& corpus) {
  corpus.addFile("not an image", "letter.doc", "Dear colleague, here is the volume.", {refused});
  corpus.addFile("not an image", "a.raw", goodVoxels(), {refused}, ".mhd");
  corpus.addFile("not an image", "a.zip", "PK\3\4" + std::string(500, '\0'), {refused});
  corpus.addFile("not an image", "a.pdf", "%PDF-1.7\n" + std::string(5000, ' '), {refused});
  corpus.addFile("not an image", "zeros", std::string(1 << 20, '\0'), {refused});
  corpus.addFile("decompression bomb", "a.gz", bomb("", 512, 31), {refused});
  corpus.addFile("wrong magic", "a\nb.nii", "no volume", {refused});
  corpus.addFile("wrong magic", std::string(200, 'n').append(".nii"), "no volume", {refused});
}

} // namespace

void addOtherInputs(Corpus& corpus) {
  NiftiFields fields;
  fields.pixdim = {1, 2, 3, 4, 0, 0, 0, 0};
  corpus.addSound("a.nii", niftiFile(fields, goodVoxels()));
  addSpecialFiles(corpus);
  addTexts(corpus);
}

} // namespace limn::test
