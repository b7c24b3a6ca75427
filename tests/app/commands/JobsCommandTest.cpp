// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/making/Jobs.h"
#include "scene/basics/Error.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>

// Many pictures: the commands that `limn jobs` prints, run by the engines that people have.

namespace limn {
namespace {

namespace fs = std::filesystem;

class Jobs : public testing::Test {
protected:
  test::Outcome run(const std::string& arguments) { return test::runProgram(folder.path(), arguments); }

  /// The lines for the arguments, as a file that engines read.
  fs::path written(const std::string& arguments) {
    const test::Outcome outcome = run("jobs " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const fs::path file = folder.path() / "jobs.txt";
    std::ofstream(file) << outcome.out;
    return file;
  }

  /// Runs a shell's line with the folder as its home and working directory.
  int shell(const std::string& line) {
    const std::string home = "'" + folder.path().string() + "'";
    return std::system(("cd " + home + " && export HOME=" + home + " && unset DISPLAY && " + line).c_str());
  }

  std::map<std::string, std::string> pictures(const char* below) const {
    std::map<std::string, std::string> bytes;
    if (fs::exists(folder.path() / below))
      for (const auto& entry : fs::directory_iterator(folder.path() / below))
        bytes[entry.path().filename().string()] = test::bytesOfFile(entry.path());
    return bytes;
  }

  std::string in(const char* below) const { return "'" + (folder.path() / below).string() + "'"; }

  const test::TemporaryFolder folder;
};

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::vector<std::string> namesOf(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const Job& job : jobsOf(sweep))
    names.push_back(fs::path(job.picture).filename().string());
  return names;
}

TEST(JobNames, tellEachPictureByWhatDiffers) {
  Sweep sweep;
  sweep.folder = "/pictures";
  sweep.volumes = {"/a/Head 1.nii.gz", "/b/series/"};
  sweep.presets = {"CT bone", "/looks/Warm Bone.vp.json"};
  sweep.views = {"left"};
  sweep.turntable = 12;
  const std::vector<std::string> names = namesOf(sweep);
  ASSERT_EQ(names.size(), 48u);
  EXPECT_EQ(names[0], "head-1_ct-bone_left_turn-00-of-12.png");
  EXPECT_EQ(names[11], "head-1_ct-bone_left_turn-11-of-12.png");
  EXPECT_EQ(names[47].substr(0, 7), "series_");
}

TEST(JobNames, takeAsMuchOfThePathAsTellsVolumesApart) {
  Sweep sweep;
  sweep.folder = "/pictures";
  sweep.volumes = {"/cohort/p1/head.nii.gz", "/cohort/p2/head.nii.gz"};
  EXPECT_EQ(namesOf(sweep), (std::vector<std::string>{"p1-head.png", "p2-head.png"}));
}

TEST(JobNames, twoJobsOfOneNameAreRefused) {
  Sweep sweep;
  sweep.folder = "/pictures";
  sweep.volumes = {"phantom:8"};
  sweep.presets = {"CT bone", "CT  bone"};
  EXPECT_THROW(jobsOf(sweep), Error);
  sweep.presets = {};
  sweep.volumes = {};
  EXPECT_THROW(jobsOf(sweep), Error) << "nothing to draw";
  sweep.volumes = {"/a\nb.nii"};
  EXPECT_THROW(jobsOf(sweep), Error) << "a job is one line";
}

TEST(JobLines, areReadByAShellAsTheyWereMeant) {
  const std::vector<std::string> words{"it's", "a b", "$HOME", "`x`", "\"", "\\", "", "*", "ü", "-o"};
  const test::TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  ASSERT_EQ(std::system((shellLine("printf",
                                   [&] {
                                     std::vector<std::string> all{"%s\\n"};
                                     all.insert(all.end(), words.begin(), words.end());
                                     return all;
                                   }()) +
                         " >'" + out.string() + "'")
                            .c_str()),
            0);
  EXPECT_EQ(linesOf(test::bytesOfFile(out)), words);
}

/// The shell's blocks of the guide's page, in their order.
std::vector<std::string> commandsOfTheGuide() {
  std::istringstream page(test::bytesOfFile(test::sourceFolder() / "app/guide/many/README.md"));
  std::vector<std::string> blocks;
  bool isInside = false;
  for (std::string line; std::getline(page, line);) {
    if (line == "```sh")
      blocks.emplace_back();
    else if (line != "```" && isInside)
      blocks.back() += line + "\n";
    isInside = line == "```sh" || (isInside && line != "```");
  }
  return blocks;
}

/// A ball that is brighter inside, in Hounsfield units.
void writeBall(const fs::path& path, double brightest) {
  std::ofstream file(path, std::ios::binary);
  file << "NRRD0004\ntype: int16\ndimension: 3\nsizes: 24 24 24\nspacings: 8 8 8\nencoding: raw\nendian: "
          "little\n\n";
  for (int i = 0; i < 24 * 24 * 24; ++i) {
    const double x = i % 24 - 11.5, y = i / 24 % 24 - 11.5, z = i / 576 - 11.5;
    const double inside = std::max(0.0, 1.0 - std::sqrt(x * x + y * y + z * z) / 12.0);
    const auto value = static_cast<std::int16_t>(-1024.0 + (brightest + 1024.0) * inside);
    file.put(static_cast<char>(value & 0xFF)).put(static_cast<char>((value >> 8) & 0xFF));
  }
}

class JobsOfTheGuide : public Jobs {
protected:
  void SetUp() override {
    blocks = commandsOfTheGuide();
    ASSERT_EQ(blocks.size(), 5u);
    writeBall(folder.path() / "head.nrrd", 1800.0);
    writeBall(folder.path() / "chest.nrrd", 900.0);
    ASSERT_EQ(runBlock(0), 0);
    ASSERT_EQ(linesOf(test::bytesOfFile(folder.path() / "jobs.txt")).size(), 64u);
  }

  /// Runs a block as it is printed, where `limn` is this build's.
  int runBlock(std::size_t index, const std::string& by = "sh") {
    std::ofstream(folder.path() / "block.sh") << blocks[index];
    const std::string path = fs::path(test::programPath()).parent_path().string();
    return shell("export PATH='" + path + "':\"$PATH\" && " + by + " block.sh");
  }

  std::vector<std::string> blocks;
};

TEST_F(JobsOfTheGuide, drawTheSamePicturesByEveryEngine) {
  ASSERT_EQ(runBlock(1), 0);
  std::map<std::string, std::string> byXargs = pictures("pictures");
  EXPECT_EQ(byXargs.size(), 64u);
  // The turns of a volume, preset and model differ in one figure: for the other engines two of the eight will
  // do.
  const auto isAnotherTurn = [](const std::string& text, const char* first, const char* second) {
    return text.find(first) == std::string::npos && text.find(second) == std::string::npos;
  };
  std::vector<std::string> lines = linesOf(test::bytesOfFile(folder.path() / "jobs.txt"));
  std::erase_if(lines,
                [&](const std::string& line) { return isAnotherTurn(line, "--turn 0/8 ", "--turn 5/8 "); });
  ASSERT_EQ(lines.size(), 16u);
  {
    std::ofstream file(folder.path() / "jobs.txt");
    for (const std::string& line : lines)
      file << line << '\n';
  }
  std::erase_if(byXargs, [&](const auto& picture) {
    return isAnotherTurn(picture.first, "_turn-0-of-8", "_turn-5-of-8");
  });
  std::string missing;
  for (const auto& [index, needs, by] :
       {std::tuple{2, "parallel", std::string("sh")},
        std::tuple{3, "slurmctld",
                   "'" + (test::sourceFolder() / "tests/app/commands/with_slurm.sh").string() +
                       "' \"$PWD/slurm\" sh"}}) {
    if (std::system((std::string("command -v ") + needs + " >/dev/null").c_str()) != 0) {
      missing += std::string(missing.empty() ? "" : ", ") + needs;
      continue;
    }
    fs::remove_all(folder.path() / "pictures");
    fs::create_directory(folder.path() / "pictures");
    ASSERT_EQ(runBlock(index, by), 0) << needs;
    EXPECT_TRUE(pictures("pictures") == byXargs) << needs << ": byte for byte";
  }
  if (!missing.empty())
    GTEST_SKIP() << "not installed, and not tried: " << missing;
}

TEST_F(JobsOfTheGuide, joinTheReportsOfACohort) {
  ASSERT_EQ(runBlock(4), 0);
  std::size_t points = 0;
  for (const char* name : {"head", "chest"})
    points += linesOf(test::bytesOfFile(folder.path() / "reports" / name / "accuracy.csv")).size() - 1;
  const auto table = linesOf(test::bytesOfFile(folder.path() / "cohort/cohort.csv"));
  EXPECT_EQ(table.size(), points + 1) << "a line for each point of each report, and the columns";
  EXPECT_EQ(table.at(1).rfind("reports/chest,\"chest, CT bone\",", 0), 0u) << table.at(1);

  std::ofstream(folder.path() / "reports/chest/accuracy.json") << "{\"scene\": ";
  const auto damaged = test::runProgram(folder.path(), "accuracy --join " + in("reports/head") + " " +
                                                           in("reports/chest") + " -o " + in("again"));
  EXPECT_EQ(damaged.status, 3);
  EXPECT_NE(damaged.err.find("reports/chest/accuracy.json"), std::string::npos) << damaged.err;
  EXPECT_FALSE(fs::exists(folder.path() / "again"));
  // What holds no report is named, and what would do.
  const auto refusal = [&](const char* given) {
    const auto outcome =
        test::runProgram(folder.path(), "accuracy --join " + in(given) + " -o " + in("again"));
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    return outcome.err;
  };
  fs::create_directory(folder.path() / "empty");
  EXPECT_NE(refusal("empty").find("/empty holds no report; give folders that limn accuracy -o wrote"),
            std::string::npos);
  EXPECT_NE(refusal("reports").find("in folders of their own; join them with --join " +
                                    (folder.path() / "reports/*").string() + "."),
            std::string::npos);
  EXPECT_NE(refusal("reports/head/accuracy.csv").find("accuracy.csv shows a report to people"),
            std::string::npos);
  EXPECT_NE(refusal("nowhere/*").find("There is no report " + (folder.path() / "nowhere/*").string()),
            std::string::npos);
  EXPECT_EQ(test::runProgram(folder.path(), "accuracy -o " + in("again")).status, 2);
  EXPECT_EQ(test::runProgram(folder.path(), "accuracy " + in("head.nrrd") + " --join " + in("reports/head") +
                                                " -o " + in("again"))
                .status,
            2);
}

TEST_F(Jobs, killedAtAnyMomentTheyGoOnAndNoneIsHalf) {
  written("phantom:6 --turntable 8 --size 160x160 --threads 1 -o " + in("whole"));
  ASSERT_EQ(shell("xargs -d '\\n' -n 1 -P 2 sh -c < jobs.txt"), 0);
  const auto whole = pictures("whole");
  ASSERT_EQ(whole.size(), 8u);
  written("phantom:6 --turntable 8 --size 160x160 --threads 1 -o " + in("killed"));
  for (const char* seconds : {"0.3", "0.7", "1.1", "1.6"}) {
    shell(std::string("timeout -s KILL ") + seconds +
          " setsid -w xargs -d '\\n' -n 1 -P 2 sh -c < jobs.txt; true");
    for (const auto& [name, bytes] : pictures("killed"))
      if (const auto same = whole.find(name); same != whole.end()) {
        EXPECT_TRUE(bytes == same->second) << name << " after " << seconds << " s";
      }
  }
  ASSERT_EQ(shell("xargs -d '\\n' -n 1 -P 2 sh -c < jobs.txt"), 0);
  EXPECT_TRUE(pictures("killed") == whole) << "nothing else is left there either";
}

TEST_F(Jobs, theTurnOfAJobIsTheTurntables) {
  written("phantom:8 --turntable 6 --size 32x32 -o " + in("jobs"));
  ASSERT_EQ(shell("sh jobs.txt"), 0);
  ASSERT_EQ(run("turntable phantom:8 --frames 6 --size 32x32 --engine cpu -o " + in("frames")).status, 0);
  const auto jobs = pictures("jobs"), frames = pictures("frames");
  ASSERT_EQ(jobs.size(), 6u);
  ASSERT_EQ(frames.size(), 6u);
  EXPECT_TRUE(std::ranges::equal(
      jobs, frames, {}, [](const auto& each) { return each.second; },
      [](const auto& each) { return each.second; }));
}

TEST_F(Jobs, onlyWholePicturesStay) {
  ASSERT_EQ(run("render phantom:8 --size 16x16 --engine cpu -o " + in("a.png")).status, 0);
  const std::string whole = test::bytesOfFile(folder.path() / "a.png");
  ASSERT_EQ(run("render phantom:8 --size 40x40 --engine cpu --skip-existing -o " + in("a.png")).status, 0);
  EXPECT_TRUE(test::bytesOfFile(folder.path() / "a.png") == whole) << "it stays";
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{20}, whole.size() / 2}) {
    fs::resize_file(folder.path() / "a.png", bytes);
    ASSERT_EQ(run("render phantom:8 --size 16x16 --engine cpu --skip-existing -o " + in("a.png")).status, 0);
    EXPECT_TRUE(test::bytesOfFile(folder.path() / "a.png") == whole) << "of " << bytes << " bytes";
  }
}

TEST_F(Jobs, aSweepIsReadFromAFileBesideItsVolumes) {
  fs::create_directories(folder.path() / "study");
  ASSERT_EQ(run("render phantom:8 --size 16x16 --engine cpu -o " + in("study/a.png")).status, 0);
  fs::rename(folder.path() / "study/a.png", folder.path() / "study/it's.png");
  std::ofstream(folder.path() / "study" / "sweep.json")
      << R"({"limn_sweep": 1, "volumes": ["it's.png", "phantom:8"], "models": ["none", "compare"], "output": "out",
             "size": "16x16"})";
  written("--from " + in("study/sweep.json"));
  ASSERT_EQ(shell("xargs -d '\\n' -n 1 sh -c < jobs.txt"), 0);
  const auto made = pictures("study/out");
  EXPECT_EQ(made.size(), 4u);
  EXPECT_TRUE(made.contains("it-s_none.png"));
  EXPECT_EQ(run("jobs --from " + in("study/sweep.json") + " --model classic").out.find("compare"),
            std::string::npos)
      << "what is given replaces what the file says";
}

TEST_F(Jobs, whatEveryJobWouldRefuseIsRefusedAtOnce) {
  const auto status = [this](const std::string& arguments) { return run("jobs " + arguments).status; };
  EXPECT_EQ(status(""), 2);
  EXPECT_EQ(status("phantom:8"), 2) << "no folder";
  EXPECT_EQ(status("-o " + in("out")), 2) << "no volume";
  EXPECT_EQ(status("missing.nii -o " + in("out")), 3);
  EXPECT_EQ(status("phantom:8 --preset nothing -o " + in("out")), 2);
  EXPECT_EQ(status("phantom:8 --model shiny -o " + in("out")), 2);
  EXPECT_EQ(status("phantom:8 --view below -o " + in("out")), 2);
  EXPECT_EQ(status("phantom:8 --size huge -o " + in("out")), 2);
  EXPECT_EQ(status("phantom:8 --format bmp -o " + in("out")), 2);
  EXPECT_EQ(status("phantom:8 phantom:8 -o " + in("out")), 2);
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
  std::ofstream(folder.path() / "bad.json") << R"({"limn_sweep": 1, "volume": ["a"]})";
  const test::Outcome unknown = run("jobs --from " + in("bad.json") + " -o " + in("out"));
  EXPECT_EQ(unknown.status, 3);
  EXPECT_NE(unknown.err.find("volume"), std::string::npos) << unknown.err;
}

TEST_F(Jobs, aFolderThatVanishedEndsAJobWithOneSentence) {
  written("phantom:8 --size 16x16 -o " + in("out"));
  fs::remove_all(folder.path() / "out");
  const test::Outcome outcome =
      run("render phantom:8 --size 16x16 --quiet --skip-existing -o " + in("out/a.png"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
}

} // namespace
} // namespace limn
