// SPDX-License-Identifier: GPL-3.0-or-later
#include "Corpus.h"
#include "GoodBytes.h"

#include "io/NiftiBytes.h"

#include <cmath>
#include <limits>

namespace limn::test {
namespace {

using enum Outcome;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A file placed by its sform, in millimetres.
NiftiFields placed(int version = 1) {
  NiftiFields fields;
  fields.version = version;
  fields.sformCode = 1;
  fields.rows = {2, 0, 0, 10, 0, 3, 0, 20, 0, 0, 4, 30};
  return fields;
}

std::string fileOf(const NiftiFields& fields) {
  return niftiFile(fields, goodVoxels());
}

NiftiFields withSpacing(double x, double y, double z) {
  NiftiFields fields;
  fields.pixdim = {1, x, y, z, 0, 0, 0, 0};
  return fields;
}

void addNiftiSizes(Corpus& corpus) {
  for (const int size : {0, -1, -32768}) {
    NiftiFields fields = placed();
    fields.dim[2] = size;
    corpus.addFile("zero or negative size", "a.nii", fileOf(fields), {refused}, "dimension");
  }
  for (const int count : {-1, 0, 1, 8, 300}) {
    NiftiFields fields = placed();
    fields.dim[0] = count;
    corpus.addFile("zero or negative size", "a.nii", fileOf(fields), {refused}, "dimensions");
  }
  NiftiFields large = placed();
  large.dim = {3, 32767, 32767, 32767, 1, 1, 1, 1};
  corpus.addFile("oversized dimensions", "a.nii", fileOf(large), {refused});
  corpus.addFile("oversized dimensions", "a.nii.gz", deflated(fileOf(large)), {refused});
  // Products of 2³¹, 2⁶³ and 2⁶⁴, which overflow 32 and 64 bits.
  for (const auto& [x, y, z] :
       {std::array{1LL << 31, 1LL, 1LL}, std::array{1LL << 21, 1LL << 21, 1LL << 21},
        std::array{1LL << 32, 1LL << 32, 1LL}, std::array{(1LL << 62) + 2, 3LL, 4LL}}) {
    std::string bytes = fileOf(placed(2));
    bytes.replace(24, 24,
                  littleEndian(static_cast<std::uint64_t>(x), 8) +
                      littleEndian(static_cast<std::uint64_t>(y), 8) +
                      littleEndian(static_cast<std::uint64_t>(z), 8));
    corpus.addFile("oversized dimensions", "a.nii", bytes, {refused});
  }
}

void addNiftiPlaces(Corpus& corpus) {
  for (const double bad : {0.0, nan, infinity})
    corpus.addFile("spacing", "a.nii", fileOf(withSpacing(2, bad, 4)), {warned}, "Spacing unknown");
  for (const double bad : {1e-30, 1e30})
    corpus.addFile("spacing", "a.nii", fileOf(withSpacing(2, bad, 4)), {refused}, "spacing");
  NiftiFields flat = placed();
  flat.rows = {2, 2, 0, 10, 0, 0, 0, 20, 0, 0, 4, 30};
  corpus.addFile("orientation", "a.nii", fileOf(flat), {warned}, "sform");
  NiftiFields sheared = placed();
  sheared.rows = {2, 1, 0, 10, 0, 3, 0, 20, 0, 0, 4, 30};
  corpus.addFile("orientation", "a.nii", fileOf(sheared), {refused}, "sheared");
  NiftiFields undefined = placed();
  undefined.rows[0] = nan;
  corpus.addFile("orientation", "a.nii", fileOf(undefined), {warned}, "sform");
  NiftiFields away = placed();
  away.rows[3] = 1e30;
  corpus.addFile("orientation", "a.nii", fileOf(away), {refused}, "mm away");
  NiftiFields turned;
  turned.qformCode = 1;
  turned.quaternion = {3, 4, 5}; // no rotation: longer than 1
  corpus.addFile("orientation", "a.nii", fileOf(turned), {warned}, "qform");
  turned.quaternion = {nan, 0, 0};
  corpus.addFile("orientation", "a.nii", fileOf(turned), {warned}, "qform");
}

void addNiftiMeanings(Corpus& corpus) {
  NiftiFields series = placed();
  series.dim = {4, 2, 3, 4, 5, 1, 1, 1};
  std::string five;
  for (int i = 0; i < 5; ++i)
    five += goodVoxels();
  corpus.addFile("4D", "a.nii", niftiFile(series, five), {warned}, "5 volumes");
  corpus.addFile("4D", "a.nii.gz", deflated(niftiFile(series, five)), {warned}, "5 volumes");
  corpus.addFile("4D", "a.nii", niftiFile(series, goodVoxels()), {warned, refused}, "volumes");
  series.dim = {7, 2, 3, 4, 32767, 32767, 32767, 32767};
  corpus.addFile("4D", "a.nii", niftiFile(series, goodVoxels()), {warned, refused});
  series.version = 2;
  series.dim = {7, 2, 3, 4, 2147483647, 2147483647, 2147483647, 2147483647};
  corpus.addFile("4D", "a.nii", niftiFile(series, goodVoxels()), {warned, refused});

  NiftiFields colour = placed();
  colour.datatype = 128;
  corpus.addFile("vector or colour", "a.nii", niftiFile(colour, std::string(72, '\7')), {warned}, "colours")
      .hasGoodVoxels = false;
  NiftiFields complex = placed();
  complex.datatype = 32;
  corpus.addFile("vector or colour", "a.nii", niftiFile(complex, std::string(192, '\7')), {refused},
                 "complex");
  for (const auto& [slope, intercept] : {std::array{infinity, 0.0}, std::array{2.0, nan}}) {
    NiftiFields scaled = placed();
    scaled.slope = slope;
    scaled.intercept = intercept;
    corpus.addFile("contradiction", "a.nii", fileOf(scaled), {warned}, "scaling");
  }
  NiftiFields huge = placed();
  huge.datatype = 64;
  huge.slope = 1e30;
  corpus.addFile("contradiction", "a.nii", niftiFile(huge, bytesOf(std::vector<double>(24, 1e300))),
                 {refused}, "finite");
  std::string bits = fileOf(placed());
  bits.replace(72, 2, littleEndian(8, 2)); // bitpix of 8 for int16
  corpus.addFile("contradiction", "a.nii", bits, {refused}, "bits");
  corpus.addFile("contradiction", "a.nii", fileOf(placed()) + std::string(48, '\1'), {warned}, "more");
  corpus.addFile("contradiction", "a.nii.gz", deflated(fileOf(placed()) + std::string(48, '\1')), {warned},
                 "more");
}

void addNiftiFiles(Corpus& corpus) {
  std::string magic = fileOf(placed());
  magic.replace(344, 4, "n+9\0", 4);
  corpus.addFile("wrong magic", "a.nii", magic, {refused});
  corpus.addFile("wrong magic", "a.nii", replaced(fileOf(placed()), std::string("\x5c\1", 2), "\x5d\1"),
                 {refused});
  corpus.addFile("wrong magic", "a.nii.gz", fileOf(placed()), {correct}); // not compressed at all
  corpus.addFile("wrong magic", "a.nii.gz", "\x1f\x8b\x08 and then no gzip", {refused});
  NiftiFields pair = placed();
  pair.isPair = true;
  corpus.addFile("missing file", "a.hdr", NiftiWriter(pair).bytes(), {refused}, "a.img");
  const auto folder = corpus.newFolder();
  writeBytes(folder / "a.hdr", NiftiWriter(pair).bytes());
  writeBytes(folder / "a.img", goodVoxels().substr(0, 40));
  corpus.add("truncated", folder / "a.hdr", {refused});
  const auto alone = corpus.newFolder();
  writeBytes(alone / "a.img", goodVoxels());
  corpus.add("missing file", alone / "a.img", {refused}, "a.hdr");

  NiftiFields large = placed();
  large.dim = {3, 1024, 1024, 512, 1, 1, 1, 1};
  const std::string start = niftiFile(large, "");
  corpus.addFile("decompression bomb", "a.nii.gz", bomb(start, 64, 31), {refused});
  corpus.addFile("decompression bomb", "a.nii.gz", bomb(fileOf(placed()), 512, 31), {warned}, "more");
  for (const double offset : {1e9, 1e12, -1e9, nan, 7.0}) {
    std::string bytes = fileOf(placed());
    bytes.replace(108, 4, bytesOf(std::vector<float>{static_cast<float>(offset)}));
    corpus.addFile("decompression bomb", "a.nii.gz", bomb(bytes, 512, 31), {refused});
    corpus.addFile("contradiction", "a.nii", bytes, {refused});
  }
  std::string members = deflated(fileOf(placed()).substr(0, 100));
  for (int i = 0; i < 20000; ++i)
    members += deflated("");
  corpus.addFile("endless or cyclic", "a.nii.gz", members, {refused});
}

} // namespace

void addNiftiInputs(Corpus& corpus) {
  const std::string good = fileOf(placed());
  corpus.addSound("a.nii", good);
  corpus.addSound("a.nii.gz", deflated(good));
  corpus.addSound("a.nii", fileOf(placed(2)));
  NiftiFields pair = placed();
  pair.isPair = true;
  const auto folder = corpus.newFolder();
  writeBytes(folder / "a.hdr", NiftiWriter(pair).bytes());
  writeBytes(folder / "a.img", goodVoxels());
  corpus.add("sound", folder / "a.hdr", {correct});
  corpus.addCuts("a.nii", good, good.size());
  const std::string packed = deflated(good);
  corpus.addCuts("a.nii.gz", packed, packed.size() - 12);
  addNiftiSizes(corpus);
  addNiftiPlaces(corpus);
  addNiftiMeanings(corpus);
  addNiftiFiles(corpus);
}

} // namespace limn::test
