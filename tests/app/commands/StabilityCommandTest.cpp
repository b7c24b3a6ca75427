// SPDX-License-Identifier: GPL-3.0-or-later
// `limn stability`: its report and its exit status, from the built program and from reports made by hand.
#include "app/lab/stability/StabilityText.h"
#include "io/reports/ReportJson.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <set>

namespace limn {
namespace {

using Json = nlohmann::json;

class StabilityCommand : public testing::Test {
protected:
  test::Outcome run(const std::string& arguments) {
    return test::runProgram(folder.path(), "stability " + arguments);
  }

  std::string file(const std::string& name) const { return (folder.path() / name).string(); }

  test::TemporaryFolder folder;
};

TEST_F(StabilityCommand, writesOneRowPerEngineAndSettingWithFigureBoundAndVerdict) {
  const test::Outcome outcome = run("--only 'h9, H4' --fuzz 5 --seed 7 -o '" + file("report") + "'");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = Json::parse(test::bytesOfFile(file("report/stability.json")));
  EXPECT_FALSE(report["renderer"].get<std::string>().empty());
  EXPECT_NE(report["driver"].get<std::string>().find("GLSL"), std::string::npos);
  EXPECT_EQ(report["command"], "limn stability -o DIR --only H9,H4 --fuzz 5 --seed 7");
  std::set<std::string> engines;
  for (const Json& row : report["cases"]) {
    EXPECT_TRUE(row["id"] == "H9" || row["id"] == "H4") << row;
    EXPECT_EQ(row["verdict"], "pass") << row;
    EXPECT_LE(row["figure"].get<double>(), row["bound"].get<double>()) << row;
    EXPECT_FALSE(row["reason"].get<std::string>().empty()) << row;
    engines.insert(row["engine"]);
  }
  EXPECT_EQ(engines, (std::set<std::string>{"cpp", "cpu", "gl", "reference", "slices"}));
  EXPECT_EQ(report["fuzz"]["seeds"], 5);
  EXPECT_TRUE(report["fuzz"]["failures"].empty());
  const std::string page = test::bytesOfFile(file("report/stability.html"));
  EXPECT_NE(page.find("id=\"H9\""), std::string::npos);
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos) << "pictures travel in the page";
  EXPECT_NE(outcome.out.find("0 fail"), std::string::npos);
}

TEST_F(StabilityCommand, refusesWhatItCannotDo) {
  const test::Outcome nothing = run("");
  EXPECT_EQ(nothing.status, 2);
  EXPECT_NE(nothing.err.find("-o"), std::string::npos) << nothing.err;
  const test::Outcome unknown = run("--only H999");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("H999"), std::string::npos) << unknown.err;
}

TEST_F(StabilityCommand, aDriverThatIsTooOldIsNamedAndNoCaseBlamed) {
  const test::Outcome old =
      test::runProgram(folder.path(), "stability --only H9", "MESA_GL_VERSION_OVERRIDE=2.1");
  EXPECT_EQ(old.status, 4);
  EXPECT_NE(old.err.find("OpenGL 2.1"), std::string::npos) << old.err;
  EXPECT_EQ(old.out.find("H9"), std::string::npos) << old.out;
}

StabilityReport reportWith(const Finding& finding) {
  StabilityReport report;
  report.cases = {{"H1", "a <case>", {finding}}};
  return report;
}

TEST(StabilityText, aRowBeyondItsBoundFailsTheReport) {
  const StabilityReport good = reportWith(atMost("gl", "one", 1.0, 1.0, "why"));
  EXPECT_TRUE(holds(good));
  const StabilityReport bad = reportWith(atMost("gl", "one", 1.5, 1.0, "why"));
  EXPECT_FALSE(holds(bad));
  EXPECT_NE(stabilityTable(bad).find("FAILS gl, one: 1.5 of 1 (why)"), std::string::npos)
      << stabilityTable(bad);
  EXPECT_EQ(Json::parse(stabilityJson(bad))["cases"][0]["verdict"], "fail");
  const std::string page = stabilityPage(bad);
  EXPECT_NE(page.find("a &lt;case&gt;"), std::string::npos);
  EXPECT_NE(page.find("What fails"), std::string::npos);
  EXPECT_EQ(page.find("What cannot apply"), std::string::npos);
}

TEST(StabilityText, aFailingSeedFailsTheReportAndSaysHowToRepeatIt) {
  StabilityReport report;
  report.fuzz.emplace();
  report.fuzz->seeds = 1;
  report.fuzz->failures = {{4711, "a pixel is no number"}};
  EXPECT_FALSE(holds(report));
  EXPECT_NE(stabilityTable(report).find("limn stability --fuzz 1 --seed 4711"), std::string::npos);
}

TEST(StabilityText, whatHasNoFigureHasNoneInJson) {
  const Json none = Json::parse(stabilityJson(reportWith(notApplicable("slices", "one", "why"))))["cases"][0];
  EXPECT_TRUE(none["figure"].is_null());
  EXPECT_EQ(none["verdict"], "n/a");
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(
      Json::parse(stabilityJson(reportWith(atMost("gl", "", infinite, 1.0, "why"))))["cases"][0]["figure"]
          .is_null());
}

} // namespace
} // namespace limn
