// SPDX-License-Identifier: GPL-3.0-or-later
// Opens randomly damaged copies of sound files. What comes of one is not known; that it does no harm is.
#include "Attempt.h"

#include "io/VolumeReader.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <algorithm>
#include <random>
#include <sstream>

#include <malloc.h>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

// What a batch of small damaged files may take beside one attempt at a sound one. A damaged header may ask
// for what its file could hold at deflate's best ratio, here 10 MiB at most, and freed memory returns late.
constexpr std::uint64_t batchSlackBytes = std::uint64_t{48} << 20;

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t limit) {
  return random() % std::max<std::size_t>(limit, 1);
}

// Overwrites one to eight bytes with a number at which counting goes wrong.
void putLimit(std::string& bytes, Random& random) {
  static constexpr std::uint64_t limits[] = {0,          1,          0x7f,       0x80,    0xff,
                                             0x7fff,     0x8000,     0xffff,     1 << 24, 0x7fffffff,
                                             0x80000000, 0xffffffff, 0xfffffffe, ~0ull,   ~0ull >> 1};
  const std::uint64_t value = limits[below(random, std::size(limits))];
  const std::size_t width = std::size_t{1} << below(random, 4);
  const std::size_t at = below(random, bytes.size());
  const bool isBig = random() % 2;
  for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i)
    bytes[at + i] = static_cast<char>(value >> (8 * (isBig ? width - 1 - i : i)));
}

void change(std::string& bytes, Random& random) {
  const std::size_t at = below(random, bytes.size());
  const std::size_t length = std::min(below(random, 64) + 1, bytes.size() - at);
  switch (random() % 6) {
  case 0:
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(random, 8)));
    break;
  case 1:
    bytes[at] = static_cast<char>(random());
    break;
  case 2:
    putLimit(bytes, random);
    break;
  case 3:
    bytes.erase(at, length);
    break;
  case 4:
    bytes.insert(at, bytes.substr(at, length));
    break;
  default:
    bytes.insert(at, std::string(length, static_cast<char>(random())));
  }
}

// A damaged copy: mostly few changes, for with many every reader turns away at the first bytes.
std::string mutated(std::string bytes, std::uint32_t seed) {
  Random random(seed);
  const std::size_t changes = 1 + below(random, 4) * below(random, 3);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i)
    change(bytes, random);
  return bytes;
}

// The file of an input that is damaged: itself, or one of its folder.
fs::path victimOf(const fs::path& path, std::uint32_t seed) {
  if (!fs::is_directory(path))
    return path;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files[seed % files.size()];
}

void tryOne(const fs::path& path, std::uint32_t seed, const std::function<void(const std::string&)>& say) {
  const fs::path victim = victimOf(path, seed);
  const std::string whole = bytesOfFile(victim);
  writeBytes(victim, mutated(whole, seed));
  const std::string name = std::to_string(seed);
  say("T" + name + "\n");
  try {
    say(readVolume(path)->info().warnings.empty() ? "V\n" : "W\n");
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::input || !isOneSentence(error.what()))
      say("Xseed " + name + " is refused by no single sentence\n");
    say("R\n");
  } catch (const std::exception& error) {
    say("Xseed " + name + " ended in a stray exception\n");
  }
  writeBytes(victim, whole);
}

void judge(const MalformedInput& input, const ChildEnd& end, std::uint64_t allowedBytes,
           FormatReport& report) {
  std::istringstream lines(end.said);
  std::string last;
  const std::string place = report.format + " mutation of sound #" +
                            input.path.parent_path().filename().string() + "/" +
                            input.path.filename().string() + ": ";
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == 'T')
      last = line.substr(1);
    else if (line[0] == 'X')
      report.failures.push_back(place + line.substr(1));
    else
      report.rows.push_back({"mutated", line[0] == 'R'   ? Outcome::refused
                                        : line[0] == 'W' ? Outcome::warned
                                                         : Outcome::correct});
  }
  if (!end.isWell)
    report.failures.push_back(place + "seed " + last + " " + end.how);
  if (!isSanitised && end.peakBytes > allowedBytes)
    report.failures.push_back(place + "took " + std::to_string((end.peakBytes - allowedBytes) >> 20) +
                              " MiB more than allowed");
}

} // namespace

FormatReport triedMutations(const Format& format, int count, std::uint32_t seed) {
  const TemporaryFolder folder;
  Corpus corpus(folder.path());
  format.addInputs(corpus);
  malloc_trim(0);
  std::vector<MalformedInput> sound;
  for (const MalformedInput& input : corpus.inputs())
    if (input.flaw == "sound")
      sound.push_back(input);
  FormatReport report;
  report.format = format.name;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    const int share = count / static_cast<int>(sound.size());
    const std::uint64_t base = attempt(sound[i].path).peakBytes;
    const ChildEnd end = inChild(
        [&](const auto& say) {
          for (int trial = 0; trial < share; ++trial)
            tryOne(sound[i].path,
                   seed + static_cast<std::uint32_t>(i) * 1000003u + static_cast<std::uint32_t>(trial), say);
        },
        longestSeconds + share / 10);
    judge(sound[i], end, base + batchSlackBytes, report);
    report.worstSeconds = std::max(report.worstSeconds, end.seconds / std::max(share, 1));
    if (end.peakBytes > base)
      report.worstExtraBytes = std::max(report.worstExtraBytes, end.peakBytes - base);
  }
  return report;
}

} // namespace limn::test
