// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Room.h"

#include "scene/basics/Error.h"
#include "scene/basics/MemoryBudget.h"
#include "scene/volume/Volume.h"
#include "support/Sanitizers.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/mman.h>

#include <cstdlib>
#include <fstream>
#include <numeric>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t enough = Room::smallest; // of bytes or larger elements, to lie on disk

// Bytes of this process's memory that no file backs.
std::uint64_t ownMemory() {
  std::ifstream lines("/proc/self/status");
  for (std::string word; lines >> word;)
    if (std::uint64_t kibibytes = 0; word == "RssAnon:" && lines >> kibibytes)
      return kibibytes * 1024;
  return 0;
}

// What sanitizers note for so many bytes that are touched: AddressSanitizer an eighth, ThreadSanitizer four
// times as much, and as much as an eighth beside it.
constexpr std::size_t notedFor(std::size_t bytes) {
#ifdef __SANITIZE_THREAD__
  return 4 * bytes + bytes / 8;
#else
  return test::isSanitised ? bytes / 8 : 0;
#endif
}

TEST(Room, arraysLieOnDiskAndAreNotOwnMemory) {
  const auto room = std::make_shared<Room>();
  const std::size_t bytes = std::size_t{64} << 20;
  const std::uint64_t before = ownMemory();
  ASSERT_GT(before, 0u) << "the system tells no RssAnon";
  RoomVector<std::uint8_t> filled(bytes, std::uint8_t{7}, room);
  EXPECT_EQ(room->taken(), bytes);
  EXPECT_LT(ownMemory(), before + bytes / 8 + notedFor(bytes));
  EXPECT_EQ(std::accumulate(filled.begin(), filled.end(), std::uint64_t{0}), 7 * bytes);
  filled = RoomVector<std::uint8_t>();
  EXPECT_EQ(room->taken(), 0u);
}

TEST(Room, withoutOneArraysLieInMemory) {
  RoomVector<int> values(enough, 3);
  EXPECT_EQ(values.get_allocator().room(), nullptr);
  EXPECT_EQ(values.back(), 3);
}

TEST(Room, smallArraysNeedNoFile) {
  const auto room = std::make_shared<Room>();
  const RoomVector<std::uint8_t> values(Room::smallest - 1, std::uint8_t{1}, room);
  EXPECT_EQ(room->taken(), 0u);
  EXPECT_EQ(values.back(), 1);
}

TEST(Room, copiesLieInTheSameRoomAndOutliveTheirOwner) {
  auto room = std::make_shared<Room>();
  RoomVector<int> copy;
  {
    const RoomVector<int> values(enough, 5, room);
    copy = values;
    EXPECT_EQ(room->taken(), 2 * enough * sizeof(int));
  }
  EXPECT_EQ(copy.get_allocator().room(), room);
  EXPECT_EQ(room->taken(), enough * sizeof(int));
  room.reset();
  EXPECT_EQ(copy.back(), 5);
}

TEST(Room, elementsWithoutAValueAreNotFilled) {
  const auto room = std::make_shared<Room>();
  const RoomVector<int> values(enough, room);
  EXPECT_EQ(values.front(), 0) << "a new file holds zeros";
}

TEST(Room, holdsVoxelsThatMayBeWritten) {
  const auto room = std::make_shared<Room>();
  StoredVoxels<int> voxels(RoomVector<int>(enough, 1, room));
  voxels.writable()[0] = 9;
  EXPECT_EQ(voxels[0], 9);
  EXPECT_EQ(room->taken(), enough * sizeof(int)) << "changed in their place";
}

TEST(Room, takesTheCopyOfVoxelsThatCannotBeWritten) {
  const auto mapped = std::make_shared<const std::vector<int>>(enough, 4);
  const auto room = std::make_shared<Room>();
  StoredVoxels<int> voxels(std::span<const int>(*mapped), mapped);
  voxels.writable(room)[1] = 9;
  EXPECT_EQ(mapped->at(1), 4);
  EXPECT_EQ(voxels[0], 4);
  EXPECT_EQ(voxels[1], 9);
  EXPECT_EQ(room->taken(), enough * sizeof(int));
}

TEST(Room, takesTheMaskOfAVolumesInvalidVoxels) {
  const auto room = std::make_shared<Room>();
  Grid grid;
  grid.dims = {128, 64, 64};
  std::vector<std::int16_t> stored(std::size_t{128} * 64 * 64, 5);
  stored[100] = -1000;
  const Volume volume(grid, stored, {}, PaddingRange{-1000.0, -1000.0}, {}, {}, room);
  EXPECT_EQ(volume.room(), room);
  EXPECT_EQ(room->taken(), stored.size() / 8);
  EXPECT_TRUE(volume.invalidMask()[100]);
  EXPECT_FALSE(volume.invalidMask()[101]);
}

TEST(Room, leavesNothingInItsFolder) {
  const test::TemporaryFolder folder;
  const auto room = std::make_shared<Room>(folder.path());
  const RoomVector<int> values(enough, 1, room);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Room, aDiskThatIsTooSmallIsOneSentence) {
  const auto room = std::make_shared<Room>();
  try {
    room->take(std::size_t{1} << 60);
    FAIL() << "no disk is so large";
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_TRUE(sentence.starts_with("Cannot keep the volume's data in " + room->folder().string() +
                                     ": they need 1152921504.6 GB and "))
        << sentence;
    EXPECT_NE(sentence.find("set TMPDIR"), std::string::npos) << sentence;
  }
  EXPECT_EQ(room->taken(), 0u);
}

TEST(Room, aFolderThatIsNotThereIsOneSentence) {
  const test::TemporaryFolder folder;
  const auto room = std::make_shared<Room>(folder.path() / "nowhere");
  try {
    room->take(enough);
    FAIL() << "there is no such folder";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos) << error.what();
  }
}

TEST(Room, neverLiesInMemory) {
  std::error_code unknown;
  if (!fs::is_directory("/dev/shm", unknown))
    GTEST_SKIP() << "this machine has no /dev/shm";
  const char* old = std::getenv("TMPDIR");
  const std::string kept = old ? old : "";
  ::setenv("TMPDIR", "/dev/shm", 1);
  const fs::path chosen = Room::chosenFolder();
  if (old)
    ::setenv("TMPDIR", kept.c_str(), 1);
  else
    ::unsetenv("TMPDIR");
  EXPECT_EQ(chosen, "/var/tmp");
}

// A file of so many bytes, each 7.
fs::path fileOf(const test::TemporaryFolder& folder, std::size_t bytes) {
  fs::path file = folder.path() / "voxels";
  std::ofstream(file, std::ios::binary) << std::string(bytes, '\7');
  return file;
}

TEST(Room, mapsAFileAtAnyOffset) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "voxels";
  std::string bytes(20000, '\0');
  std::iota(bytes.begin(), bytes.end(), '\0');
  std::ofstream(file, std::ios::binary) << bytes;
  const auto room = std::make_shared<Room>();
  const auto mapped = room->mapped(file, 5003, 14000);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(mapped.get()), 14000), bytes.substr(5003, 14000));
  EXPECT_TRUE(room->isWhole());
  EXPECT_EQ(room->taken(), 0u);
}

TEST(Room, aMappedFileThatShrinksReadsAsZerosAndIsNotWhole) {
  const test::TemporaryFolder folder;
  const std::size_t bytes = std::size_t{4} << 20;
  const fs::path file = fileOf(folder, bytes);
  const auto room = std::make_shared<Room>();
  const auto mapped = room->mapped(file, 0, bytes);
  fs::resize_file(file, 4096);
  EXPECT_EQ(std::to_integer<int>(mapped.get()[0]), 7);
  for (std::size_t at = 4096; at < bytes; at += 1000)
    ASSERT_EQ(std::to_integer<int>(mapped.get()[at]), 0) << at;
  EXPECT_FALSE(room->isWhole());
  fs::resize_file(file, bytes);
  EXPECT_FALSE(room->isWhole()) << "what was read remains wrong";
}

TEST(Room, aMappedFileThatLosesItsLastByteIsNotWhole) {
  const test::TemporaryFolder folder;
  const fs::path file = fileOf(folder, 5000);
  const auto room = std::make_shared<Room>();
  const auto mapped = room->mapped(file, 0, 5000);
  EXPECT_TRUE(room->isWhole());
  fs::resize_file(file, 4999);
  EXPECT_EQ(std::to_integer<int>(mapped.get()[4999]), 0) << "no signal tells of it";
  EXPECT_FALSE(room->isWhole());
}

TEST(Room, doesNotMapMoreThanAFileHolds) {
  const test::TemporaryFolder folder;
  const fs::path file = fileOf(folder, 5000);
  const auto room = std::make_shared<Room>();
  EXPECT_THROW(room->mapped(file, 1, 5000), Error);
  EXPECT_THROW(room->mapped(file, 6000, 1), Error);
  EXPECT_THROW(room->mapped(folder.path() / "none", 0, 1), Error);
}

using MappingGuardDeathTest = ::testing::Test;

TEST(MappingGuardDeathTest, leavesOtherMappingsToTheSystem) {
  const test::TemporaryFolder folder;
  const fs::path file = fileOf(folder, 100000);
  const auto room = std::make_shared<Room>();
  const auto mapped = room->mapped(file, 0, 100000);
  const Descriptor other(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  auto* begin =
      static_cast<volatile char*>(::mmap(nullptr, 100000, PROT_READ, MAP_SHARED, other.number(), 0));
  fs::resize_file(file, 0);
  EXPECT_DEATH(static_cast<void>(begin[50000]), "");
  ::munmap(const_cast<char*>(begin), 100000);
}

TEST(MemoryBudget, isHalfOfWhatIsFree) {
  const auto free = freeMemory();
  ASSERT_TRUE(free) << "the system does not tell";
  EXPECT_NEAR(static_cast<double>(MemoryBudget().bytes()), static_cast<double>(*free) / 2,
              static_cast<double>(*free) / 4);
}

TEST(MemoryBudget, holdsVoxelsThatLeaveRoomForEngines) {
  EXPECT_DOUBLE_EQ(MemoryBudget(300).voxelBytes(), 100.0);
}

} // namespace
} // namespace limn
