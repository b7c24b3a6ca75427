// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/ReportJson.h"

#include "accuracy/sweep/AccuracySweep.h"
#include "accuracy/sweep/FigureText.h"
#include "io/json/JsonText.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(PointRenderer renderer) {
  const char* names[] = {"gl", "slices", "reference"};
  return names[static_cast<int>(renderer)];
}

const char* nameOf(GradientSource source) {
  return source == GradientSource::onTheFly ? "on_the_fly" : "precomputed";
}

Json timesOf(const Timing& ms) {
  return {{"median", ms.median}, {"min", ms.least}, {"max", ms.most}};
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
  Json json{{"engine", nameOf(point.renderer)},
            {"step_voxels", point.toleranceLevels ? Json() : Json(point.stepVoxels)},
            {"step_mm", point.toleranceLevels ? Json() : Json(point.stepVoxels * report.smallestSpacingMm)},
            {"tolerance_levels", point.toleranceLevels ? Json(*point.toleranceLevels) : Json()},
            {"preintegrated", point.preintegrated},
            {"early_termination", point.earlyTermination},
            {"gradients", nameOf(point.gradients)},
            {"image_scale", point.imageScale}};
  addErrors(json, measured.error, report.reference.converged);
  json["order"] = report.reference.converged && measured.order ? Json(*measured.order) : Json();
  json["peak_mb"] = measured.peakMb;
  json["ms"] = timesOf(measured.ms);
  json["pareto"] = report.reference.converged && measured.isPareto;
  return json;
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
          {"last_change_levels", facts.lastChangeLevels},
          {"last_mean_change_levels", facts.lastMeanChange},
          {"least_p99_9", leastP99_9(facts)},
          {"least_mean", leastMean(facts)}};
}

} // namespace

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
  std::string text = "engine,step_voxels,step_mm,tolerance_levels,preintegrated,early_termination,gradients,"
                     "image_scale,max,p99_9,mean,rms,share_over_one,order,peak_mb,ms_median,ms_min,ms_max,"
                     "pareto\n";
  for (const MeasuredPoint& point : report.points) {
    Json json = pointOf(point, report);
    const Json ms = json["ms"];
    const Json isPareto = json["pareto"];
    json.erase("ms");
    json.erase("pareto");
    json["ms_median"] = ms["median"];
    json["ms_min"] = ms["min"];
    json["ms_max"] = ms["max"];
    json["pareto"] = isPareto;
    const char* separator = "";
    for (const auto& [key, value] : json.items()) {
      text += separator;
      if (value.is_string())
        text += value.get_ref<const std::string&>();
      else if (!value.is_null())
        text += value.dump();
      separator = ",";
    }
    text.push_back('\n');
  }
  return text;
}

} // namespace limn
