// SPDX-License-Identifier: GPL-3.0-or-later
#include "Corpus.h"
#include "PictureBytes.h"

namespace limn::test {
namespace {

using enum Outcome;

// The good volume with one entry of its second page changed.
std::string changed(std::uint16_t tag, const TiffPage::Entry& entry) {
  std::vector<TiffPage> pages;
  for (int number = 0; number < 4; ++number)
    pages.push_back(goodPage(number));
  pages[1].entries[tag] = entry;
  return tiffOf(pages);
}

// All pages with one entry changed.
std::string changedAll(std::uint16_t tag, const TiffPage::Entry& entry, bool isDeflated = false) {
  std::vector<TiffPage> pages;
  for (int number = 0; number < 4; ++number) {
    pages.push_back(goodPage(number, isDeflated));
    pages.back().entries[tag] = entry;
  }
  return tiffOf(pages);
}

void addTiffSizes(Corpus& corpus) {
  for (const std::uint16_t tag : {256, 257})
    for (const std::uint32_t size : {0u, 65535u, 0x7fffffffu, 0x80000000u, 0xffffffffu}) {
      const std::string flaw = size == 0 ? "zero or negative size" : "oversized dimensions";
      corpus.addFile(flaw, "a.tif", changed(tag, {4, 1, size}), {refused});
      corpus.addFile(flaw, "a.tif", changedAll(tag, {4, 1, size}), {refused});
    }
  corpus.addFile("slices of different size", "a.tif", changed(256, {3, 1, 1}), {refused}, "another size");
  corpus.addFile("slices of different size", "a.tif", changed(257, {3, 1, 2}), {refused}, "another size");
  corpus.addFile("slices of different size", "a.tif", changed(258, {3, 1, 8}), {refused}, "another");
}

void addChains(Corpus& corpus) {
  const std::vector<TiffPage> pages = {goodPage(0), goodPage(1), goodPage(2), goodPage(3)};
  for (int next = 0; next < 4; ++next)
    corpus.addFile("endless or cyclic", "a.tif", tiffOf(pages, next), {refused}, "pages");
  // A long ring, whose pages each hold as many entries as fit.
  std::vector<TiffPage> ring;
  for (int number = 0; number < 200; ++number)
    ring.push_back(goodPage(0));
  for (std::uint16_t tag = 1000; tag < 2000; ++tag)
    ring.back().entries[tag] = {3, 1, 0};
  corpus.addFile("endless or cyclic", "a.tif", tiffOf(ring, 0), {refused}, "pages");
  // A thousand pages that all claim one list of a million strips.
  std::vector<TiffPage> shared(1000, goodPage(0));
  for (TiffPage& page : shared) {
    page.entries[273] = {4, 1000000, 1u << 16};
    page.entries[279] = {4, 1000000, 1u << 16};
  }
  corpus.addFile("endless or cyclic", "a.tif", tiffOf(shared) + std::string(4000000, '\0'), {refused},
                 "pages");
  std::string beyond = goodTiff();
  beyond.replace(4, 4, littleEndian(0x7ffffff0, 4));
  corpus.addFile("endless or cyclic", "a.tif", beyond, {refused});
}

void addPictures(Corpus& corpus) {
  corpus.addFile("contradiction", "a.tif", changed(273, {4, 1, 0x7fffffff}), {refused});
  corpus.addFile("contradiction", "a.tif", changed(279, {4, 1, 0x7fffffff}), {refused});
  corpus.addFile("contradiction", "a.tif", changedAll(279, {4, 1, 1}), {refused});
  corpus.addFile("contradiction", "a.tif", changedAll(278, {4, 1, 0}), anyOutcome);
  for (const std::uint32_t scheme : {0u, 2u, 5u, 7u, 8u, 32773u, 34712u, 65535u})
    corpus.addFile("contradiction", "a.tif", changedAll(259, {3, 1, scheme}), {refused});
  for (const std::uint32_t bits : {0u, 3u, 17u, 64u, 65535u})
    corpus.addFile("contradiction", "a.tif", changedAll(258, {3, 1, bits}), {refused});
  for (const std::uint32_t samples : {0u, 3u, 65535u})
    corpus.addFile("vector or colour", "a.tif", changedAll(277, {3, 1, samples}), {refused});
  corpus.addFile("not an image", "a.tif", tiffOf({goodPage(0)}), {refused}, "single picture");
  corpus.addFile("wrong magic", "a.tif", "IJ" + goodTiff().substr(2), {refused});
  corpus.addFile("wrong magic", "a.tif", "MM" + goodTiff().substr(2), {refused});
  // Two pages of 16384² pixels, deflated to 64 MiB of zeros only.
  std::vector<TiffPage> vast(2, goodPage(0, true));
  for (TiffPage& page : vast) {
    page.picture = bomb("", 64, 15);
    page.entries[256] = page.entries[257] = page.entries[278] = {4, 1, 16384};
    page.entries[279] = {4, 1, static_cast<std::uint32_t>(page.picture.size())};
  }
  corpus.addFile("decompression bomb", "a.tif", tiffOf(vast), {refused}).heldBytes = 64u << 20;
  // A strip of 3 pixels' rows that inflates to 512 MiB.
  std::vector<TiffPage> surplus = {goodPage(0, true), goodPage(1, true), goodPage(2, true),
                                   goodPage(3, true)};
  surplus[3].picture = bomb(bytesOf(std::vector<std::uint16_t>{18, 19, 20, 21, 22, 23}), 512, 15);
  surplus[3].entries[279] = {4, 1, static_cast<std::uint32_t>(surplus[3].picture.size())};
  corpus.addFile("decompression bomb", "a.tif", tiffOf(surplus), {correct, refused});
  // A strip that does not inflate: what the library says of it reaches the sentence.
  std::vector<TiffPage> spoilt = {goodPage(0, true), goodPage(1, true), goodPage(2, true), goodPage(3, true)};
  spoilt[2].picture[0] = '\0';
  corpus.addFile("contradiction", "a.tif", tiffOf(spoilt), {refused}, "the picture is damaged (");
  // Colours from a table that is not there: the library takes the samples for grey.
  corpus.addFile("contradiction", "a.tif", changedAll(262, {3, 1, 3}), {correct});
  // Tiles of 2³⁰ pixels where the picture has six.
  std::string tiled = changedAll(322, {4, 1, 32768});
  corpus.addFile("decompression bomb", "a.tif", tiled, {refused});
}

} // namespace

void addTiffInputs(Corpus& corpus) {
  corpus.addSound("a.tif", goodTiff());
  corpus.addSound("a.tif", goodTiff(true));
  corpus.addCuts("a.tif", goodTiff(), goodTiff().size());
  corpus.addCuts("a.tif", goodTiff(true), goodTiff(true).size());
  addTiffSizes(corpus);
  addChains(corpus);
  addPictures(corpus);
}

} // namespace limn::test
