// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that many processes draw, started by mpirun as a user starts them.
#include "accuracy/ImageError.h"
#include "accuracy/sweep/AccuracySweep.h"
#include "io/reports/AccuracyFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/framing/Framing.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/DicomBuilder.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace limn {
namespace {

namespace fs = std::filesystem;

// mpirun refuses root unless told twice; it says what it thinks of a rank's exit status unless quiet.
const std::string mpirun =
    "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --quiet --oversubscribe "
    "--mca mpi_yield_when_idle 1";

fs::path ranksProgram() {
  return test::buildFolder() / "limn-mpi";
}

Image readPicture(const fs::path& file) {
  const auto input = OIIO::ImageInput::open(file.string());
  if (!input)
    throw std::runtime_error("no picture " + file.string());
  Image image({input->spec().width, input->spec().height});
  input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, image.pixels.data());
  return image;
}

class RanksTest : public testing::Test {
protected:
  void SetUp() override {
    if (std::system("command -v mpirun >/dev/null") != 0)
      GTEST_SKIP() << "needs mpirun (package openmpi-bin), which this machine does not have";
    if (!fs::exists(ranksProgram()))
      GTEST_SKIP() << "needs limn-mpi, which `./dev build mpi` builds";
  }

  /// limn-mpi on so many ranks.
  test::Outcome onRanks(int ranks, const std::string& arguments) const {
    const fs::path out = in("stdout"), err = in("stderr");
    const std::string command = "env -u DISPLAY HOME='" + folder.path().string() + "' " +
                                lineOf(ranks, arguments) + " >'" + out.string() + "' 2>'" + err.string() +
                                "' </dev/null";
    const int raw = std::system(command.c_str());
    return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, test::bytesOfFile(out), test::bytesOfFile(err)};
  }

  std::string lineOf(int ranks, const std::string& arguments) const {
    return mpirun + " -n " + std::to_string(ranks) + " '" + ranksProgram().string() + "' " + arguments;
  }

  test::Outcome whole(const std::string& arguments) const {
    return test::runProgram(folder.path(), "render --engine cpu " + arguments);
  }

  fs::path in(const std::string& name) const { return folder.path() / name; }
  std::string quoted(const std::string& name) const { return "'" + in(name).string() + "'"; }

  /// What one process draws.
  Image byOne(const std::string& arguments) const {
    const test::Outcome one = whole(arguments + " --quiet -o " + quoted("one.exr"));
    EXPECT_EQ(one.status, 0) << one.err;
    return readPicture(in("one.exr"));
  }

  /// Draws the same on ranks; how far they lie apart.
  ImageError error(int ranks, const std::string& arguments, const Image& expected) const {
    fs::remove(in("many.exr"));
    const test::Outcome many = onRanks(ranks, arguments + " --quiet -o " + quoted("many.exr"));
    EXPECT_EQ(many.status, 0) << many.err;
    EXPECT_EQ(many.err, "");
    return imageError(readPicture(in("many.exr")), expected);
  }

  ImageError error(int ranks, const std::string& arguments) const {
    return error(ranks, arguments, byOne(arguments));
  }

  const test::TemporaryFolder folder;
};

constexpr const char* projectionNames[] = {"composite", "mip",        "minip", "average",
                                           "xray",      "isosurface", "hybrid"};

// In levels, where rays end at the default 0.998: one process and the bricks leave out as much each.
constexpr double endingEarly = 2.0 * 0.002 * 255.0;

/// A scene file on the phantom, in which rays run to their end.
void writeScene(const fs::path& file, Projection projection, ShadingModel model) {
  Scene scene = headScene(phantomVolume({.spacingMm = 6.0}), model);
  scene.projection = projection;
  scene.image.width = 96;
  scene.image.height = 80;
  std::ofstream(file) << sceneToJson(scene, "phantom:6");
}

// Any number of ranks folds alike (tests/cpu/BricksTest): here it is MPI that folds.
TEST_F(RanksTest, drawWhatOneProcessDrawsInEveryProjection) {
  double worst = 0.0;
  for (int projection = 0; projection < 7; ++projection) {
    writeScene(in("scene.json"), static_cast<Projection>(projection), ShadingModel::robust);
    const Image expected = byOne(quoted("scene.json"));
    for (const int ranks :
         projection == 0 ? std::vector{1, 2, 3, 4, 7} : std::vector{2 + projection % 3, 7}) {
      const ImageError off = error(ranks, quoted("scene.json"), expected);
      EXPECT_LE(off.p99_9, 0.5) << projectionNames[projection] << ", " << ranks << " ranks";
      worst = std::max(worst, off.largest);
    }
  }
  std::cout << "ranks: at most " << worst << " levels from one process\n";
  EXPECT_LE(worst, 0.01); // the same samples, summed in another order
}

// Light crosses from brick to brick: refused in a sentence, and drawn where nothing of it shows.
TEST_F(RanksTest, refuseShadowsAndOcclusionAndDrawNeutralOnes) {
  const auto write = [&](double shadow, double occlusion, bool isHeadlight) {
    Scene scene = headScene(phantomVolume({.spacingMm = 6.0}), ShadingModel::classic);
    if (!isHeadlight)
      scene.shading.lightDirection = glm::dvec3(0.5, 0.7, -1.0);
    scene.shading.shadow = {shadow, 5.0};
    scene.shading.occlusion = {occlusion, 15.0};
    scene.image.width = scene.image.height = 48;
    std::ofstream(in("scene.json")) << sceneToJson(scene, "phantom:6");
  };
  for (const bool hasShadow : {true, false}) {
    write(hasShadow ? 0.8 : 0.0, hasShadow ? 0.0 : 0.8, false);
    const test::Outcome refused = onRanks(3, quoted("scene.json") + " --quiet -o " + quoted("none.png"));
    EXPECT_NE(refused.status, 0);
    EXPECT_NE(refused.err.find("Shadows and occlusion cannot be drawn in bricks"), std::string::npos)
        << refused.err;
    EXPECT_FALSE(fs::exists(in("none.png")));
  }
  write(0.0, 0.0, false);
  EXPECT_LE(error(3, quoted("scene.json")).p99_9, 0.5);
  write(0.8, 0.0, true); // of a headlight
  EXPECT_LE(error(3, quoted("scene.json")).p99_9, 0.5);
}

TEST_F(RanksTest, drawEveryModelAPresetTheBodyAndATolerance) {
  for (const ShadingModel model : localModels) {
    writeScene(in("scene.json"), Projection::composite, model);
    EXPECT_LE(error(3, quoted("scene.json")).p99_9, 0.5) << nameOf(model);
  }
  EXPECT_LE(error(4, quoted("scene.json") + " --keep body").p99_9, 0.5);
  EXPECT_LE(error(2, quoted("scene.json") + " --tolerance 1").p99_9, 1.0);
  EXPECT_LE(error(2, "phantom:6 --preset 'CT bone' --model compare --size 120x60 --view left").p99_9,
            endingEarly);
}

/// A volume that becomes brighter slice by slice.
void writeVolume(const fs::path& file, int width, int slices) {
  std::ofstream volume(file, std::ios::binary);
  volume << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: " << width << ' ' << width << ' ' << slices
         << "\nspacings: 8 8 8\nencoding: raw\n\n";
  for (int voxel = 0; voxel < width * width * slices; ++voxel)
    volume.put(static_cast<char>(255 * (voxel / (width * width)) / slices));
}

TEST_F(RanksTest, mayBeMoreThanSlices) {
  writeVolume(in("thin.nrrd"), 2, 3);
  EXPECT_LE(error(7, quoted("thin.nrrd") + " --size 60x60").p99_9, endingEarly);
}

// Each sample is one rank's, and each pixel is given once.
TEST_F(RanksTest, tellWhatTheyDid) {
  writeScene(in("scene.json"), Projection::composite, ShadingModel::classic);
  const auto samplesOf = [&](int ranks) {
    const test::Outcome outcome =
        onRanks(ranks, quoted("scene.json") + " --cost --quiet -o " + quoted("a.png"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    double all = 0.0;
    int told = 0;
    for (std::string line; std::getline(lines, line); ++told) {
      int rank = -1;
      double samples = 0.0, megabytes = 0.0, bytes = 0.0;
      EXPECT_EQ(std::sscanf(line.c_str(),
                            "rank %d: %lf samples in its brick, %lf MB of its own, %lf bytes folded", &rank,
                            &samples, &megabytes, &bytes),
                4)
          << line;
      EXPECT_EQ(rank, told);
      EXPECT_GT(megabytes, 1.0);
      EXPECT_EQ(bytes, 96.0 * 80.0 * 16.0);
      all += samples;
    }
    EXPECT_EQ(told, ranks);
    return all;
  };
  const double one = samplesOf(1);
  EXPECT_GT(one, 1e5);
  EXPECT_LE(samplesOf(4), one); // rays that meet nothing that shows in a brick are not counted there
}

TEST_F(RanksTest, refuseInOneSentenceAndWriteNothing) {
  const test::Outcome missing = onRanks(3, quoted("none.nrrd") + " --quiet -o " + quoted("a.png"));
  EXPECT_EQ(missing.status, 3);
  EXPECT_EQ(std::ranges::count(missing.err, '\n'), 1) << missing.err;
  EXPECT_NE(missing.err.find("none.nrrd"), std::string::npos);
  const test::Outcome slow = onRanks(2, "phantom:6 --engine reference -o " + quoted("a.png"));
  EXPECT_EQ(slow.status, 2);
  EXPECT_EQ(slow.err, "limn: Ranks draw with the CPU engine; leave --engine away or say cpu.\n");
  const test::Outcome unknown = onRanks(2, "phantom:6 --preset nothing -o " + quoted("a.png"));
  EXPECT_EQ(unknown.status, 2);
  EXPECT_EQ(std::ranges::count(unknown.err, '\n'), 1) << unknown.err;
  EXPECT_FALSE(fs::exists(in("a.png")));
}

// Ranks on other machines may lack the file, or have another one in its place: none waits for what never
// comes.
TEST_F(RanksTest, endWhereOneFindsAnotherVolumeOrNone) {
  writeVolume(in("head.nrrd"), 16, 16);
  const auto onTwo = [&](const std::string& first, const std::string& second) {
    const std::string drawn = " --size 20x20 --quiet -o " + quoted("a.png");
    return onRanks(1, first + drawn + " : -n 1 '" + ranksProgram().string() + "' " + second + drawn);
  };
  for (const auto& [first, second] : {std::pair{quoted("head.nrrd"), quoted("none.nrrd")},
                                      {quoted("none.nrrd"), quoted("head.nrrd")},
                                      {quoted("head.nrrd"), std::string("phantom:6")},
                                      {std::string("phantom:6"), quoted("head.nrrd")}}) {
    const test::Outcome outcome = onTwo(first, second);
    EXPECT_EQ(outcome.status, 3) << first << second;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_NE(
        outcome.err.find(first.find("phantom") == second.find("phantom") ? "none.nrrd" : "another volume"),
        std::string::npos)
        << outcome.err;
    EXPECT_FALSE(fs::exists(in("a.png")));
  }
}

TEST_F(RanksTest, doWhatTheGuidePrints) {
  std::istringstream page(test::bytesOfFile(test::sourceFolder() / "app/guide/many/README.md"));
  std::string command = "set -e\n";
  bool isCommand = false;
  for (std::string line; std::getline(page, line);)
    if (line == "```bash" || line == "```")
      isCommand = line == "```bash";
    else if (isCommand)
      command += line + "\n";
  ASSERT_NE(command.find("limn-mpi head.nrrd"), std::string::npos);
  ASSERT_NE(command.find("limn accuracy head.nrrd"), std::string::npos);
  writeVolume(in("head.nrrd"), 16, 16);
  const std::string home = "'" + folder.path().string() + "'";
  EXPECT_EQ(std::system(("cd " + home + " && export HOME=" + home + " PATH='" + test::buildFolder().string() +
                         "':\"$PATH\" OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                         "OMPI_MCA_rmaps_base_oversubscribe=1 && " +
                         command)
                            .c_str()),
            0);
  EXPECT_EQ(readPicture(in("head.png")).size, glm::ivec2(1024));
  EXPECT_TRUE(fs::exists(in("report/accuracy.html")));
}

// Errors against the picture of ranks are those against the one in double precision, to what floats move.
TEST_F(RanksTest, drawTheExactPictureOfAReport) {
  writeScene(in("scene.json"), Projection::composite, ShadingModel::enhanced);
  const auto reportOf = [&](const std::string& more) {
    const test::Outcome outcome = test::runProgram(folder.path(), "accuracy " + quoted("scene.json") +
                                                                      " --quick --size 48x40 --quiet " +
                                                                      more + " -o " + quoted("report"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return parseAccuracy(test::bytesOfFile(in("report/accuracy.json")), "accuracy.json");
  };
  const AccuracyReport inDouble = reportOf("");
  const AccuracyReport byRanks = reportOf("--exact-by \"" + lineOf(3, "") + "\"");
  EXPECT_FALSE(inDouble.reference.isInFloats);
  ASSERT_TRUE(byRanks.reference.isInFloats);
  ASSERT_TRUE(byRanks.reference.converged);
  ASSERT_EQ(byRanks.points.size(), inDouble.points.size());
  // A percentile differs by no more than the pictures do, and the largest difference of those is more than
  // their 99.9th percentile, which is what is promised: by a factor of 4 at most where that was measured.
  const double most = leastP99_9(inDouble.reference) + 4.0 * floatP99_9;
  for (std::size_t i = 0; i < inDouble.points.size(); ++i)
    EXPECT_NEAR(byRanks.points[i].error.p99_9, inDouble.points[i].error.p99_9, most) << i;
  const std::string page = test::bytesOfFile(in("report/accuracy.html"));
  EXPECT_NE(page.find("in single precision with error-controlled steps"), std::string::npos);
  EXPECT_NE(page.find("floats move by 0.010 levels at most"), std::string::npos);
}

TEST_F(RanksTest, orAnotherProgramThatDrawsSomethingElseIsNotBelieved) {
  writeScene(in("scene.json"), Projection::composite, ShadingModel::classic);
  const auto refusalOf = [&](const std::string& command) {
    const test::Outcome outcome = test::runProgram(folder.path(), "accuracy " + quoted("scene.json") +
                                                                      " --quick --quiet --exact-by \"" +
                                                                      command + "\" -o " + quoted("report"));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_FALSE(fs::exists(in("report/accuracy.json")));
    EXPECT_TRUE(fs::is_empty(in("report")));
    return outcome.err;
  };
  EXPECT_NE(refusalOf("true").find("drew no picture"), std::string::npos);
  const std::string limn = test::programPath() + " render --engine cpu";
  EXPECT_NE(refusalOf(limn + " --model robust").find("drew another scene"), std::string::npos);
  EXPECT_NE(refusalOf(limn + " --size 20x20").find("drew another scene"), std::string::npos);
}

/// The ids of the running ranks that were given a word.
std::vector<pid_t> ranksWith(const std::string& word) {
  std::vector<pid_t> found;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos)
      continue;
    std::ifstream file(entry.path() / "cmdline");
    std::string words; // an empty one of a process that ends meanwhile
    std::getline(file, words);
    if (fs::read_symlink(entry.path() / "exe", gone).filename() == "limn-mpi" &&
        words.find(word) != std::string::npos)
      found.push_back(std::stoi(name));
  }
  return found;
}

// The picture would take minutes: the rank dies while it is drawn.
TEST_F(RanksTest, endAllWhereOneIsKilledAndLeaveNoPicture) {
  const std::string picture = in("killed.png").string();
  std::ofstream(in("start.sh")) << "cd '" << folder.path().string() << "' && exec env HOME='"
                                << folder.path().string() << "' "
                                << lineOf(3, "phantom:2 --step 0.002 --size 3000x3000 --quiet -o '" +
                                                 picture + "'")
                                << " >/dev/null 2>&1\n";
  const pid_t run = fork();
  ASSERT_GE(run, 0);
  if (run == 0) {
    execl("/bin/sh", "sh", in("start.sh").c_str(), nullptr);
    _exit(127);
  }
  std::vector<pid_t> ranks;
  int ended = 0;
  while (ranks.size() < 3 && waitpid(run, &ended, WNOHANG) == 0)
    ranks = ranksWith(picture);
  ASSERT_EQ(ranks.size(), 3u) << "mpirun ended before it started its ranks";
  kill(ranks[1], SIGKILL);
  ASSERT_EQ(waitpid(run, &ended, 0), run);
  EXPECT_FALSE(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
  EXPECT_TRUE(ranksWith(picture).empty());
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().filename().string().find("killed"), std::string::npos) << entry.path();
}

constexpr int bigAcross = 512, bigSlices = 300;

/// A slice of a ball in Hounsfield units; all of them are 157 MB.
std::vector<std::int16_t> bigSlice(int k) {
  std::vector<std::int16_t> slice(bigAcross * bigAcross);
  for (int j = 0; j < bigAcross; ++j)
    for (int i = 0; i < bigAcross; ++i) {
      const double x = (i - 255.5) / 256, y = (j - 255.5) / 256, z = (k - 149.5) / 150;
      slice[static_cast<std::size_t>(j) * bigAcross + i] =
          static_cast<std::int16_t>(1500.0 - 2500.0 * std::min(1.0, std::sqrt(x * x + y * y + z * z)));
    }
  return slice;
}

void append(std::ofstream& file, const std::vector<std::int16_t>& voxels) {
  file.write(reinterpret_cast<const char*>(voxels.data()),
             static_cast<std::streamsize>(voxels.size() * sizeof(std::int16_t)));
}

/// Voxels that lie in a file as they are read.
void writeBigBall(const fs::path& folder) {
  std::ofstream(folder / "big.mhd") << "ObjectType = Image\nNDims = 3\nDimSize = 512 512 300\n"
                                       "ElementType = MET_SHORT\nElementSpacing = 0.5 0.5 1\n"
                                       "ElementByteOrderMSB = False\nElementDataFile = big.raw\n";
  std::ofstream voxels(folder / "big.raw", std::ios::binary);
  for (int k = 0; k < bigSlices; ++k)
    append(voxels, bigSlice(k));
}

/// The same as a DICOM series of a slice a file. Returns the bytes of all.
double writeBigSeries(const fs::path& folder) {
  test::DicomBuilder header;
  header.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2").text(0x00080018, "UI", "1.2.3.4.#####");
  header.text(0x00080060, "CS", "CT").text(0x0020000D, "UI", "1.2.3").text(0x0020000E, "UI", "1.2.3.4");
  header.text(0x00200032, "DS", "0\\0\\#####").text(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  header.text(0x00280030, "DS", "0.5\\0.5").us(0x00280002, {1}).text(0x00280004, "CS", "MONOCHROME2");
  header.us(0x00280010, {bigAcross}).us(0x00280011, {bigAcross}).us(0x00280100, {16}).us(0x00280101, {16});
  header.us(0x00280102, {15}).us(0x00280103, {1}).text(0x00281052, "DS", "0").text(0x00281053, "DS", "1");
  const std::string zeros = header.pixels(std::vector<std::int16_t>(bigAcross * bigAcross)).bytes();
  const std::size_t pixelBytes = std::size_t{2} * bigAcross * bigAcross;
  fs::create_directory(folder);
  for (int k = 0; k < bigSlices; ++k) {
    std::string start = zeros.substr(0, zeros.size() - pixelBytes);
    for (std::size_t at = 0; (at = start.find("#####", at)) != std::string::npos;)
      start.replace(at, 5, std::to_string(10000 + k));
    std::ofstream file(folder / (std::to_string(k) + ".dcm"), std::ios::binary);
    file << start;
    append(file, bigSlice(k));
  }
  return static_cast<double>(zeros.size()) * bigSlices;
}

struct RankSaid {
  double ownMb = 0.0;
  double bytesRead = 0.0;
  double tookMb = 0.0;
};

/// What each rank says of itself.
std::vector<RankSaid> saidBy(const test::Outcome& outcome) {
  std::vector<RankSaid> ranks;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    RankSaid said;
    EXPECT_EQ(
        std::sscanf(line.c_str(),
                    "rank %*d: %*f samples in its brick, %lf MB of its own, %*f bytes folded, %lf read, "
                    "took %lf MB at most",
                    &said.ownMb, &said.bytesRead, &said.tookMb),
        3)
        << line;
    ranks.push_back(said);
  }
  return ranks;
}

class BigVolume : public RanksTest {
protected:
  /// At three and four ranks a third or a quarter of the voxels each, what a brick needs around it, and what
  /// a process takes whatever it draws.
  void expectParts(const std::string& volume, double fileBytes) const {
    const std::string drawn = volume + " --preset 'CT bone' --size 64x64 --quiet --cost -o ";
    const test::Outcome one = onRanks(1, drawn + quoted("one.exr") + " --memory 100000");
    ASSERT_EQ(one.status, 0) << one.err;
    const RankSaid alone = saidBy(one).at(0);
    ASSERT_GT(alone.ownMb, 157.0) << "one process keeps the voxels";
    for (const int count : {3, 4}) {
      const test::Outcome many = onRanks(count, drawn + quoted("many.exr"));
      ASSERT_EQ(many.status, 0) << many.err;
      const std::vector<RankSaid> ranks = saidBy(many);
      ASSERT_EQ(ranks.size(), static_cast<std::size_t>(count));
      for (const RankSaid& rank : ranks) {
        std::cout << volume << ", alone " << alone.ownMb << " MB, at most " << alone.tookMb << "; one of "
                  << count << " ranks " << rank.ownMb / alone.ownMb << " and " << rank.tookMb / alone.tookMb
                  << " of that, and reads " << rank.bytesRead / fileBytes << " of the volume\n";
        EXPECT_LE(rank.ownMb, 0.45 * alone.ownMb);
        EXPECT_LE(rank.tookMb, 0.45 * alone.tookMb);
        EXPECT_LE(rank.bytesRead, 0.5 * fileBytes);
        EXPECT_GE(rank.bytesRead, fileBytes / count) << "its own voxels are read, not seen in a mapped file";
      }
      EXPECT_LE(imageError(readPicture(in("many.exr")), readPicture(in("one.exr"))).p99_9, endingEarly);
    }
  }
};

TEST_F(BigVolume, inAFileIsReadAndKeptInPartsOfLessThanHalf) {
  writeBigBall(folder.path());
  expectParts(quoted("big.mhd"), static_cast<double>(fs::file_size(in("big.raw"))));
}

TEST_F(BigVolume, inSlicesIsReadAndKeptInPartsOfLessThanHalf) {
  const double bytes = writeBigSeries(in("series"));
  expectParts(quoted("series"), bytes);
}

// A compressed one is read to its end by each, who keeps its part nevertheless and says so.
TEST_F(BigVolume, thatIsCompressedIsKeptInParts) {
  writeBigBall(folder.path());
  ASSERT_EQ(
      std::system(("gzip -1 '" + in("big.raw").string() + "' && cd '" + folder.path().string() +
                   "' && (printf 'NRRD0004\ntype: int16\ndimension: 3\nsizes: 512 512 300\nspacings: 0.5 "
                   "0.5 1\nendian: little\nencoding: gzip\n\n'; cat big.raw.gz) > big.nrrd")
                      .c_str()),
      0);
  const std::string drawn = quoted("big.nrrd") + " --preset 'CT bone' --size 64x64 --cost -o ";
  const test::Outcome one = onRanks(1, drawn + quoted("one.exr") + " --quiet --memory 100000");
  ASSERT_EQ(one.status, 0) << one.err;
  const test::Outcome many = onRanks(3, drawn + quoted("many.exr"));
  ASSERT_EQ(many.status, 0) << many.err;
  EXPECT_NE(many.err.find("every process reads all of it and keeps its part"), std::string::npos) << many.err;
  const std::string told = many.out.substr(many.out.find("rank 0"));
  for (const RankSaid& rank : saidBy({0, told, ""})) {
    std::cout << "compressed: " << rank.ownMb / saidBy(one).at(0).ownMb << " of the memory, reads "
              << rank.bytesRead / static_cast<double>(fs::file_size(in("big.nrrd"))) << " of the file\n";
    EXPECT_LE(rank.ownMb, 0.45 * saidBy(one).at(0).ownMb);
    EXPECT_LE(rank.tookMb, 0.45 * saidBy(one).at(0).tookMb);
  }
  EXPECT_LE(imageError(readPicture(in("many.exr")), readPicture(in("one.exr"))).p99_9, endingEarly);
}

/// Noise around a ball, in this machine's order of bytes or the other.
void writeNoisyBall(const fs::path& file, bool isSwapped) {
  constexpr int across = 40;
  std::ofstream volume(file, std::ios::binary);
  volume << "NRRD0004\ntype: float\ndimension: 3\nsizes: 40 40 40\nspacings: 1 1 1\nendian: "
         << (isSwapped ? "big" : "little") << "\nencoding: raw\n\n";
  std::uint32_t random = 1;
  for (int voxel = 0; voxel < across * across * across; ++voxel) {
    const double x = voxel % across - 20, y = voxel / across % across - 18, z = voxel / 1600 - 22;
    random = 1664525u * random + 1013904223u;
    auto value = static_cast<float>(std::max(0.0, 16.0 - std::sqrt(x * x + y * y + z * z)) +
                                    static_cast<double>(random >> 8) * 0x1p-24);
    if (voxel % 997 == 0)
      value = NAN;
    std::array<char, sizeof value> bytes{};
    std::memcpy(bytes.data(), &value, sizeof value);
    if (isSwapped)
      std::ranges::reverse(bytes);
    volume.write(bytes.data(), bytes.size());
  }
}

// Of floats the histogram is counted by all; what lies otherwise in the file is read and cut. A crop and long
// steps need other voxels than those that were read first; the body and a rest are found in the whole.
TEST_F(RanksTest, drawTheSameFromPartsOfAnyFile) {
  for (const bool isSwapped : {false, true}) {
    writeNoisyBall(in("noisy.nrrd"), isSwapped);
    EXPECT_LE(error(3, quoted("noisy.nrrd") + " --size 90x70").p99_9, endingEarly) << isSwapped;
    EXPECT_LE(error(3, quoted("noisy.nrrd") + " --size 90x70 --step 7 --model robust").p99_9, endingEarly);
    // Two pictures that keep a tolerance need not have the same steps: each is compared with the exact one.
    const Image exact = byOne(quoted("noisy.nrrd") + " --size 90x70 --tolerance 0.01");
    const std::string kept = quoted("noisy.nrrd") + " --size 90x70 --tolerance 1";
    EXPECT_LE(imageError(byOne(kept), exact).p99_9, 1.0);
    EXPECT_LE(error(4, kept, exact).p99_9, 1.0);
  }
  Scene scene;
  scene.transferFunction.points = {{0.5, glm::dvec3(0.2, 0.5, 0.9), 0.0}, {9.0, glm::dvec3(1.0), 0.7}};
  scene.volume = phantomVolume({.spacingMm = 20.0});
  scene.crop = {{0.3, 0.1, 0.0}, {1.0, 0.6, 0.8}};
  scene.keep.kind = Region::Kind::body;
  scene.image.width = scene.image.height = 80;
  std::ofstream(in("cropped.json")) << sceneToJson(scene, "noisy.nrrd");
  EXPECT_LE(error(3, quoted("cropped.json") + " --view left").p99_9, endingEarly);
}

} // namespace
} // namespace limn
