// SPDX-License-Identifier: GPL-3.0-or-later
// Folders of DICOM slices.
#include "Corpus.h"
#include "GoodBytes.h"
#include "GoodDicom.h"

#include <functional>

namespace limn::test {
namespace {

namespace fs = std::filesystem;
using enum Outcome;

// A folder of the good slices, each passed through `change`.
fs::path series(
    Corpus& corpus, const std::function<DicomBuilder(int, DicomBuilder)>& change =
                        [](int, DicomBuilder slice) { return slice; }) {
  const fs::path folder = corpus.newFolder();
  for (int number = 0; number < 4; ++number)
    change(number, goodSlice(number)).write(folder / (std::to_string(number) + ".dcm"));
  return folder;
}

// Slice 2 changed.
fs::path withThird(Corpus& corpus, const std::function<void(DicomBuilder&)>& change) {
  return series(corpus, [&](int number, DicomBuilder slice) {
    if (number == 2)
      change(slice);
    return slice;
  });
}

void addSlices(Corpus& corpus) {
  fs::path folder = series(corpus);
  fs::remove(folder / "1.dcm");
  corpus.add("missing slices", folder, {warned}, "missing slices").becomesAnother();
  folder = series(corpus, [](int number, DicomBuilder slice) {
    return slice.text(0x00200032, "DS", "0\\0\\" + std::to_string(number < 2 ? number : 40 + number));
  });
  corpus.add("missing slices", folder, {refused}, "gap");
  folder = series(corpus);
  goodSlice(2).write(folder / "again.dcm");
  corpus.add("duplicate slices", folder, {warned}, "copy");
  folder = series(corpus);
  goodSlice(2).text(0x00080018, "UI", "1.2.3.4.77").write(folder / "again.dcm");
  corpus.add("duplicate slices", folder, {warned}, "repeats some positions");
  folder = series(corpus, [](int, DicomBuilder slice) { return slice.text(0x00200032, "DS", "0\\0\\0"); });
  corpus.add("duplicate slices", folder, {warned}).becomesAnother();
  corpus
      .add("slices of different size",
           withThird(corpus, [](DicomBuilder& slice) { slice.us(0x00280010, {2}).us(0x00280011, {3}); }),
           {warned}, "2 series")
      .becomesAnother();
  corpus.add("slices of different size",
             withThird(corpus,
                       [](DicomBuilder& s) {
                         s.pixels(std::vector<std::int16_t>{1, 2});
                       }),
             {refused}, "2.dcm");
  corpus
      .add("mixed series", withThird(corpus, [](DicomBuilder& s) { s.text(0x0020000E, "UI", "1.2.9"); }),
           {warned}, "2 series")
      .becomesAnother();
  corpus
      .add("mixed series", withThird(corpus, [](DicomBuilder& s) { s.text(0x0020000D, "UI", "1.9"); }),
           {warned}, "2 series")
      .becomesAnother();
}

void addSeriesPlaces(Corpus& corpus) {
  corpus
      .add("orientation",
           withThird(corpus, [](DicomBuilder& s) { s.text(0x00200037, "DS", "0\\1\\0\\0\\0\\1"); }), {warned},
           "2 series")
      .becomesAnother();
  corpus
      .add("orientation",
           withThird(corpus, [](DicomBuilder& s) { s.text(0x00200037, "DS", "0\\0\\0\\0\\0\\0"); }), {warned},
           "2 series")
      .becomesAnother();
  corpus.add(
      "orientation",
      series(corpus, [](int, DicomBuilder s) { return s.text(0x00200037, "DS", "nan\\0\\0\\0\\1\\0"); }),
      {warned}, "orientation is unknown");
  for (const char* place : {"1e30\\0\\8", "1e300\\1e300\\8", "1e9\\0\\8", "nan\\0\\8"})
    corpus
        .add("orientation", withThird(corpus, [&](DicomBuilder& s) { s.text(0x00200032, "DS", place); }),
             {warned, refused})
        .becomesAnother();
  for (const char* height : {"1e30", "1e308", "-1e308", "nan"})
    corpus
        .add(
            "spacing",
            withThird(corpus,
                      [&](DicomBuilder& s) { s.text(0x00200032, "DS", std::string("-10\\-20\\") + height); }),
            {warned, refused})
        .becomesAnother();
  corpus
      .add("spacing", withThird(corpus, [](DicomBuilder& s) { s.text(0x00280030, "DS", "nan\\nan"); }),
           {warned}, "2 series")
      .becomesAnother();
  corpus.add("spacing",
             series(corpus, [](int, DicomBuilder s) { return s.text(0x00280030, "DS", "1e-30\\1e-30"); }),
             {refused});
  corpus.add("spacing",
             series(corpus, [](int, DicomBuilder s) { return s.text(0x00280030, "DS", "1e30\\1e30"); }),
             {refused});
  // Slices that lie too close to tell apart, and some 10⁷ mm apart.
  corpus
      .add("spacing",
           series(corpus,
                  [](int number, DicomBuilder s) {
                    return s.text(0x00200032, "DS", "0\\0\\" + std::to_string(number) + "e-9");
                  }),
           {warned, refused})
      .becomesAnother();
  corpus
      .add("spacing",
           series(corpus,
                  [](int number, DicomBuilder s) {
                    return s.text(0x00200032, "DS", "0\\0\\" + std::to_string(number) + "e20");
                  }),
           {warned, refused})
      .becomesAnother();
}

void addSeriesFiles(Corpus& corpus) {
  for (const int number : {2, 3}) {
    const std::string name = std::to_string(number) + ".dcm";
    const std::string whole = goodSlice(number).bytes();
    for (std::size_t length = 0; length < whole.size(); length += 10) {
      const fs::path folder = series(corpus);
      writeBytes(folder / name, whole.substr(0, length));
      corpus.add("truncated", folder, {warned, refused}, name).becomesAnother();
    }
  }
  const fs::path lost = series(corpus);
  goodSlice(4).without(0x7FE00010).write(lost / "4.dcm");
  corpus.add("truncated", lost, {warned}, "4.dcm");
  const fs::path foreign = series(corpus);
  writeBytes(foreign / "note.txt", "no image");
  goodReport().write(foreign / "report.dcm");
  corpus.add("not an image", foreign, {correct});
  const fs::path only = corpus.newFolder();
  goodReport().write(only / "report.dcm");
  corpus.add("not an image", only, {refused}, "without images");
  for (const char* link : {".", "..", "/"}) {
    const fs::path folder = series(corpus);
    fs::create_directory_symlink(link, folder / "again");
    corpus.add("endless or cyclic", folder, {correct});
  }
  const fs::path folder = series(corpus);
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  corpus.add("endless or cyclic", folder, {correct});
  const fs::path deep = series(corpus);
  fs::path below = deep;
  for (int i = 0; i < 200; ++i)
    below /= "folder";
  fs::create_directories(below);
  goodSlice(9).write(below / "9.dcm");
  corpus.add("endless or cyclic", deep, {correct, warned});
  for (const char* text : {"1\n2", "\x01\x02", "\xff\xfe\xfd"})
    corpus.add("contradiction",
               series(corpus,
                      [&](int, DicomBuilder s) {
                        return s.text(0x0008103E, "LO", text).text(0x00080005, "CS", text);
                      }),
               {correct, warned});
}

} // namespace

void addDicomSeriesInputs(Corpus& corpus) {
  corpus.add("sound", series(corpus), {correct});
  addSlices(corpus);
  addSeriesPlaces(corpus);
  addSeriesFiles(corpus);
}

} // namespace limn::test
