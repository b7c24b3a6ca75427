// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/ProgramRun.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <thread>

namespace limn {
namespace {

namespace fs = std::filesystem;

// Volumes here are larger than what the program may keep for itself; they lie where it puts its own files.
class LargeVolume : public ::testing::Test {
protected:
  static constexpr const char* place = "/var/tmp";

  struct Folder {
    explicit Folder(const fs::path& pattern) {
      std::string name = pattern.string();
      if (mkdtemp(name.data()))
        path = name;
    }
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
    fs::path path;
  };

  std::string file(const std::string& name) const { return (folder.path / name).string(); }

  bool hasRoom(double bytes) const {
    std::error_code unknown;
    return static_cast<double>(fs::space(folder.path, unknown).available) > bytes;
  }

  Folder folder{fs::path(place) / "limn-large-XXXXXX"};
};

// The header of a NIfTI-1 (dimensions to 32767) file of 16-bit voxels, 352 bytes long.
std::string niftiHeader(const std::array<int, 3>& dims, int type, int bits) {
  std::string header(352, '\0');
  const auto put = [&](std::size_t at, auto value) { std::memcpy(header.data() + at, &value, sizeof value); };
  put(0, std::int32_t{348});
  const std::int16_t dim[] = {3, static_cast<std::int16_t>(dims[0]), static_cast<std::int16_t>(dims[1]),
                              static_cast<std::int16_t>(dims[2])};
  std::memcpy(header.data() + 40, dim, sizeof dim);
  put(70, static_cast<std::int16_t>(type));
  put(72, static_cast<std::int16_t>(bits));
  for (int axis = 0; axis < 4; ++axis)
    put(76 + 4 * static_cast<std::size_t>(axis), 1.0f);
  put(108, 352.0f);
  put(112, 1.0f);
  put(254, std::int16_t{1}); // the rows below place the voxels
  put(280, 1.0f);
  put(300, 1.0f);
  put(320, 1.0f);
  std::memcpy(header.data() + 344, "n+1", 4);
  return header;
}

// A bump along one axis, 0 at its ends.
std::vector<float> bump(int count) {
  std::vector<float> values(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    values[static_cast<std::size_t>(i)] = static_cast<float>(std::sin(3.14159265 * (i + 0.5) / count));
  return values;
}

// A smooth body in Hounsfield units with a denser shell inside, streamed to `put` slice after slice.
template <class Put>
void forEachSlice(const std::array<int, 3>& dims, Put&& put) {
  const std::vector<float> xs = bump(dims[0]), ys = bump(dims[1]), zs = bump(dims[2]);
  std::vector<std::int16_t> slice(xs.size() * ys.size());
  for (const float z : zs) {
    auto voxel = slice.begin();
    for (const float y : ys)
      for (const float x : xs) {
        const float depth = x * y * z;
        *voxel++ =
            static_cast<std::int16_t>(1400.0f * depth - 1000.0f + (depth > 0.5f && depth < 0.6f ? 700 : 0));
      }
    put(reinterpret_cast<const char*>(slice.data()), slice.size() * sizeof(std::int16_t));
  }
}

void writeNifti(const std::string& path, const std::array<int, 3>& dims) {
  std::ofstream out(path, std::ios::binary);
  out << niftiHeader(dims, 4, 16);
  forEachSlice(dims, [&](const char* bytes, std::size_t count) {
    out.write(bytes, static_cast<std::streamsize>(count));
  });
}

// How a run ended, and the most memory of its own that was seen.
struct WatchedRun {
  int status = -1;
  std::uint64_t ownBytes = 0;
  std::string err;
};

std::uint64_t ownBytesOf(pid_t process) {
  std::ifstream lines("/proc/" + std::to_string(process) + "/status");
  for (std::string word; lines >> word;)
    if (std::uint64_t kibibytes = 0; word == "RssAnon:" && lines >> kibibytes)
      return kibibytes * 1024;
  return 0;
}

// Runs the program and looks at its memory every few milliseconds; `look` is called each time.
template <class Look>
WatchedRun watched(const fs::path& home, const std::vector<std::string>& arguments, Look&& look) {
  const std::string err = (home / "stderr").string();
  std::vector<std::string> words{test::programPath()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("HOME", home.c_str(), 1);
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    const int to = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(to, 2);
    ::dup2(to, 1);
    ::execv(argv.front(), argv.data());
    ::_exit(127);
  }
  WatchedRun run;
  int raw = 0;
  while (::waitpid(child, &raw, WNOHANG) == 0) {
    run.ownBytes = std::max(run.ownBytes, ownBytesOf(child));
    look(child);
    std::this_thread::sleep_for(std::chrono::milliseconds(2)); // between two looks
  }
  run.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
  run.err = test::bytesOfFile(err);
  return run;
}

WatchedRun watched(const fs::path& home, const std::vector<std::string>& arguments) {
  return watched(home, arguments, [](pid_t) {});
}

// The largest difference of two pictures' pixels, in levels of 255; -1 where one cannot be compared.
double largestDifference(const std::string& a, const std::string& b) {
  const OIIO::ImageBuf first(a), second(b);
  const auto facts = OIIO::ImageBufAlgo::compare(first, second, 1.0f, 1.0f);
  return facts.error ? -1.0 : 255.0 * facts.maxerror;
}

constexpr std::array<int, 3> large = {1024, 1024, 700};
constexpr double largeBytes = 1024.0 * 1024.0 * 700.0 * 2.0;

std::vector<std::string> renderOf(const std::string& volume, const std::string& picture,
                                  const std::vector<std::string>& more) {
  std::vector<std::string> words = {"render",  volume,    "--engine", "cpu",  "--size",
                                    "320x240", "--quiet", "-o",       picture};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(LargeVolume, isDrawnInLittleMemoryAsInMuch) {
  if (!hasRoom(2.5 * largeBytes))
    GTEST_SKIP() << "needs 3.7 GB of disk in " << place;
  const std::string volume = file("large.nii");
  writeNifti(volume, large);
  const WatchedRun much = watched(folder.path, renderOf(volume, file("much.exr"), {"--memory", "100000"}));
  ASSERT_EQ(much.status, 0) << much.err;
  const WatchedRun little = watched(folder.path, renderOf(volume, file("little.exr"), {"--memory", "300"}));
  ASSERT_EQ(little.status, 0) << little.err;
  RecordProperty("ownMBWithMuch", std::to_string(much.ownBytes / 1000000));
  RecordProperty("ownMBWithLittle", std::to_string(little.ownBytes / 1000000));
  EXPECT_GT(static_cast<double>(much.ownBytes), largeBytes) << "the voxels themselves";
  EXPECT_LE(little.ownBytes, 450'000'000u);
  const double levels = largestDifference(file("much.exr"), file("little.exr"));
  EXPECT_GE(levels, 0.0);
  EXPECT_LE(levels, 0.05);
}

// What is kept of a volume is as large as it.
TEST_F(LargeVolume, whoseBodyIsKeptIsDrawnInLittleMemoryToo) {
  if (!hasRoom(2.5 * largeBytes))
    GTEST_SKIP() << "needs 3.7 GB of disk in " << place;
  const std::string volume = file("large.nii");
  writeNifti(volume, large);
  const auto drawn = [&](const std::string& picture, const char* memory) {
    return watched(folder.path, renderOf(volume, picture, {"--keep", "body", "--memory", memory}));
  };
  const WatchedRun much = drawn(file("much.exr"), "100000");
  ASSERT_EQ(much.status, 0) << much.err;
  const WatchedRun little = drawn(file("little.exr"), "300");
  ASSERT_EQ(little.status, 0) << little.err;
  RecordProperty("ownMB", std::to_string(little.ownBytes / 1000000));
  EXPECT_LE(little.ownBytes, 450'000'000u);
  const double levels = largestDifference(file("much.exr"), file("little.exr"));
  EXPECT_GE(levels, 0.0);
  EXPECT_LE(levels, 0.05);
}

TEST_F(LargeVolume, packedIsDrawnInLittleMemoryToo) {
  if (!hasRoom(2.5 * largeBytes))
    GTEST_SKIP() << "needs 3.7 GB of disk in " << place;
  const std::string volume = file("large.nii.gz");
  const gzFile out = gzopen(volume.c_str(), "wb1");
  const std::string header = niftiHeader(large, 4, 16);
  gzwrite(out, header.data(), static_cast<unsigned>(header.size()));
  forEachSlice(large, [&](const char* bytes, std::size_t count) {
    gzwrite(out, bytes, static_cast<unsigned>(count));
  });
  ASSERT_EQ(gzclose(out), Z_OK);
  const WatchedRun little = watched(folder.path, renderOf(volume, file("little.png"), {"--memory", "300"}));
  ASSERT_EQ(little.status, 0) << little.err;
  RecordProperty("ownMB", std::to_string(little.ownBytes / 1000000));
  EXPECT_LE(little.ownBytes, 450'000'000u);
}

TEST_F(LargeVolume, whoseFileShrinksMeanwhileGivesNoPicture) {
  const std::array<int, 3> dims = {512, 512, 400};
  if (!hasRoom(3e8))
    GTEST_SKIP() << "needs 0.3 GB of disk in " << place;
  const std::string volume = file("shrinking.nii");
  writeNifti(volume, dims);
  bool isCut = false;
  // Once the program has mapped the file, whatever it does with it.
  const auto cut = [&](pid_t process) {
    if (isCut || test::bytesOfFile("/proc/" + std::to_string(process) + "/maps").find("shrinking.nii") ==
                     std::string::npos)
      return;
    isCut = true;
    fs::resize_file(volume, 100000);
  };
  const WatchedRun run = watched(folder.path, renderOf(volume, file("a.png"), {"--memory", "64"}), cut);
  ASSERT_TRUE(isCut);
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_NE(run.err.find("shrinking.nii: it became shorter while it was read"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(file("a.png")));
}

// Holes but for a cube of so many voxels whose bytes are all `byte`. False where the file system has no
// holes.
bool writeHoles(const std::string& path, const std::array<int, 3>& dims, int bytesPerVoxel, int cube,
                char byte) {
  std::ofstream(path, std::ios::binary) << niftiHeader(dims, bytesPerVoxel == 1 ? 2 : 4, 8 * bytesPerVoxel);
  std::error_code failed;
  fs::resize_file(path, 352 + std::uintmax_t{1} * dims[0] * dims[1] * dims[2] * bytesPerVoxel, failed);
  std::fstream out(path, std::ios::binary | std::ios::in | std::ios::out);
  const std::string row(static_cast<std::size_t>(cube * bytesPerVoxel), byte);
  for (std::int64_t z = (dims[2] - cube) / 2; z < (dims[2] + cube) / 2; ++z)
    for (std::int64_t y = (dims[1] - cube) / 2; y < (dims[1] + cube) / 2; ++y) {
      out.seekp(352 + ((z * dims[1] + y) * dims[0] + (dims[0] - cube) / 2) * bytesPerVoxel);
      out.write(row.data(), static_cast<std::streamsize>(row.size()));
    }
  return !failed;
}

// 4.7 GB of 16 bits.
TEST_F(LargeVolume, ofHolesIsDrawnInLittleMemory) {
  const std::string volume = file("sparse.nii");
  if (!writeHoles(volume, {1300, 1300, 1400}, 2, 600, 3)) // 0x0303 are 771 HU
    GTEST_SKIP() << "this file system has no sparse files";
  const WatchedRun run = watched(folder.path, renderOf(volume, file("a.png"), {"--memory", "300"}));
  ASSERT_EQ(run.status, 0) << run.err;
  RecordProperty("ownMB", std::to_string(run.ownBytes / 1000000));
  EXPECT_LE(run.ownBytes, 450'000'000u);
}

TEST_F(LargeVolume, ofMoreThan31BitsOfVoxelsIsTold) {
  const std::string volume = file("sparse.nii");
  if (!writeHoles(volume, {3000, 3000, 3000}, 1, 400, '\xc8'))
    GTEST_SKIP() << "this file system has no sparse files";
  const WatchedRun info = watched(folder.path, {"info", volume, "--json", "--memory", "1000"});
  ASSERT_EQ(info.status, 0) << info.err;
  EXPECT_NE(info.err.find("3000"), std::string::npos) << info.err;
  EXPECT_LE(info.ownBytes, 1'000'000'000u);
  RecordProperty("ownMBOfInfo", std::to_string(info.ownBytes / 1000000));
}

} // namespace
} // namespace limn
