// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reports/AccuracyFile.h"
#include "io/reading/ReadError.h"

#include "accuracy/sweep/AccuracySweep.h"
#include "io/json/JsonFields.h"
#include "io/reading/ReadError.h"
#include "io/reports/PointNames.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

// Renderers of VTK, which limn accuracy --rivals measures.
constexpr const char* rivalPrefix = "vtk-";

// Writers put null where there is no figure.
bool isNull(JsonFields& fields, const std::string& key) {
  return fields.has(key) && fields.child(key).is_null();
}

void readNumber(JsonFields& fields, const std::string& key, double& target, const Limits& limits) {
  if (!isNull(fields, key))
    fields.number(key, target, limits);
}

std::optional<double> numberOrNone(JsonFields& fields, const std::string& key, const Limits& limits) {
  double value = 0.0;
  return !isNull(fields, key) && fields.number(key, value, limits) ? std::optional(value) : std::nullopt;
}

Timing timesIn(JsonFields fields) {
  Timing ms;
  fields.number("median", ms.median, notNegative);
  fields.number("min", ms.least, notNegative);
  fields.number("max", ms.most, notNegative);
  fields.finish();
  return ms;
}

ImageError errorIn(JsonFields& fields) {
  ImageError error;
  readNumber(fields, "max", error.largest, notNegative);
  readNumber(fields, "p99_9", error.p99_9, notNegative);
  readNumber(fields, "mean", error.mean, notNegative);
  readNumber(fields, "rms", error.rms, notNegative);
  readNumber(fields, "share_over_one", error.shareOverOne, fraction);
  return error;
}

OperatingPoint pointIn(JsonFields& fields) {
  OperatingPoint point;
  std::string engine;
  if (fields.text("engine", engine) && engine.starts_with(rivalPrefix))
    point.rival = engine;
  else
    fields.choice("engine", point.engine, pointEngines);
  readNumber(fields, "step_voxels", point.stepVoxels, positive);
  point.toleranceLevels = numberOrNone(fields, "tolerance_levels", positive);
  if (!isNull(fields, "paths")) {
    int paths = 0;
    if (fields.integer("paths", paths, 1, mostPaths))
      point.paths = paths;
  }
  fields.boolean("preintegrated", point.preintegrated);
  fields.number("early_termination", point.earlyTermination, fraction);
  fields.choice("gradients", point.gradients, gradientSourceNames);
  fields.number("image_scale", point.imageScale, {0.0, 1.0, true});
  return point;
}

MeasuredPoint measuredIn(JsonFields fields, double& smallestSpacingMm) {
  MeasuredPoint measured;
  measured.point = pointIn(fields);
  if (const auto stepMm = numberOrNone(fields, "step_mm", positive))
    smallestSpacingMm = *stepMm / measured.point.stepVoxels;
  measured.error = errorIn(fields);
  measured.order = numberOrNone(fields, "order", anyNumber);
  fields.number("peak_mb", measured.peakMb, anyNumber);
  measured.ms = timesIn(fields.object("ms"));
  fields.boolean("pareto", measured.isPareto);
  fields.finish();
  return measured;
}

ReferenceFacts referenceIn(JsonFields fields) {
  ReferenceFacts facts;
  fields.boolean("converged", facts.converged);
  fields.number("step_voxels", facts.stepVoxels, notNegative);
  facts.fineness = numberOrNone(fields, "fineness", anyNumber);
  fields.number("last_change_levels", facts.lastChangeLevels, notNegative);
  fields.number("last_mean_change_levels", facts.lastMeanChange, notNegative);
  fields.boolean("single_precision", facts.isInFloats);
  fields.boolean("standard_error", facts.isByChance);
  // Follow from those.
  fields.has("least_p99_9");
  fields.has("least_mean");
  fields.finish();
  return facts;
}

} // namespace

AccuracyReport parseAccuracy(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  JsonFields fields(json, name, "");
  for (const char* key : {"scene", "renderer", "machine", "reference", "points"})
    if (!fields.has(key))
      failReading(name, Message::tr("it is no report of limn accuracy"), Message::tr("choose another file"));
  AccuracyReport report;
  fields.text("scene", report.scene);
  fields.text("renderer", report.renderer);
  fields.text("machine", report.machine);
  double width = 0.0, height = 0.0;
  fields.pair("size", width, height, {1.0, 65536.0});
  report.size = glm::ivec2(width, height);
  report.reference = referenceIn(fields.object("reference"));
  const nlohmann::json& points = fields.child("points");
  if (!points.is_array())
    fields.fail("points", Message::tr("must be a list"));
  for (std::size_t i = 0; i < points.size(); ++i)
    report.points.push_back(measuredIn(JsonFields(points[i], name, "points[" + std::to_string(i) + "]"),
                                       report.smallestSpacingMm));
  fields.has("decisions");
  fields.has("remarks");
  fields.finish();
  return report;
}

} // namespace limn
