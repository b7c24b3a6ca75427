// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/ReportJson.h"

#include "accuracy/sweep/AccuracySweep.h"
#include "accuracy/sweep/Cohort.h"
#include "accuracy/times/CostModel.h"
#include "accuracy/times/Timing.h"
#include "io/json/JsonFields.h"
#include "io/reports/PointNames.h"
#include "scene/effects/EffectRows.h"
#include "scene/volume/Volume.h"
#include "stability/PictureFuzz.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

std::vector<std::string> warningsOf(const Volume& volume) {
  std::vector<std::string> warnings;
  for (const Message& warning : volume.info().warnings)
    warnings.push_back(warning.english());
  return warnings;
}

using Json = nlohmann::ordered_json;

Json toJson(const glm::dvec3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json toJson(const SeriesSummary& series) {
  return {{"number", series.number},
          {"description", series.description},
          {"modality", series.modality},
          {"dims", {series.dims.x, series.dims.y, series.dims.z}}};
}

Json timesOf(const Timing& ms) {
  return {{"median", ms.median}, {"min", ms.least}, {"max", ms.most}};
}

Json toJson(const BenchRow& row) {
  if (!row.missing.empty())
    return {{"program", row.program},
            {"scene", row.scene},
            {"size", {row.size.x, row.size.y}},
            {"step_voxels", row.stepVoxels},
            {"missing", row.missing}};
  return {{"program", row.program},
          {"scene", row.scene},
          {"size", {row.size.x, row.size.y}},
          {"step_voxels", row.stepVoxels},
          {"ms", timesOf(timingOf(wallTimes(row.views)))},
          {"cpu_ms", timingOf(processorTimes(row.views)).median},
          {"first_ms", row.firstMs},
          {"edit_ms", row.editMs ? Json(*row.editMs) : Json()},
          {"peak_mb", row.peakMb},
          {"mean_error", row.meanError}};
}

// No figure without a converged picture.
void addErrors(Json& json, const ImageError& error, bool isKnown) {
  const auto add = [&](const char* name, double value) { json[name] = isKnown ? Json(value) : Json(); };
  add("max", error.largest);
  add("p99_9", error.p99_9);
  add("mean", error.mean);
  add("rms", error.rms);
  add("share_over_one", error.shareOverOne);
}

Json pointOf(const MeasuredPoint& measured, const AccuracyReport& report) {
  const OperatingPoint& point = measured.point;
  const bool hasStep = !point.toleranceLevels && !point.paths;
  Json json{{"engine", point.rival.empty() ? nameOf(point.engine) : point.rival},
            {"step_voxels", hasStep ? Json(point.stepVoxels) : Json()},
            {"step_mm", hasStep ? Json(point.stepVoxels * report.smallestSpacingMm) : Json()},
            {"tolerance_levels", point.toleranceLevels ? Json(*point.toleranceLevels) : Json()},
            {"paths", point.paths ? Json(*point.paths) : Json()},
            {"preintegrated", point.preintegrated},
            {"early_termination", point.earlyTermination},
            {"gradients", gradientSourceNames.of(point.gradients)},
            {"image_scale", point.imageScale}};
  addErrors(json, measured.error, report.reference.converged);
  json["order"] = report.reference.converged && measured.order ? Json(*measured.order) : Json();
  json["peak_mb"] = measured.peakMb;
  json["ms"] = timesOf(measured.ms);
  json["pareto"] = report.reference.converged && measured.isPareto;
  return json;
}

const std::string csvColumns =
    "engine,step_voxels,step_mm,tolerance_levels,paths,preintegrated,early_termination,gradients,image_scale,"
    "max,"
    "p99_9,mean,rms,share_over_one,order,peak_mb,ms_median,ms_min,ms_max,pareto";

// The cells of a point, in the order of the columns.
std::string csvCells(const MeasuredPoint& point, const AccuracyReport& report) {
  Json json = pointOf(point, report);
  const Json ms = json["ms"];
  const Json isPareto = json["pareto"];
  json.erase("ms");
  json.erase("pareto");
  json["ms_median"] = ms["median"];
  json["ms_min"] = ms["min"];
  json["ms_max"] = ms["max"];
  json["pareto"] = isPareto;
  std::string cells;
  const char* separator = "";
  for (const auto& [key, value] : json.items()) {
    cells += separator;
    if (value.is_string())
      cells += value.get_ref<const std::string&>();
    else if (!value.is_null())
      cells += value.dump();
    separator = ",";
  }
  return cells;
}

// Words of people in one cell (RFC 4180).
std::string csvText(const std::string& words) {
  if (words.find_first_of(",\"\r\n") == std::string::npos)
    return words;
  std::string quoted = "\"";
  for (const char letter : words)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

Json decisionOf(const DecisionCost& cost, bool isKnown) {
  Json json{{"group", cost.group}, {"name", cost.name}, {"default", cost.isDefault}};
  addErrors(json, cost.error, isKnown);
  addErrors(json["at_an_eighth"], cost.fineError, isKnown);
  json["ms"] = timesOf(cost.ms);
  json["times_default"] = cost.timesDefault;
  json["extra_mb"] = cost.extraMb;
  json["remark"] = cost.remark;
  return json;
}

Json referenceOf(const ReferenceFacts& facts) {
  return {{"converged", facts.converged},
          {"step_voxels", facts.stepVoxels},
          {"fineness", facts.fineness ? Json(*facts.fineness) : Json()},
          {"last_change_levels", facts.lastChangeLevels},
          {"last_mean_change_levels", facts.lastMeanChange},
          {"single_precision", facts.isInFloats},
          {"standard_error", facts.isByChance},
          {"least_p99_9", leastP99_9(facts)},
          {"least_mean", leastMean(facts)}};
}

Json rowOf(const MeasuredCase& one, const Finding& finding) {
  const bool isMeasured = finding.verdict != Verdict::notApplicable;
  return {{"id", one.id},
          {"title", one.title},
          {"what", finding.what},
          {"engine", finding.engine},
          {"figure", isMeasured ? Json(finding.figure) : Json()},
          {"bound", isMeasured ? Json(finding.bound) : Json()},
          {"verdict", verdictText(finding.verdict)},
          {"reason", finding.reason}};
}

Json fuzzOf(const std::optional<FuzzReport>& fuzz) {
  if (!fuzz)
    return {{"seeds", 0}, {"failures", Json::array()}};
  Json failures = Json::array();
  for (const FuzzFailure& failure : fuzz->failures)
    failures.push_back({{"seed", failure.seed}, {"sentence", failure.sentence}});
  return {{"seeds", fuzz->seeds},
          {"refused", fuzz->refused},
          {"reference_compared", fuzz->referenceCompared},
          {"slices", fuzz->slices},
          {"brick_compared", fuzz->brickCompared},
          {"worst_in_bricks", fuzz->worstInBricks},
          {"programs", fuzz->programs},
          {"pixels_compared", fuzz->pixelsCompared},
          {"pixels_unequal_samples", fuzz->pixelsUnequal},
          {"worst_difference", fuzz->worstDifference},
          {"worst_seed", fuzz->worstSeed},
          {"slowest_s", fuzz->slowestSeconds},
          {"slowest_seed", fuzz->slowestSeed},
          {"failures", failures}};
}

} // namespace

std::string pictureJson(const PictureReport& picture) {
  Json json{{"picture", picture.file},  {"width", picture.size.x}, {"height", picture.size.y},
            {"engine", picture.engine}, {"ms", picture.ms},        {"accuracy", nullptr},
            {"figures", nullptr},       {"notes", picture.notes}};
  if (picture.withinLevels)
    json["accuracy"] = {{"within_levels", *picture.withinLevels}, {"statement", picture.statement}};
  if (const std::optional<PictureFigures>& figures = picture.figures)
    json["figures"] = {{"contrast", figures->contrast},
                       {"overflow_share", figures->overflow.share},
                       {"overflow_mean", figures->overflow.meanOvershoot},
                       {"visible_share", figures->visibleShare}};
  if (const std::optional<PictureReport::Paths>& paths = picture.paths) {
    const auto orNull = [](const std::optional<double>& levels) { return levels ? Json(*levels) : Json(); };
    json["error"] = {{"kind", paths->isFiltered ? "estimate" : "standard error"},
                     {"paths", paths->count},
                     {"rms_levels", orNull(paths->rmsLevels)},
                     {"p99_9_levels", orNull(paths->p99_9Levels)},
                     {"seconds", paths->seconds}};
  }
  return textOf(json);
}

static Json toJson(const CarriedFacts& picture) {
  Json json = {{"curves", picture.curves}, {"models", picture.models}, {"lights", picture.lights},
               {"views", picture.views},   {"hidden", picture.hidden}, {"volumes", picture.volumes}};
  if (picture.size)
    json["size"] = {picture.size->x, picture.size->y};
  if (!picture.statement.empty())
    json["accuracy"] = {{"statement", picture.statement}};
  if (picture.withinLevels)
    json["accuracy"]["within_levels"] = *picture.withinLevels;
  return json;
}

std::string carriedJson(const CarriedFacts& picture) {
  return textOf({{"picture", toJson(picture)}});
}

std::string volumeJson(const VolumeFacts& facts, const std::optional<CarriedFacts>& picture) {
  const Volume& volume = *facts.volume;
  const Grid& grid = volume.grid();
  Json direction = Json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      direction.push_back(grid.direction[column][row]);
  Json series = Json::array();
  for (const SeriesSummary& one : facts.series)
    series.push_back(toJson(one));
  Json json = {{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
               {"spacing_mm", toJson(grid.spacingMm)},
               {"origin_mm", toJson(grid.originMm)},
               {"direction", direction},
               {"type", voxelTypeName(volume.stored())},
               {"range", {volume.range().lowest, volume.range().highest}},
               {"invalid_voxels", volume.invalidVoxels()},
               {"gradient", {{"max", facts.gradientMax}, {"p99_5", facts.gradientPercentile}}},
               {"series", series},
               {"warnings", warningsOf(volume)}};
  if (picture)
    json["picture"] = toJson(*picture);
  return textOf(json);
}

std::string effectsJson(const std::string& renderer, const std::vector<EffectRow>& rows,
                        const std::vector<std::optional<EffectCost>>& costs,
                        const std::vector<std::optional<EffectCost>>& wouldCosts) {
  const auto levels = [](const PictureChange& change) {
    return Json{{"most", change.mostLevels}, {"mean", change.meanLevels}};
  };
  Json effects = Json::array();
  Json others = Json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Json& effect = effects.emplace_back(Json{{"name", rows[i].name},
                                             {"on", rows[i].isOn},
                                             {"reason", rows[i].reason.english()},
                                             {"cost_ms", costs[i] ? costs[i]->ms : 0.0}});
    if (costs[i] && costs[i]->brought)
      effect["brought_levels"] = levels(*costs[i]->brought);
    if (!wouldCosts[i])
      continue;
    Json& other = others.emplace_back(Json{{"name", rows[i].name}, {"cost_ms", wouldCosts[i]->ms}});
    if (wouldCosts[i]->brought)
      other["brought_levels"] = levels(*wouldCosts[i]->brought);
  }
  return textOf({{"renderer", renderer}, {"effects", effects}, {"if_switched_on", others}});
}

std::string benchJson(const std::string& machine, const std::vector<BenchRow>& rows,
                      const std::vector<EqualErrorRow>& equalErrors) {
  Json list = Json::array();
  for (const BenchRow& row : rows)
    list.push_back(toJson(row));
  Json json = {{"machine", machine}, {"rows", list}};
  for (const EqualErrorRow& row : equalErrors)
    json["equal_error"].push_back({{"scene", row.scene},
                                   {"program", row.program},
                                   {"mean_error", row.meanError},
                                   {"cpu_ms", row.cpuMs ? Json(*row.cpuMs) : Json()},
                                   {"gain", row.gain ? Json(*row.gain) : Json()},
                                   {"yardstick", row.yardstick}});
  return textOf(json);
}

std::string scaleJson(const std::string& machine, const std::vector<ScaleRow>& rows,
                      const std::vector<BrickRow>& bricks) {
  Json list = Json::array();
  for (const ScaleRow& row : rows) {
    Json json{{"edge", row.edge},
              {"voxels_mb", row.voxelsMb},
              {"open_ms", row.opened.ms},
              {"open_cpu_ms", row.opened.cpuMs},
              {"open_peak_mb", row.openedMb}};
    json.update(toJson(row.drawn));
    json.erase("mean_error"); // no picture is compared with an exact one
    if (row.drawn.missing.empty())
      json["first_cpu_ms"] = row.drawn.firstCpuMs;
    list.push_back(json);
  }
  Json ranks = Json::array();
  for (const BrickRow& row : bricks)
    ranks.push_back({{"edge", row.edge},
                     {"ranks", row.bricks},
                     {"size", {row.size.x, row.size.y}},
                     {"samples", row.samples},
                     {"most_samples", row.mostSamples},
                     {"cpu_ms", row.cpuMs},
                     {"most_cpu_ms", row.mostCpuMs},
                     {"most_kept_mb", row.mostKeptMb},
                     {"reduced_mb", row.reducedMb}});
  return textOf({{"machine", machine}, {"rows", list}, {"ranks", ranks}});
}

std::string accuracyJson(const AccuracyReport& report) {
  Json points = Json::array(), decisions = Json::array();
  for (const MeasuredPoint& point : report.points)
    points.push_back(pointOf(point, report));
  for (const DecisionCost& cost : report.decisions)
    decisions.push_back(decisionOf(cost, report.reference.converged));
  const Json json{{"scene", report.scene},
                  {"renderer", report.renderer},
                  {"machine", report.machine},
                  {"size", {report.size.x, report.size.y}},
                  {"reference", referenceOf(report.reference)},
                  {"points", points},
                  {"decisions", decisions},
                  {"remarks", report.remarks}};
  return textOf(json);
}

std::string accuracyCsv(const AccuracyReport& report) {
  std::string text = csvColumns + "\n";
  for (const MeasuredPoint& point : report.points)
    text += csvCells(point, report) + "\n";
  return text;
}

std::string cohortCsv(const std::vector<NamedReport>& reports) {
  std::string text = "report,scene,machine,renderer,width,height," + csvColumns + "\n";
  for (const auto& [name, report] : reports)
    for (const MeasuredPoint& point : report.points)
      text += csvText(name) + "," + csvText(report.scene) + "," + csvText(report.machine) + "," +
              csvText(report.renderer) + "," + std::to_string(report.size.x) + "," +
              std::to_string(report.size.y) + "," + csvCells(point, report) + "\n";
  return text;
}

std::string stabilityJson(const StabilityReport& report) {
  Json rows = Json::array();
  for (const MeasuredCase& one : report.cases)
    for (const Finding& finding : one.findings)
      rows.push_back(rowOf(one, finding));
  const Json json{{"version", report.version},
                  {"renderer", report.renderer},
                  {"driver", report.driver},
                  {"machine", report.machine},
                  {"date", report.date},
                  {"command", report.command},
                  {"cases", rows},
                  {"fuzz", fuzzOf(report.fuzz)}};
  return textOf(json);
}

} // namespace limn
