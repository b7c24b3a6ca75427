// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/Cohort.h"
#include "io/reports/AccuracyFile.h"
#include "io/reports/ReportJson.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

MeasuredPoint pointAt(double step, double p99_9, double ms) {
  MeasuredPoint point;
  point.point.stepVoxels = step;
  point.error = {2.0 * p99_9, p99_9, p99_9 / 4.0, p99_9 / 2.0, 0.125};
  point.ms = {ms, ms - 1.0, ms + 1.0};
  point.peakMb = 12.5;
  return point;
}

NamedReport reportOf(const std::string& name, std::vector<MeasuredPoint> points) {
  AccuracyReport report;
  report.scene = "head, CT bone";
  report.renderer = "CPU engine";
  report.machine = "this one";
  report.size = {320, 240};
  report.smallestSpacingMm = 0.5;
  report.reference = {true, 1.0 / 128, std::nullopt, 0.125, 0.0625};
  report.points = std::move(points);
  return {name, report};
}

AccuracyReport readAgain(const AccuracyReport& report) {
  return parseAccuracy(accuracyJson(report), "accuracy.json");
}

std::string refusal(const std::string& text) {
  try {
    parseAccuracy(text, "accuracy.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "read";
}

TEST(Cohort, tellsTheUsualAndTheWorstOfEachPoint) {
  const std::vector<CohortGroup> groups =
      cohortOf({reportOf("a", {pointAt(1.0, 2.0, 10.0), pointAt(0.5, 1.0, 20.0)}),
                reportOf("b", {pointAt(1.0, 7.0, 30.0)}), reportOf("c", {pointAt(1.0, 3.0, 50.0)})});
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].reports, 3);
  ASSERT_EQ(groups[0].points.size(), 2u);
  const CohortPoint& coarse = groups[0].points[0];
  EXPECT_EQ(coarse.scenes, 3);
  EXPECT_EQ(coarse.usualP99_9, 3.0);
  EXPECT_EQ(coarse.worstP99_9, 7.0);
  EXPECT_EQ(coarse.worst, "b");
  EXPECT_EQ(coarse.ms, (Timing{30.0, 10.0, 50.0}));
  EXPECT_EQ(groups[0].points[1].scenes, 1);
}

TEST(Cohort, comparesNoTimesOfDifferentMachines) {
  NamedReport other = reportOf("b", {pointAt(1.0, 2.0, 99.0)});
  other.report.machine = "that one";
  const std::vector<CohortGroup> groups = cohortOf({reportOf("a", {pointAt(1.0, 2.0, 10.0)}), other});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[1].machine, "that one");
  EXPECT_EQ(groups[1].points[0].ms.median, 99.0);
}

TEST(Cohort, countsNoErrorWithoutAnExactPicture) {
  NamedReport unknown = reportOf("b", {pointAt(1.0, 40.0, 30.0)});
  unknown.report.reference.converged = false;
  const CohortPoint point = cohortOf({reportOf("a", {pointAt(1.0, 2.0, 10.0)}), unknown})[0].points[0];
  EXPECT_EQ(point.scenes, 2);
  EXPECT_EQ(point.converged, 1);
  EXPECT_EQ(point.worstP99_9, 2.0);
  EXPECT_EQ(point.ms.median, 20.0);
}

TEST(AccuracyFile, isReadAsItWasWritten) {
  MeasuredPoint tolerant = pointAt(0.5, 0.25, 5.0);
  tolerant.point.toleranceLevels = 1.0;
  tolerant.point.engine = Engine::slices;
  tolerant.point.gradients = GradientSource::precomputed;
  tolerant.order = 1.5;
  const AccuracyReport report = reportOf("a", {pointAt(1.0, 2.0, 10.0), tolerant}).report;
  EXPECT_EQ(readAgain(report), report);
}

TEST(AccuracyFile, keepsTimesWhereErrorsAreUnknown) {
  AccuracyReport report = reportOf("a", {pointAt(1.0, 2.0, 10.0)}).report;
  report.reference.converged = false;
  const AccuracyReport again = readAgain(report);
  EXPECT_FALSE(again.reference.converged);
  EXPECT_EQ(again.points[0].error, ImageError{});
  EXPECT_EQ(again.points[0].ms, report.points[0].ms);
}

TEST(AccuracyFile, sayWhatIsNoReport) {
  EXPECT_EQ(
      refusal("{}").find("Cannot read accuracy.json: it is no report of limn accuracy; choose another file"),
      0u)
      << refusal("{}");
  std::string text = accuracyJson(reportOf("a", {pointAt(1.0, 2.0, 10.0)}).report);
  EXPECT_NE(refusal(text.substr(0, text.size() / 2)).find("accuracy.json"), std::string::npos);
  text.replace(text.find("\"gl\""), 4, "\"tv\"");
  EXPECT_NE(refusal(text).find("points[0].engine"), std::string::npos) << refusal(text);
}

TEST(CohortCsv, hasALineForEachPointAndQuotesWordsWithCommas) {
  const std::string text = cohortCsv(
      {reportOf("sub-01", {pointAt(1.0, 2.0, 10.0)}), reportOf("sub \"2\"", {pointAt(1.0, 3.0, 10.0)})});
  EXPECT_EQ(std::ranges::count(text, '\n'), 3);
  EXPECT_NE(text.find("\nsub-01,\"head, CT bone\",this one,CPU engine,320,240,gl,1.0,0.5,"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\n\"sub \"\"2\"\"\","), std::string::npos) << text;
}

} // namespace
} // namespace limn
