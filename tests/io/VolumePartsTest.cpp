// SPDX-License-Identifier: GPL-3.0-or-later
// What one of several processes keeps of a file of any kind: the bits of the whole, and what of the file it
// reads.
#include "io/VolumeBytes.h"
#include "io/dicom/SyntheticSeries.h"
#include "io/reading/PartOfVolume.h"
#include "support/LargeSeries.h"

#include <fstream>

namespace limn {
namespace {

using namespace test;

namespace fs = std::filesystem;

constexpr glm::ivec3 partsDims(90, 80, 70);
constexpr std::size_t partsVoxels = std::size_t{90} * 80 * 70;

// Numbers without a pattern, of which a wrong row or slice would show.
template <class T>
std::vector<T> scattered(std::size_t count = partsVoxels) {
  std::vector<T> values;
  std::uint32_t random = 7;
  for (std::size_t i = 0; i < count; ++i) {
    random = 1664525u * random + 1013904223u;
    values.push_back(static_cast<T>(random >> 20));
  }
  return values;
}

std::string nrrdHeader(const std::string& type, const std::string& more) {
  return "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: 90 80 70\nspacings: 1 1 2\n" + more + "\n\n";
}

// What this process has asked the system to read, bytes.
double readSoFar() {
  std::ifstream counts("/proc/self/io");
  std::string word;
  double bytes = -1.0;
  while (counts >> word && word != "rchar:") {
  }
  counts >> bytes;
  return bytes;
}

// A part of a volume, and what was found of it before others told of theirs.
struct ReadPart {
  std::shared_ptr<const Volume> volume;
  VoxelFacts found;
  double bytesRead = 0.0;
};

struct Wish {
  VoxelBox held;
  VoxelBox own;
  MemoryBudget memory = MemoryBudget(1'000'000'000);
};

ReadPart readPart(const fs::path& path, const Wish& wish, const std::optional<VoxelFacts>& all = {}) {
  ReadPart part;
  PartWanted wanted;
  wanted.share = [&](const Grid&, bool) { return PartWanted::Share{wish.held, wish.own}; };
  wanted.memory = wish.memory;
  wanted.joined = [&](const VoxelFacts& own) {
    part.found = own;
    return all.value_or(own);
  };
  ReadOptions options;
  options.part = std::make_shared<const PartWanted>(std::move(wanted));
  const double before = readSoFar();
  part.volume = readVolume(path, options);
  part.bytesRead = readSoFar() - before;
  return part;
}

// Three slabs with neighbours around them, and a box in the middle.
std::vector<Wish> wishesFor(const glm::ivec3& dims) {
  std::vector<Wish> wishes;
  for (int n = 0; n < 3; ++n) {
    const int first = dims.z * n / 3, end = dims.z * (n + 1) / 3;
    wishes.push_back({{{0, 0, std::max(first - 1, 0)}, {dims.x, dims.y, std::min(end + 1, dims.z)}},
                      {{0, 0, first}, {dims.x, dims.y, end}}});
  }
  return wishes;
}

void expectPart(const ReadPart& part, const Volume& whole, const VoxelBox& held) {
  const Volume& volume = *part.volume;
  EXPECT_TRUE(volume.stored() == cutOut(whole.stored(), whole.grid().dims, held));
  EXPECT_EQ(volume.grid(), whole.grid());
  EXPECT_EQ(volume.rescale(), whole.rescale());
  EXPECT_EQ(volume.range(), whole.range());
  EXPECT_EQ(volume.invalidVoxels(), whole.invalidVoxels());
  EXPECT_EQ(volume.storedCounts().counts, whole.storedCounts().counts);
  const glm::ivec3 size = held.upper - held.lower;
  if (whole.invalidVoxels() == 0)
    return;
  for (int k = 0; k < size.z; ++k)
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i)
        ASSERT_EQ(volume.invalidMask()[voxelOffset(size, i, j, k)],
                  whole.invalidMask()[voxelOffset(whole.grid().dims, held.lower.x + i, held.lower.y + j,
                                                  held.lower.z + k)]);
}

// So much is read for a header, at once, and of a file of this size that may be all of it: reading its voxels
// as a whole beside it shows all the same. Of VTK files it is a few buffers of 2¹⁶ bytes.
constexpr double headerBytes = 1 << 20, vtkHeaderBytes = 1 << 17;

enum class Reads { itsPart, all };

// Three parts make the whole, bit for bit; so does a box in the middle.
void expectParts(const fs::path& path, double fileBytes, Reads reads, double ofHeader = headerBytes) {
  SCOPED_TRACE(path.filename());
  const auto whole = readVolume(path);
  const glm::ivec3 dims = whole->grid().dims;
  const std::vector<Wish> wishes = wishesFor(dims);
  VoxelFacts all;
  for (const Wish& wish : wishes)
    all = joined(all, readPart(path, wish).found);
  for (const Wish& wish : wishes) {
    const ReadPart part = readPart(path, wish, all);
    expectPart(part, *whole, wish.held);
    EXPECT_EQ(part.volume->part()->own.lower, wish.own.lower);
    EXPECT_EQ(warns(*part.volume, "only be read from its start"), reads == Reads::all);
    if (reads == Reads::itsPart) {
      EXPECT_LE(part.bytesRead, 0.5 * fileBytes + ofHeader);
    }
    // The same part read again, in other voxels and in all.
    const VoxelBox other{{1, 0, 1}, dims - glm::ivec3(1, 0, 1)};
    const auto again = part.volume->part()->reread(other);
    EXPECT_TRUE(again->stored() == cutOut(whole->stored(), dims, other));
    EXPECT_EQ(again->range(), whole->range());
    EXPECT_TRUE(part.volume->part()->reread(allVoxels(whole->grid()))->stored() == whole->stored());
  }
  const VoxelBox middle{dims / 4, dims / 4 + dims / 2};
  expectPart(readPart(path, {middle, middle}, all), *whole, middle);
}

class PartsOfFiles : public testing::Test {
protected:
  fs::path in(const std::string& name) const { return folder.path() / name; }

  void expectParts(const std::string& name, const std::string& bytes, Reads reads,
                   double ofHeader = headerBytes) const {
    writeBytes(in(name), bytes);
    limn::expectParts(in(name), static_cast<double>(bytes.size()), reads, ofHeader);
  }

  const TemporaryFolder folder;
};

// In this machine's order of bytes or the other, in types that are kept or become others, and at places where
// numbers may not lie.
TEST_F(PartsOfFiles, rawOnesAreReadInTheirPlace) {
  const std::vector<std::int16_t> shorts = scattered<std::int16_t>();
  expectParts("little.nrrd", nrrdHeader("int16", "endian: little\nencoding: raw") + bytesOf(shorts),
              Reads::itsPart);
  expectParts("odd.nrrd", nrrdHeader("int16", "endian: little\nencoding: raw\n#") + bytesOf(shorts),
              Reads::itsPart);
  expectParts("big.nrrd", nrrdHeader("int16", "endian: big\nencoding: raw") + bytesOf(shorts, true),
              Reads::itsPart);
  expectParts("long.nrrd",
              nrrdHeader("uint64", "endian: big\nencoding: raw") + bytesOf(scattered<std::uint64_t>(), true),
              Reads::itsPart);
  std::vector<float> floats = scattered<float>();
  for (std::size_t i = 0; i < floats.size(); i += 997)
    floats[i] = NAN;
  expectParts("floats.nrrd", nrrdHeader("float", "endian: little\nencoding: raw") + bytesOf(floats),
              Reads::itsPart);
  std::string colours = nrrdHeader("uint8", "encoding: raw");
  colours.replace(colours.find("dimension: 3\nsizes: 90"), 22, "dimension: 4\nsizes: 3 90");
  colours.replace(colours.find("spacings: 1"), 11, "kinds: RGB-color domain domain domain\nspacings: nan 1");
  expectParts("colours.nrrd", colours + bytesOf(scattered<std::uint8_t>(3 * partsVoxels)), Reads::itsPart);
  const std::string legacy =
      "# vtk DataFile Version 3.0\na title\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 90 80 70\nORIGIN 0 "
      "0 0\nSPACING 2 3 4\nPOINT_DATA 504000\nSCALARS values short 1\nLOOKUP_TABLE default\n";
  expectParts("legacy.vtk", legacy + bytesOf(shorts, true), Reads::itsPart, vtkHeaderBytes);
  const std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"BigEndian\" "
      "header_type=\"UInt32\">\n<ImageData WholeExtent=\"0 89 0 79 0 69\" Origin=\"0 0 0\" Spacing=\"2 3 "
      "4\">\n<Piece Extent=\"0 89 0 79 0 69\"><PointData Scalars=\"v\"><DataArray type=\"Int16\" Name=\"v\" "
      "format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>\n<AppendedData encoding=\"raw\">_";
  expectParts("appended.vti",
              xml + bytesOf<std::uint32_t>({2 * partsVoxels}, true) + bytesOf(shorts, true) +
                  "</AppendedData></VTKFile>",
              Reads::itsPart, vtkHeaderBytes);
}

// They say so, and keep no more nevertheless.
TEST_F(PartsOfFiles, compressedOnesAndTextAreReadFromTheirStart) {
  const std::vector<std::int16_t> shorts = scattered<std::int16_t>();
  expectParts("packed.nrrd",
              nrrdHeader("int16", "endian: big\nencoding: gzip") + deflated(bytesOf(shorts, true)),
              Reads::all);
  std::string text = nrrdHeader("int16", "encoding: text");
  for (const std::int16_t value : shorts)
    text += std::to_string(value) + ' ';
  expectParts("text.nrrd", text, Reads::all);
}

// What ends early is found by every part, though the end is another's.
TEST_F(PartsOfFiles, thatEndEarlyAreRefusedWhateverTheirPart) {
  const Wish first{{{0, 0, 0}, {90, 80, 20}}, {{0, 0, 0}, {90, 80, 20}}};
  const std::string bytes = bytesOf(scattered<std::int16_t>());
  const std::string half = bytes.substr(0, bytes.size() / 2);
  writeBytes(in("raw.nrrd"), nrrdHeader("int16", "endian: little\nencoding: raw") + half);
  EXPECT_THROW(readPart(in("raw.nrrd"), first), Error);
  writeBytes(in("packed.nrrd"), nrrdHeader("int16", "endian: little\nencoding: gzip") + deflated(half));
  EXPECT_THROW(readPart(in("packed.nrrd"), first), Error);
  std::string broken = deflated(bytes);
  broken[broken.size() - 6] ^= 1; // of the check sum
  writeBytes(in("broken.nrrd"), nrrdHeader("int16", "endian: little\nencoding: gzip") + broken);
  EXPECT_THROW(readPart(in("broken.nrrd"), first), Error);
}

// Files of other slices are not opened for their pixels: a third of 170 slices is 57, and two neighbours.
TEST_F(PartsOfFiles, ofSeriesAreTheirSlices) {
  writeLargeSeries(in("series"));
  limn::expectParts(in("series"), test::largeBytes, Reads::itsPart);
  writeLargeSeries(in("rescaled"), {.hasRescales = true});
  limn::expectParts(in("rescaled"), test::largeBytes, Reads::itsPart);
}

TEST_F(PartsOfFiles, ofStacksAreTheirPictures) {
  fs::create_directory(in("noise"));
  constexpr int side = 512, slices = 36;
  const std::vector<std::uint16_t> noise = scattered<std::uint16_t>(std::size_t{side} * side + slices);
  for (int k = 0; k < slices; ++k) {
    const std::string name = (in("noise") / (std::to_string(k) + ".png")).string();
    const auto out = OIIO::ImageOutput::create(name);
    ASSERT_TRUE(out && out->open(name, OIIO::ImageSpec(side, side, 1, OIIO::TypeDesc::UINT16)) &&
                out->write_image(OIIO::TypeDesc::UINT16, noise.data() + k) && out->close());
  }
  // Whether a picture is whole is seen before it is decoded, so its bytes are read twice.
  const double before = readSoFar();
  readVolume(in("noise"));
  limn::expectParts(in("noise"), readSoFar() - before, Reads::itsPart);
  ASSERT_TRUE(writeLargeStack(in("pages.tif")));
  limn::expectParts(in("pages.tif"), 1e9, Reads::itsPart); // of small pages most is what says where they lie
  // What is wrong with a slice is said by whose it is.
  const std::vector<Wish> wishes = wishesFor({side, side, slices});
  fs::resize_file(in("noise") / "30.png", 1000);
  EXPECT_NO_THROW(readPart(in("noise"), wishes.front()));
  EXPECT_THROW(readPart(in("noise"), wishes.back()), Error);
}

// What lies in other slices counts: padding, signs, and bits that no value has.
TEST_F(PartsOfFiles, ofSlicesKnowOfThoseThatOthersRead) {
  for (int number = 1; number <= 9; ++number)
    slice(number, number)
        .us(0x00280101, {12})
        .us(0x00280102, {11})
        .us(0x00280103, {0})
        .us(0x00280120, {304})
        .pixels(std::vector<std::uint16_t>{static_cast<std::uint16_t>(100 + number), 200, 304,
                                           static_cast<std::uint16_t>(number == 9 ? 0x1005 : 5), 500,
                                           static_cast<std::uint16_t>(number % 2 == 0 ? 304 : 7)})
        .write(in("padded") / std::to_string(number));
  const auto whole = readVolume(in("padded"));
  EXPECT_EQ(whole->invalidVoxels(), 13u);
  EXPECT_TRUE(warns(*whole, "bits were ignored"));
  limn::expectParts(in("padded"), 1e9, Reads::itsPart);
  const Wish first = wishesFor(whole->grid().dims).front();
  EXPECT_FALSE(warns(*readPart(in("padded"), first).volume, "bits were ignored"));
  VoxelFacts all;
  for (const Wish& wish : wishesFor(whole->grid().dims))
    all = joined(all, readPart(in("padded"), wish).found);
  EXPECT_TRUE(warns(*readPart(in("padded"), first, all).volume, "bits were ignored"));
}

// What must be straightened is held whole, and says so.
TEST_F(PartsOfFiles, ofSlicesThatAreStraightenedAreHeldWhole) {
  writeLargeSeries(in("sheared"), {.shearMm = 0.5});
  const ReadPart part = readPart(in("sheared"), {{{0, 0, 0}, {9, 9, 9}}, {{0, 0, 0}, {9, 9, 9}}});
  EXPECT_FALSE(part.volume->part());
  EXPECT_TRUE(warns(*part.volume, "reads and keeps all of them"));
}

// Where not even the part fits into memory, it lies on the disk; raw voxels stay where they are.
TEST_F(PartsOfFiles, thatDoNotFitIntoMemoryLieOnTheDisk) {
  writeLargeSeries(in("series"));
  writeLargeVolume(in("large.mhd"));
  for (const char* name : {"series", "large.mhd"}) {
    SCOPED_TRACE(name);
    const auto whole = readVolume(in(name));
    const VoxelBox most{{0, 0, 1}, whole->grid().dims};
    const ReadPart part = readPart(in(name), {most, most, MemoryBudget(MemoryBudget::least)});
    ASSERT_TRUE(part.volume->room());
    const bool isRaw = std::string_view(name) != "series";
    EXPECT_EQ(part.volume->room()->taken() > 0, !isRaw);
    EXPECT_TRUE(part.volume->stored() ==
                cutOut(whole->stored(), whole->grid().dims, part.volume->part()->box));
  }
}

} // namespace
} // namespace limn
