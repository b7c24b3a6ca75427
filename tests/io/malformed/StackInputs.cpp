// SPDX-License-Identifier: GPL-3.0-or-later
// Stacks of pictures in a folder: PNG and JPEG.
#include "Attempt.h"
#include "PictureBytes.h"

#include "io/ImageFile.h"
#include "io/openimageio/PictureLibrary.h"

#include <algorithm>

namespace limn::test {
namespace {

namespace fs = std::filesystem;
using enum Outcome;

// A folder of the good slices, the one at `number` replaced.
fs::path pngStack(Corpus& corpus, int number = -1, const std::string& bytes = "") {
  const fs::path folder = corpus.newFolder();
  for (int k = 0; k < 4; ++k)
    writeBytes(folder / ("slice" + std::to_string(k) + ".png"), k == number ? bytes : goodPng(k));
  return folder;
}

MalformedInput& addPng(Corpus& corpus, const std::string& flaw, const std::string& bytes,
                       const Outcomes& allowed, const std::string& says = "") {
  return corpus.add(flaw, pngStack(corpus, 2, bytes), allowed, says);
}

// The slices of a folder replaced by one picture each.
MalformedInput& addAll(Corpus& corpus, const std::string& flaw, const std::string& bytes,
                       const Outcomes& allowed) {
  const fs::path folder = corpus.newFolder();
  for (const char* name : {"1.png", "2.png"})
    writeBytes(folder / name, bytes);
  return corpus.add(flaw, folder, allowed);
}

void addPngSizes(Corpus& corpus) {
  const std::string rows = deflated(std::string(9, '\0'), false);
  for (const std::uint32_t size : {0u, 65535u, 0x7fffffffu, 0x80000000u, 0xffffffffu}) {
    const std::string flaw = size == 0 ? "zero or negative size" : "oversized dimensions";
    addPng(corpus, flaw, pngOf(size, 3, 8, 0, rows), {refused});
    addAll(corpus, flaw, pngOf(size, 3, 8, 0, rows), {refused});
    addAll(corpus, flaw, pngOf(size, size, 16, 6, rows), {refused});
  }
  addPng(corpus, "slices of different size", pngOf(3, 2, 8, 0, deflated(std::string(8, '\0'), false)),
         {refused}, "another size");
  addPng(corpus, "slices of different size", pngOf(2, 3, 16, 0, deflated(std::string(15, '\0'), false)),
         {refused}, "another");
  addPng(corpus, "mixed series", pngOf(2, 3, 8, 2, deflated(std::string(21, '\0'), false)), {refused},
         "another");
  addPng(corpus, "contradiction", pngOf(2, 3, 7, 0, rows), {refused});
  addPng(corpus, "contradiction", pngOf(2, 3, 8, 5, rows), {refused});
  addPng(corpus, "contradiction", pngOf(2, 3, 8, 0, deflated(std::string(5, '\0'), false)), {refused});
  addPng(corpus, "contradiction", pngOf(2, 3, 8, 0, deflated(std::string(9, '\7'), false)), {refused});
  std::string sum = goodPng(2);
  sum[sum.size() - 14] ^= 1; // the check sum of the pixels
  addPng(corpus, "contradiction", sum, {refused});
}

void addPngBombs(Corpus& corpus) {
  addAll(corpus, "decompression bomb", pngOf(16384, 16384, 8, 0, bomb("", 64, 15)), {refused}).heldBytes =
      64u << 20;
  addAll(corpus, "decompression bomb", pngOf(16384, 16384, 16, 6, bomb("", 64, 15)), {refused}).heldBytes =
      64u << 20;
  const std::string rows("\0\14\15\0\16\17\0\20\21", 9); // of the third slice
  addPng(corpus, "decompression bomb", pngOf(2, 3, 8, 0, bomb(rows, 512, 15)), {correct, refused});
  const std::string text = pngChunk("zTXt", std::string("Comment\0\0", 9) + bomb("", 512, 15));
  addPng(corpus, "decompression bomb", pngOf(2, 3, 8, 0, deflated(rows, false), text), {correct, refused});
  const std::string profile = pngChunk("iCCP", std::string("profile\0\0", 9) + bomb("", 512, 15));
  addPng(corpus, "decompression bomb", pngOf(2, 3, 8, 0, deflated(rows, false), profile), {correct, refused});
}

void addPngFolders(Corpus& corpus) {
  fs::path folder = pngStack(corpus);
  fs::remove(folder / "slice1.png");
  corpus.add("missing slices", folder, {warned}, "slices may be missing").becomesAnother();
  folder = pngStack(corpus);
  fs::create_symlink("b.png", folder / "a.png");
  fs::create_symlink("a.png", folder / "b.png");
  corpus.add("endless or cyclic", folder, {correct});
  folder = pngStack(corpus);
  fs::create_directory_symlink(".", folder / "again");
  corpus.add("endless or cyclic", folder, {correct});
  folder = pngStack(corpus);
  writeBytes(folder / "slice4.tif", goodTiff());
  corpus.add("mixed series", folder, {refused});
  folder = pngStack(corpus);
  writeBytes(folder / "note.txt", "no picture");
  corpus.add("not an image", folder, {correct});
  corpus.addFile("not an image", "one.png", goodPng(0), {refused}, "single picture");
  addPng(corpus, "wrong magic", "\x89PNX" + goodPng(2).substr(4), {refused}, "slice2.png");
}

// The bytes of a JPEG picture, made in a process of its own because the library starts threads.
std::string jpegBytes(const fs::path& folder) {
  const fs::path file = folder / "made.jpg";
  inChild([&](const auto&) {
    Image image({2, 3});
    for (glm::vec4& pixel : image.pixels)
      pixel = {0.5f, 0.5f, 0.5f, 1.0f};
    writeImage(file, image, glm::dvec3(0.0), "");
  });
  const std::string bytes = bytesOfFile(file);
  fs::remove(file);
  return bytes;
}

void addJpeg(Corpus& corpus, const std::string& flaw, const std::string& good, const std::string& bytes,
             const Outcomes& allowed) {
  const fs::path folder = corpus.newFolder();
  for (int k = 0; k < 4; ++k)
    writeBytes(folder / (std::to_string(k) + ".jpg"), k == 2 ? bytes : good);
  corpus.add(flaw, folder, allowed).hasGoodVoxels = false;
}

} // namespace

void addPngInputs(Corpus& corpus) {
  pictureLibrary(); // or each attempt's process would load its two hundred libraries anew
  corpus.add("sound", pngStack(corpus), {correct});
  const std::string good = goodPng(2);
  for (std::size_t length = 1; length < good.size(); length += 2)
    addPng(corpus, "truncated", good.substr(0, length),
           length < good.size() - 16 ? Outcomes{refused} : anyOutcome,
           length < good.size() - 16 ? "slice2.png" : "");
  addPng(corpus, "truncated", "", {refused}, "slice2.png: the file is empty");
  corpus.add("truncated", pngStack(corpus, 3), {refused}, "slice3.png: the file is empty");
  addPngSizes(corpus);
  addPngBombs(corpus);
  addPngFolders(corpus);
}

void addJpegInputs(Corpus& corpus) {
  const std::string good = jpegBytes(corpus.newFolder());
  addJpeg(corpus, "sound", good, good, {correct});
  for (std::size_t i = 1; i < 40; ++i)
    addJpeg(corpus, "truncated", good, good.substr(0, std::max<std::size_t>(good.size() * i / 40, 4)),
            {refused});
  const std::size_t frame = good.find("\xff\xc0");
  for (const std::uint16_t size : {std::uint16_t{0}, std::uint16_t{65500}}) {
    std::string changed = good;
    changed.replace(frame + 5, 2, bigEndian(size, 2));
    const std::string flaw = size == 0 ? "zero or negative size" : "oversized dimensions";
    addJpeg(corpus, flaw, good, changed, {refused});
    changed.replace(frame + 7, 2, bigEndian(size, 2));
    addJpeg(corpus, flaw, good, changed, {refused});
    addJpeg(corpus, flaw, changed, changed, {refused});
    // As large as the header may promise for its length.
    addJpeg(corpus, flaw, changed + std::string(600000, '\0') + "\xff\xd9", changed, {refused});
  }
  addJpeg(corpus, "wrong magic", good, "\xff\xd8\xff" + std::string(200, 'x') + "\xff\xd9", {refused});
  // Comments without end, and tables that are used but never given.
  std::string comments = good.substr(0, 2);
  for (int i = 0; i < 200000; ++i)
    comments += std::string("\xff\xfe\0\2", 4);
  addJpeg(corpus, "endless or cyclic", good, comments + good.substr(2), {correct, refused});
  const std::size_t table = good.find("\xff\xc4");
  std::string without = good;
  without[table + 1] = '\xfe';
  addJpeg(corpus, "contradiction", good, without, anyOutcome);
}

} // namespace limn::test
