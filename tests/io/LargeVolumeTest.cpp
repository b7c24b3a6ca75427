// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/VolumeReader.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>

namespace limn {
namespace {

namespace fs = std::filesystem;

// Larger than a third of the least memory.
constexpr int largeSide = 256;
constexpr std::size_t largeCount = std::size_t{largeSide} * largeSide * largeSide;

std::vector<std::int16_t> largeRamp() {
  std::vector<std::int16_t> voxels(largeCount);
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = static_cast<std::int16_t>(i * 7919 % 30011);
  return voxels;
}

template <class T>
std::string rawBytes(const std::vector<T>& voxels) {
  return {reinterpret_cast<const char*>(voxels.data()), voxels.size() * sizeof(T)};
}

std::string bytesSwapped(std::string bytes) {
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
    std::swap(bytes[i], bytes[i + 1]);
  return bytes;
}

std::string largeHeader(const std::string& type, const std::string& more = {}) {
  const std::string n = std::to_string(largeSide);
  return "ObjectType = Image\nNDims = 3\nDimSize = " + n + " " + n + " " + n +
         "\nElementSpacing = 1 1 1\nElementType = " + type + "\n" + more;
}

// Headers may be of any length; voxels are mapped where numbers may lie.
std::string withLocalData(const std::string& header, std::size_t remainder) {
  std::string comment = "Comment = ";
  const std::string end = "\nElementDataFile = LOCAL\n";
  while ((comment.size() + header.size() + end.size()) % 8 != remainder)
    comment += 'x';
  return comment + "\n" + header.substr(0, header.size() - 1) + end;
}

class LargeVolume : public ::testing::Test {
protected:
  fs::path written(const std::string& name, const std::string& bytes) const {
    const fs::path file = folder.path() / name;
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }

  static std::shared_ptr<const Volume> read(const fs::path& file) {
    ReadOptions options;
    options.memory = MemoryBudget(MemoryBudget::least);
    return readVolume(file, options);
  }

  // It is the ramp, and so much of it lies on the disk.
  static void expectRamp(const fs::path& file, std::uint64_t onDisk) {
    const auto volume = read(file);
    ASSERT_TRUE(volume->room());
    EXPECT_EQ(volume->room()->taken(), onDisk) << file;
    EXPECT_EQ(volume->stored(), VoxelArray(StoredVoxels<std::int16_t>(largeRamp()))) << file;
    const auto isTold = [](const Message& warning) {
      return warning.english().starts_with(
          "The voxels are kept on disk while the volume is open (0.0 GB in ");
    };
    EXPECT_EQ(std::ranges::any_of(volume->info().warnings, isTold), onDisk > 0) << file;
    EXPECT_TRUE(volume->isWhole());
  }

  test::TemporaryFolder folder;
};

constexpr std::uint64_t largeBytes = largeCount * sizeof(std::int16_t);

TEST_F(LargeVolume, liesInMemoryWhereThereIsEnough) {
  const fs::path file = written("a.mha", withLocalData(largeHeader("MET_SHORT"), 0) + rawBytes(largeRamp()));
  ReadOptions options;
  options.memory = MemoryBudget(3 * largeBytes);
  EXPECT_FALSE(readVolume(file, options)->room());
}

TEST_F(LargeVolume, isMappedWhereItLiesAsItIsKept) {
  expectRamp(written("a.mha", withLocalData(largeHeader("MET_SHORT"), 0) + rawBytes(largeRamp())), 0);
  const std::string n = std::to_string(largeSide);
  written("b.raw", rawBytes(largeRamp()));
  expectRamp(written("b.nhdr", "NRRD0004\ntype: short\ndimension: 3\nsizes: " + n + " " + n + " " + n +
                                   "\nencoding: raw\nendian: little\ndata file: b.raw\n\n"),
             0);
}

TEST_F(LargeVolume, appendedToVtkXmlIsMapped) {
  const std::string extent = "\"0 255 0 255 0 255\"";
  std::string header = "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                       "header_type=\"UInt64\"><ImageData WholeExtent=" +
                       extent + " Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=" + extent +
                       "><PointData Scalars=\"s\"><DataArray type=\"Int16\" Name=\"s\" "
                       "format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>"
                       "<AppendedData encoding=\"raw\">_";
  if (header.size() % 2 != 0)
    header.insert(header.find("<ImageData"), " ");
  std::uint64_t length = largeBytes;
  std::string count(8, '\0');
  std::memcpy(count.data(), &length, 8);
  expectRamp(written("a.vti", header + count + rawBytes(largeRamp()) + "</AppendedData></VTKFile>"), 0);
}

TEST_F(LargeVolume, isDecodedToDiskWhereItLiesOtherwise) {
  expectRamp(written("odd.mha", withLocalData(largeHeader("MET_SHORT"), 1) + rawBytes(largeRamp())),
             largeBytes);
  expectRamp(
      written("big.mha", withLocalData(largeHeader("MET_SHORT", "BinaryDataByteOrderMSB = True\n"), 0) +
                             bytesSwapped(rawBytes(largeRamp()))),
      largeBytes);
  const std::string plain = rawBytes(largeRamp());
  std::string packed(compressBound(plain.size()), '\0');
  uLongf size = packed.size();
  ASSERT_EQ(compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                      reinterpret_cast<const Bytef*>(plain.data()), plain.size(), 1),
            Z_OK);
  packed.resize(size);
  expectRamp(
      written("packed.mha", withLocalData(largeHeader("MET_SHORT", "CompressedData = True\n"), 0) + packed),
      largeBytes);
}

TEST_F(LargeVolume, packedAndCutOffIsRefusedAndLeavesTheDisk) {
  const std::string plain = rawBytes(largeRamp());
  std::string packed(compressBound(plain.size()), '\0');
  uLongf size = packed.size();
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
            plain.size(), 1);
  packed.resize(size / 2);
  const fs::path file =
      written("cut.mha", withLocalData(largeHeader("MET_SHORT", "CompressedData = True\n"), 0) + packed);
  EXPECT_THROW(read(file), Error);
}

TEST_F(LargeVolume, mappedWithInvalidVoxelsIsCopiedAndTheFileStays) {
  std::vector<float> voxels(largeCount, 2.0f);
  voxels[5] = std::numeric_limits<float>::quiet_NaN();
  voxels[6] = 1.0f;
  const fs::path file = written("nan.mha", withLocalData(largeHeader("MET_FLOAT"), 0) + rawBytes(voxels));
  const std::string before = test::bytesOfFile(file);
  const auto volume = read(file);
  EXPECT_EQ(volume->value({5, 0, 0}), 1.0);
  EXPECT_TRUE(volume->invalidMask()[5]);
  EXPECT_EQ(volume->room()->taken(), largeCount * sizeof(float) + largeCount / 8) << "voxels and mask";
  EXPECT_EQ(test::bytesOfFile(file), before);
}

TEST_F(LargeVolume, whoseFileShrinksIsNotBelieved) {
  const fs::path file = written("a.mha", withLocalData(largeHeader("MET_SHORT"), 0) + rawBytes(largeRamp()));
  const auto volume = read(file);
  EXPECT_NO_THROW(requireWhole(file, *volume));
  fs::resize_file(file, 1 << 20);
  EXPECT_EQ(volume->value({255, 255, 255}), 0.0);
  try {
    requireWhole(file, *volume);
    FAIL() << "its voxels are gone";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    EXPECT_EQ(
        std::string(error.what()),
        "Cannot read " + file.string() +
            ": it became shorter while it was read, or its disk failed; copy or export the file again.");
  }
}

TEST_F(LargeVolume, thatNoDiskHoldsIsRefusedByName) {
  // Sparse, of the other order of bytes: it must be copied, and no disk has room for 400 TB.
  const fs::path file = written(
      "huge.mhd", "ObjectType = Image\nNDims = 3\nDimSize = 8000 8000 8000\nElementSpacing = 1 1 1\n"
                  "ElementType = MET_DOUBLE\nBinaryDataByteOrderMSB = True\nElementDataFile = huge.raw\n");
  const std::uintmax_t bytes = std::uintmax_t{8000} * 8000 * 8000 * 8;
  std::error_code failed;
  written("huge.raw", "");
  fs::resize_file(folder.path() / "huge.raw", bytes, failed);
  if (failed || fs::space("/var/tmp").available > bytes)
    GTEST_SKIP() << "no sparse file of 4 TB, or a disk that holds it";
  try {
    read(file);
    FAIL() << "there is no room";
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("huge.raw"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("4096.0 GB"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("set TMPDIR"), std::string::npos) << sentence;
  }
}

TEST_F(LargeVolume, needsSomeMemoryAllTheSame) {
  ReadOptions options;
  options.memory = MemoryBudget(MemoryBudget::least - 1);
  try {
    readVolume(written("a.mha", ""), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::usage);
    EXPECT_NE(std::string(error.what()).find("at least 64 MB"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace limn
