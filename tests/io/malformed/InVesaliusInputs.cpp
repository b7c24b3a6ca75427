// SPDX-License-Identifier: GPL-3.0-or-later
#include "Corpus.h"
#include "GoodBytes.h"

namespace limn::test {
namespace {

using enum Outcome;

struct TarFile {
  std::string name;
  std::string bytes;
  char type = '0'; ///< '1' hard link, '2' symbolic link
  std::string link = {};
};

std::string field(const std::string& text, std::size_t width) {
  return text.substr(0, width) + std::string(width - std::min(width, text.size()), '\0');
}

std::string octal(std::uint64_t value, std::size_t width) {
  std::string digits;
  for (std::size_t i = 0; i + 1 < width; ++i, value /= 8)
    digits.insert(digits.begin(), static_cast<char>('0' + value % 8));
  return digits + '\0';
}

// The header of one entry (POSIX ustar), which says that `size` bytes follow.
std::string tarHeader(const TarFile& file, std::uint64_t size) {
  std::string header = field(file.name, 100) + octal(0644, 8) + octal(0, 8) + octal(0, 8) + octal(size, 12) +
                       octal(0, 12) + std::string(8, ' ') + file.type + field(file.link, 100) +
                       std::string("ustar\0"
                                   "00",
                                   8);
  header.resize(512, '\0');
  unsigned sum = 0;
  for (const char c : header)
    sum += static_cast<unsigned char>(c);
  return header.replace(148, 8, octal(sum, 7) + ' ');
}

std::string tar(const std::vector<TarFile>& files) {
  std::string bytes;
  for (const TarFile& file : files)
    bytes += tarHeader(file, file.bytes.size()) + file.bytes +
             std::string((512 - file.bytes.size() % 512) % 512, '\0');
  return bytes + std::string(1024, '\0');
}

const std::string project =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?><plist version=\"1.0\"><dict><key>orientation</key>"
    "<integer>1</integer><key>modality</key><string>CT</string><key>matrix</key><dict><key>dtype</key>"
    "<string>int16</string><key>filename</key><string>matrix.dat</string><key>shape</key><array>"
    "<integer>4</integer><integer>3</integer><integer>2</integer></array></dict><key>spacing</key><array>"
    "<real>2</real><real>3</real><real>4</real></array></dict></plist>";

std::string archive(const std::string& list, const std::string& voxels = goodVoxels()) {
  return tar({{"p/main.plist", list}, {"p/matrix.dat", voxels}});
}

void addInVesaliusChanged(Corpus& corpus, const std::string& flaw, const std::string& from,
                          const std::string& to, const Outcomes& allowed, const std::string& says = "") {
  corpus.addFile(flaw, "a.inv3", deflated(archive(replaced(project, from, to))), allowed, says);
}

void addProjects(Corpus& corpus) {
  for (const char* size : {"0", "-4"})
    addInVesaliusChanged(corpus, "zero or negative size", "<integer>4", std::string("<integer>") + size,
                         {refused});
  for (const char* size : {"2147483648", "2147483647", "4611686018427387904", "1e300", "nan", "", "0.5"})
    addInVesaliusChanged(corpus, "oversized dimensions", "<integer>4", std::string("<integer>") + size,
                         {refused});
  for (const char* spacing : {"0", "nan", "inf", "1e-30", "1e30", "two"})
    addInVesaliusChanged(corpus, "spacing", "<real>2", std::string("<real>") + spacing, {refused});
  for (const char* name : {"../../../../etc/passwd", "/etc/passwd", "../p/matrix.dat", ""})
    addInVesaliusChanged(corpus, "path traversal", "matrix.dat", name, {refused}, "missing");
  addInVesaliusChanged(corpus, "endless or cyclic", "matrix.dat", "main.plist", {refused});
  addInVesaliusChanged(corpus, "contradiction", "int16", "object", {refused});
  addInVesaliusChanged(corpus, "contradiction", "int16", "float64", {refused});
  addInVesaliusChanged(corpus, "vector or colour", "<integer>4</integer>",
                       "<integer>4</integer><integer>3</integer>", {refused});
  addInVesaliusChanged(corpus, "wrong magic", "<plist", "<plost", {refused});
  addInVesaliusChanged(corpus, "truncated", "</dict></plist>", "", {refused});
  addInVesaliusChanged(corpus, "missing file", "<key>spacing</key>", "<key>spicing</key>", {refused});
  std::string deep = project;
  for (int i = 0; i < 100000; ++i)
    deep += "<a>";
  corpus.addFile("endless or cyclic", "a.inv3", deflated(archive(deep)), {refused});
}

void addArchives(Corpus& corpus) {
  corpus.addFile("missing file", "a.inv3", deflated(tar({{"p/main.plist", project}})), {refused},
                 "matrix.dat");
  corpus.addFile("missing file", "a.inv3", deflated(tar({{"p/matrix.dat", goodVoxels()}})), {refused},
                 "main.plist");
  corpus.addFile("missing file", "a.inv3", deflated(tar({})), {refused});
  for (const char type : {'1', '2'})
    for (const char* target : {"/etc/passwd", "../../../../../../etc/passwd", "p/matrix.dat"})
      corpus.addFile("path traversal", "a.inv3",
                     deflated(tar({{"p/main.plist", project}, {"p/matrix.dat", "", type, target}})),
                     {refused});
  corpus.addFile("path traversal", "a.inv3",
                 deflated(tar({{"../../main.plist", project}, {"/matrix.dat", goodVoxels()}})),
                 {correct, refused});
  // Entries that claim more than the archive holds.
  for (const std::uint64_t size : {std::uint64_t{1} << 31, (std::uint64_t{1} << 33) - 1}) {
    const std::string list = tar({{"p/main.plist", project}}).substr(0, 1024 + 512);
    corpus.addFile("oversized dimensions", "a.inv3",
                   deflated(list + tarHeader({"p/matrix.dat", ""}, size) + goodVoxels()), {refused});
    corpus.addFile("oversized dimensions", "a.inv3",
                   deflated(tarHeader({"p/main.plist", ""}, size) + project), {refused});
  }
  const std::string large =
      replaced(replaced(replaced(project, "<integer>4", "<integer>512"), "<integer>3", "<integer>1024"),
               "<integer>2<", "<integer>1024<");
  const std::string list = tar({{"p/main.plist", large}}).substr(0, 1024 + 512);
  corpus.addFile("decompression bomb", "a.inv3",
                 bomb(list + tarHeader({"p/matrix.dat", ""}, std::uint64_t{1} << 30), 64, 31), {refused});
  // What is before the project inflates without end.
  corpus.addFile("decompression bomb", "a.inv3", bomb(tarHeader({"p/mask.dat", ""}, 077777777777), 6000, 31),
                 {refused});
  std::vector<TarFile> many(20000, TarFile{"p/x", ""});
  corpus.addFile("endless or cyclic", "a.inv3", deflated(tar(many)), {refused});
  corpus.addFile("wrong magic", "a.inv3", replaced(archive(project), "ustar", "ustor"), {refused});
}

} // namespace

void addInVesaliusInputs(Corpus& corpus) {
  const std::string good = deflated(archive(project));
  corpus.addSound("a.inv3", good);
  corpus.addSound("a.inv3", archive(project));
  corpus.addCuts("a.inv3", good, good.size() - 60);
  corpus.addCuts("a.inv3", archive(project), 3 * 512 + goodVoxels().size());
  addProjects(corpus);
  addArchives(corpus);
}

} // namespace limn::test
