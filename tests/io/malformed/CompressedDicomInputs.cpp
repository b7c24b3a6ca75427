// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM files whose pixels or whole content is compressed.
#include "Corpus.h"
#include "GoodBytes.h"
#include "GoodDicom.h"
#include "support/TestData.h"

namespace limn::test {
namespace {

using enum Outcome;

const std::string runLength = "1.2.840.10008.1.2.5";
const std::string jpeg = "1.2.840.10008.1.2.4.50";
const std::string jpegLossless = "1.2.840.10008.1.2.4.70";
const std::string jpegLs = "1.2.840.10008.1.2.4.80";
const std::string jpeg2000 = "1.2.840.10008.1.2.4.90";

// A frame of the good volume in two run-length segments: high bytes, low bytes.
std::string runs(int number) {
  std::string stream = littleEndian(2, 4) + littleEndian(64, 4) + littleEndian(66, 4);
  stream.resize(64, '\0');
  stream += std::string("\xFB\0\5", 3);
  for (int i = 0; i < 6; ++i)
    stream += static_cast<char>(6 * number + i);
  return stream + '\0';
}

DicomBuilder compressed(const std::string& syntax, const std::vector<std::string>& streams) {
  return goodMultiframe().without(0x7FE00010).fragments(syntax, streams);
}

std::vector<std::string> goodRuns() {
  return {runs(0), runs(1), runs(2), runs(3)};
}

// The good file as one whose data set is deflated: what is behind its group 0002.
std::string deflatedFile(const std::string& packed) {
  const std::string bytes = goodMultiframe().bytes();
  const std::size_t start = bytes.find(std::string("\x08\0\x16\0UI", 6));
  std::string meta = bytes.substr(0, start);
  // The longer name of the syntax moves its length, which stands before it.
  const std::size_t name = meta.find("1.2.840.10008.1.2.1");
  meta.replace(name - 2, meta.size() - name + 2, littleEndian(22, 2) + "1.2.840.10008.1.2.1.99");
  return meta + packed;
}

std::string dataSet() {
  const std::string bytes = goodMultiframe().bytes();
  return bytes.substr(bytes.find(std::string("\x08\0\x16\0UI", 6)));
}

std::string rawDeflated(const std::string& bytes) {
  return bomb(bytes, 0, -15);
}

void addRuns(Corpus& corpus) {
  const std::string good = compressed(runLength, goodRuns()).bytes();
  corpus.addCuts("a.dcm", good, good.size() - 9, 60);
  const auto addStream = [&](const std::string& flaw, const std::string& stream) {
    auto streams = goodRuns();
    streams[2] = stream;
    corpus.addFile(flaw, "a.dcm", compressed(runLength, streams).bytes(), {refused});
  };
  addStream("truncated", runs(2).substr(0, 70));
  addStream("truncated", "");
  for (const std::uint32_t segments : {0u, 1u, 3u, 15u, 0xffffffffu})
    addStream("contradiction", littleEndian(segments, 4) + runs(2).substr(4));
  for (const std::uint32_t offset : {0u, 63u, 66u, 1000u, 0xffffffffu})
    addStream("contradiction", runs(2).substr(0, 4) + littleEndian(offset, 4) + runs(2).substr(8));
  addStream("endless or cyclic", runs(2).substr(0, 64) + std::string(100000, '\x80'));
  auto streams = goodRuns();
  streams.pop_back();
  corpus.addFile("missing slices", "a.dcm", compressed(runLength, streams).bytes(), {refused});
  // 65535² pixels of 16 bits, for which 200 KiB of runs do not suffice.
  DicomBuilder vast = compressed(runLength, {runs(0) + std::string(200000, '\x81')});
  vast.text(0x00280008, "IS", "1").us(0x00280010, {65535}).us(0x00280011, {65535});
  corpus.addFile("oversized dimensions", "a.dcm", vast.bytes(), {refused});
}

// The headers of streams that promise 65535² pixels.
void addVast(Corpus& corpus) {
  const std::string jpegFrame = std::string("\xFF\xD8\xFF\xC0\0\x0B\x08\xFF\xFF\xFF\xFF\1\1\x11\0", 15);
  const std::string progressive = std::string("\xFF\xD8\xFF\xC2\0\x0B\x08\xFF\xFF\xFF\xFF\1\1\x11\0", 15);
  const std::string lossless = std::string("\xFF\xD8\xFF\xC3\0\x0B\x10\xFF\xFF\xFF\xFF\1\1\x11\0", 15);
  const std::string ls = std::string("\xFF\xD8\xFF\xF7\0\x0B\x10\xFF\xFF\xFF\xFF\1\1\x11\0", 15);
  const std::string wavelets = std::string("\xFF\x4F\xFF\x51\0\x29\0\0", 8) + bigEndian(65535, 4) +
                               bigEndian(65535, 4) + bigEndian(0, 8) + bigEndian(65535, 4) +
                               bigEndian(65535, 4) + bigEndian(0, 8) + std::string("\0\1\x0F\1\1", 5);
  const std::string end = std::string(300000, '\0').append("\xFF\xD9");
  for (const auto& [syntax, start, bits] : {std::tuple(jpeg, jpegFrame, 8), std::tuple(jpeg, progressive, 8),
                                            std::tuple(jpegLossless, lossless, 16),
                                            std::tuple(jpegLs, ls, 16), std::tuple(jpeg2000, wavelets, 16)}) {
    DicomBuilder vast = compressed(syntax, {start + end});
    const auto word = static_cast<std::uint16_t>(bits);
    vast.us(0x00280100, {word}).us(0x00280101, {word}).us(0x00280102, {static_cast<std::uint16_t>(bits - 1)});
    vast.text(0x00280008, "IS", "1").us(0x00280010, {65535}).us(0x00280011, {65535});
    corpus.addFile("oversized dimensions", "a.dcm", vast.bytes(), {refused});
  }
  for (const std::string& syntax :
       {jpeg, jpegLossless, jpegLs, jpeg2000, std::string("1.2.840.10008.1.2.4.201")})
    for (const std::string& stream : {std::string(), std::string(64, '\xff'), jpegFrame, wavelets})
      corpus.addFile("wrong magic", "a.dcm", compressed(syntax, std::vector<std::string>(4, stream)).bytes(),
                     {refused});
}

// A picture of 64 MiB whose samples are missing but for its first: a decoder that carries on fills it with
// grey.
void addGuessed(Corpus& corpus) {
  constexpr std::uint16_t size = 8192;
  const std::string one = std::string("\xFF\xC4\0\x14", 4); // a table of one code
  std::string stream = std::string("\xFF\xD8\xFF\xDB\0\x43\0", 7) + std::string(64, '\1') +
                       std::string("\xFF\xC0\0\x0B\x08", 5) + bigEndian(size, 2) + bigEndian(size, 2) +
                       std::string("\1\1\x11\0", 4);
  for (const char table : {'\0', '\x10'})
    stream += one + table + std::string("\1", 1) + std::string(16, '\0');
  stream += std::string("\xFF\xDA\0\x08\1\1\0\0\x3F\0\x12\x34\xFF\xD9", 14);
  DicomBuilder guessed = compressed(jpeg, {stream + std::string(70000, '\0')});
  guessed.text(0x00280008, "IS", "1").us(0x00280010, {size}).us(0x00280011, {size});
  guessed.us(0x00280100, {8}).us(0x00280101, {8}).us(0x00280102, {7}).us(0x00280103, {0});
  corpus.addFile("truncated", "a.dcm", guessed.bytes(), {refused}, "damaged or cut off (");
}

void addFragments(Corpus& corpus) {
  const std::string good = compressed(runLength, goodRuns()).bytes();
  const std::size_t table = good.find(littleEndian(0xE000FFFE, 4));
  for (const std::uint32_t length : {1u, 0x7fffffffu, 0xffffffffu}) {
    std::string lying = good;
    corpus.addFile("contradiction", "a.dcm", lying.replace(table + 4, 4, littleEndian(length, 4)), {refused});
    lying = good;
    corpus.addFile("contradiction", "a.dcm", lying.replace(table + 12, 4, littleEndian(length, 4)),
                   {refused});
  }
  // A million empty fragments for the first frame of two, in whose table every one must be looked up.
  std::string offsets;
  std::string empty;
  for (std::uint32_t i = 0; i < 200000; ++i) {
    offsets += littleEndian(0xfffffff0u, 4);
    empty += littleEndian(0xE000FFFE, 4) + littleEndian(0, 4);
  }
  DicomBuilder many = compressed(runLength, {});
  many.text(0x00280008, "IS", "200000");
  std::string bytes = many.bytes();
  const std::size_t at = bytes.find(littleEndian(0xE000FFFE, 4));
  bytes.replace(at, bytes.size() - at,
                littleEndian(0xE000FFFE, 4) + littleEndian(offsets.size(), 4) + offsets + empty + empty +
                    littleEndian(0xE0DDFFFE, 4) + littleEndian(0, 4));
  corpus.addFile("endless or cyclic", "a.dcm", bytes, {refused});
}

void addDeflated(Corpus& corpus) {
  const std::string good = deflatedFile(rawDeflated(dataSet()));
  corpus.addCuts("a.dcm", good, good.size() - 12);
  // Near the end at every byte: no sample may be made up of bits that are not there.
  for (std::size_t length = good.size() - 64; length < good.size(); ++length)
    corpus.addFile("truncated", "a.dcm", good.substr(0, length),
                   length < good.size() - 12 ? Outcomes{refused} : anyOutcome);
  corpus.addFile("wrong magic", "a.dcm", deflatedFile(dataSet()), {refused});
  corpus.addFile("decompression bomb", "a.dcm", deflatedFile(bomb(dataSet(), 1024, -15)),
                 {correct, warned, refused});
  corpus.addFile("decompression bomb", "a.dcm", deflatedFile(bomb(dataSet(), 4096, -15)),
                 {correct, warned, refused});
  const std::string element =
      littleEndian(0x20000008, 4) + "UT" + littleEndian(0, 2) + littleEndian(0xfffffff0, 4);
  corpus.addFile("decompression bomb", "a.dcm",
                 deflatedFile(bomb(dataSet().substr(0, 30) + element, 1024, -15)), {refused});
}

} // namespace

void addCompressedDicomInputs(Corpus& corpus) {
  corpus.addSound("a.dcm", compressed(runLength, goodRuns()).bytes());
  corpus.addSound("a.dcm", deflatedFile(rawDeflated(dataSet())));
  addRuns(corpus);
  addVast(corpus);
  addGuessed(corpus);
  addFragments(corpus);
  addDeflated(corpus);
}

void addOddDicomInputs(Corpus& corpus) {
  const auto odd = sharedFolder() / "data/odd_dicom";
  if (!std::filesystem::is_directory(odd))
    return;
  for (const auto& entry : std::filesystem::directory_iterator(odd)) {
    const std::string name = entry.path().filename().string();
    const bool isSound = name.starts_with("MR_small") || name.starts_with("emri_small");
    const bool isRefused = name == "MR_truncated.dcm" || name == "badVR.dcm" || name == "rtplan.dcm";
    const auto copy = corpus.newFolder() / name;
    std::filesystem::copy_file(entry.path(), copy);
    MalformedInput& input = corpus.add(isSound ? "sound" : "odd", copy,
                                       isSound     ? Outcomes{Outcome::correct}
                                       : isRefused ? Outcomes{Outcome::refused}
                                                   : Outcomes{Outcome::correct, Outcome::warned});
    input.becomesAnother();
  }
}

} // namespace limn::test
