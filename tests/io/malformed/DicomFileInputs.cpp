// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM files of one slice each, in the sequence of slices that the good volume has.
#include "Corpus.h"
#include "GoodBytes.h"
#include "GoodDicom.h"

namespace limn::test {
namespace {

using enum Outcome;

// One enhanced file that holds the whole volume.
DicomBuilder whole() {
  return goodMultiframe();
}

void addWhole(Corpus& corpus, const std::string& flaw, const DicomBuilder& file, const Outcomes& allowed,
              const std::string& says = "") {
  corpus.addFile(flaw, "a.dcm", file.bytes(), allowed, says);
}

void addDicomFileSizes(Corpus& corpus) {
  for (const std::uint16_t size : {0, 65535}) {
    const std::string flaw = size == 0 ? "zero or negative size" : "oversized dimensions";
    addWhole(corpus, flaw, whole().us(0x00280010, {size}), {refused});
    addWhole(corpus, flaw, whole().us(0x00280011, {size}), {refused});
    addWhole(corpus, flaw, whole().us(0x00280010, {size}).us(0x00280011, {size}), {refused});
  }
  for (const char* frames : {"0", "-4", "nan", "1e300", "2147483648", "1048576", "1048575", "5", "4.5", "x"})
    addWhole(corpus, "oversized dimensions", whole().text(0x00280008, "IS", frames), {refused});
  addWhole(corpus, "oversized dimensions", whole().text(0x00280008, "IS", std::string(100000, '9')),
           {refused});
}

void addBits(Corpus& corpus) {
  for (const std::uint16_t bits : {0, 1, 7, 12, 17, 24, 64, 65535})
    addWhole(corpus, "contradiction", whole().us(0x00280100, {bits}), {refused});
  for (const std::uint16_t stored : {0, 17, 65535})
    addWhole(corpus, "contradiction", whole().us(0x00280101, {stored}), {refused});
  for (const std::uint16_t high : {0, 16, 65535})
    addWhole(corpus, "contradiction", whole().us(0x00280102, {high}), {refused});
  for (const std::uint16_t samples : {0, 2, 4, 65535})
    addWhole(corpus, "vector or colour", whole().us(0x00280002, {samples}), {refused});
  addWhole(corpus, "vector or colour", whole().us(0x00280002, {3}).text(0x00280004, "CS", "RGB"), {refused});
  addWhole(corpus, "vector or colour", whole().text(0x00280004, "CS", "CMYK\nand a line\x01"), {refused});
  addWhole(corpus, "vector or colour", whole().text(0x00280004, "CS", std::string(5000, 'X')), {refused});
  addWhole(corpus, "vector or colour", whole().text(0x00280004, "CS", "PALETTE COLOR"), {refused});
  // A palette of signed pixels: its values reach beyond those of the pixels' type.
  DicomBuilder palette = whole().text(0x00280004, "CS", "PALETTE COLOR").us(0x00280103, {1});
  for (const std::uint32_t channel : {0u, 1u, 2u})
    palette.us(0x00281101 + channel, {2, 0, 16}).us(0x00281201 + channel, {0, 65535});
  corpus.addFile("vector or colour", "a.dcm", palette.bytes(), {warned}, "luminance").hasGoodVoxels = false;
  for (const char* slope : {"0", "1e400", "nan", "x", "1e300\\2"})
    addWhole(corpus, "contradiction", whole().text(0x00281053, "DS", slope), {refused, warned});
  addWhole(corpus, "contradiction", whole().pixels(rising<std::int16_t>(60)), {warned}, "more pixels");
}

void addDicomFilePlaces(Corpus& corpus) {
  for (const char* spacing : {"nan\\nan", "0\\0", "-1\\-1", "inf\\1", "2", "x\\y", ""})
    addWhole(corpus, "spacing", whole().text(0x00280030, "DS", spacing), {warned}, "how large its pixels");
  for (const char* spacing : {"1e-30\\1e-30", "1e30\\1e30"})
    addWhole(corpus, "spacing", whole().text(0x00280030, "DS", spacing), {refused}, "spacing");
  for (const char* axes :
       {"0\\0\\0\\0\\0\\0", "1\\0\\0\\1\\0\\0", "nan\\0\\0\\0\\1\\0", "1\\0\\0\\0\\0.5\\0", "1\\0"})
    addWhole(corpus, "orientation", whole().text(0x00200037, "DS", axes), {warned}, "orientation");
  for (const char* place : {"nan\\0\\0", "1e400\\0\\0", "1\\2"})
    addWhole(corpus, "orientation", whole().text(0x00200032, "DS", place), {warned}, "orientation");
  addWhole(corpus, "orientation", whole().text(0x00200032, "DS", "1e30\\0\\0"), {refused, warned});
}

void addKinds(Corpus& corpus) {
  addWhole(corpus, "mosaic", whole().text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\M\\MOSAIC"), {refused},
           "mosaic");
  addWhole(corpus, "truncated", whole().without(0x7FE00010), {refused}, "cut off before its picture");
  addWhole(corpus, "not an image", goodReport(), {refused}, "holds no image");
  addWhole(corpus, "not an image", whole().without(0x7FE00010).text(0x00080060, "CS", "RTPLAN"), {refused});
  addWhole(corpus, "not an image", whole().without(0x7FE00010).text(0x00080060, "CS", "a\nb\x02"), {refused});
  addWhole(corpus, "not an image", whole().without(0x7FE00010).text(0x00080060, "CS", std::string(3000, 'a')),
           {refused});
  addWhole(corpus, "4D", whole().us(0x00280009, {0x0018, 0x1063}).without(0x3004000C).without(0x00200032),
           {refused}, "film");
  const std::string bytes = whole().bytes();
  std::string magic = bytes;
  magic.replace(128, 4, "DICX");
  corpus.addFile("wrong magic", "a.dcm", magic, {refused});
  corpus.addFile("wrong magic", "a.dcm", replaced(bytes, "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.2"),
                 {refused, correct});
  corpus.addFile("wrong magic", "a.dcm", replaced(bytes, "1.2.840.10008.1.2.1", "9.9.999.99999.9.9.9"),
                 {refused, correct});
}

// `count` sequences in each other, by known or unknown lengths.
std::string nested(int count, bool isKnown) {
  std::string inside;
  for (int i = 0; i < count; ++i) {
    const std::string item = isKnown ? littleEndian(0xE000FFFE, 4) + littleEndian(inside.size(), 4) + inside
                                     : littleEndian(0xE000FFFE, 4) + littleEndian(0xFFFFFFFF, 4) + inside;
    inside = littleEndian(0x11400008, 4) + "SQ" + littleEndian(0, 2) +
             littleEndian(isKnown ? item.size() : 0xFFFFFFFF, 4) + item;
  }
  return inside;
}

void addStructures(Corpus& corpus) {
  const std::string bytes = whole().bytes();
  const std::size_t at = bytes.find(std::string("\x08\0\x60\0CS", 6)); // behind (0008,0060)
  for (const int depth : {40, 5000, 10000})
    for (const bool isKnown : {true, false}) {
      std::string deep = bytes;
      corpus.addFile("endless or cyclic", "a.dcm", deep.insert(at, nested(depth, isKnown)),
                     isKnown ? Outcomes{correct} : Outcomes{refused}, isKnown ? "" : "deeply");
    }
  // A sequence that never ends, of items without length.
  std::string endless = bytes;
  std::string items = littleEndian(0x11400008, 4) + "SQ" + littleEndian(0, 2) + littleEndian(0xFFFFFFFF, 4);
  for (int i = 0; i < 300000; ++i)
    items += littleEndian(0xE000FFFE, 4) + littleEndian(0, 4);
  corpus.addFile("endless or cyclic", "a.dcm", endless.insert(at, items), {refused, correct});
  // Two million attributes that nobody asks for.
  std::string many = bytes.substr(0, at);
  for (int i = 0; i < 2000000; ++i)
    many += littleEndian(0x0009 + 2u * static_cast<unsigned>(i % 16), 2) +
            littleEndian(static_cast<unsigned>(i) / 16 % 65536, 2) + "LO" + littleEndian(0, 2);
  corpus.addFile("endless or cyclic", "a.dcm", many + bytes.substr(at), {refused, correct});
  std::string known = bytes.substr(0, at);
  for (int i = 0; i < 2000000; ++i)
    known += littleEndian(0x0008, 2) + littleEndian(0x2000 + static_cast<unsigned>(i) % 50000, 2) + "LO" +
             littleEndian(0, 2);
  corpus.addFile("endless or cyclic", "a.dcm", known + bytes.substr(at), {refused, correct});
  // Values of a mebibyte each, all of which would be kept.
  std::string heavy = bytes.substr(0, at);
  for (int i = 0; i < 100; ++i)
    heavy += littleEndian(0x0008, 2) + littleEndian(0x2000 + static_cast<unsigned>(i), 2) + "UT" +
             littleEndian(0, 2) + littleEndian(1 << 20, 4) + std::string(1 << 20, ' ');
  corpus.addFile("endless or cyclic", "a.dcm", heavy + bytes.substr(at), {refused, correct});
  for (const std::uint32_t length : {0x7fffffffu, 0xfffffffeu, 0xffffffffu}) {
    std::string lying = bytes;
    lying.insert(at, littleEndian(0x11400008, 4) + "UN" + littleEndian(0, 2) + littleEndian(length, 4));
    corpus.addFile("contradiction", "a.dcm", lying, {refused});
  }
}

} // namespace

void addDicomFileInputs(Corpus& corpus) {
  addWhole(corpus, "sound", whole(), {correct});
  corpus.addCuts("a.dcm", whole().bytes(), whole().bytes().size(), 80);
  addDicomFileSizes(corpus);
  addBits(corpus);
  addDicomFilePlaces(corpus);
  addKinds(corpus);
  addStructures(corpus);
}

} // namespace limn::test
