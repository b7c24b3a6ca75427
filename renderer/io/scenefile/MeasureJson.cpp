// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SceneJson.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

std::vector<glm::dvec3> readPlaces(JsonFields& fields, Measurement::Kind kind) {
  if (!fields.has("places_mm") || !fields.child("places_mm").is_array() ||
      fields.child("places_mm").size() != placesOf(kind))
    fields.fail("places_mm", Message::tr("must be a list of as many places as are measured: %1 of %2")
                                 .arg(std::to_string(placesOf(kind)))
                                 .arg(nameOf(kind)));
  std::vector<glm::dvec3> places;
  for (const nlohmann::json& item : fields.child("places_mm")) {
    // A place is a bare list of numbers, which only a field can be read as.
    const nlohmann::json place = {{"at", item}};
    JsonFields its(place, fields.document(), placeIn("places_mm", places.size()));
    its.vector("at", places.emplace_back(), placeLimits);
  }
  return places;
}

Measurement readMeasurement(JsonFields fields) {
  Measurement measurement;
  if (!fields.choice("kind", measurement.kind, measurementKinds))
    fields.fail("kind", Message::tr("is missing"));
  if (fields.has("plane"))
    fields.choice("plane", measurement.plane.emplace(), patientPlanes);
  else if (measurement.kind == Measurement::Kind::ellipse)
    fields.fail("plane", Message::tr("is missing"));
  measurement.placesMm = readPlaces(fields, measurement.kind);
  fields.text("name", measurement.name);
  fields.boolean("shown", measurement.isShown);
  fields.finish();
  return measurement;
}

Json measurementJson(const Measurement& measurement) {
  Json json = {{"kind", nameOf(measurement.kind)}};
  if (measurement.plane)
    json["plane"] = nameOf(*measurement.plane);
  json["places_mm"] = Json::array();
  for (const glm::dvec3& place : measurement.placesMm)
    json["places_mm"].push_back({place.x, place.y, place.z});
  if (!measurement.name.empty())
    json["name"] = measurement.name;
  if (!measurement.isShown)
    json["shown"] = false;
  return json;
}

} // namespace

std::vector<Measurement> readMeasurements(JsonFields& scene) {
  std::vector<Measurement> measurements;
  if (!scene.has("measurements"))
    return measurements;
  const nlohmann::json& list = scene.child("measurements");
  if (!list.is_array())
    scene.fail("measurements", Message::tr("must be a list"));
  for (const nlohmann::json& item : list)
    measurements.push_back(
        readMeasurement(JsonFields(item, scene.document(), placeIn("measurements", measurements.size()))));
  return measurements;
}

Json measurementsJson(const std::vector<Measurement>& measurements) {
  Json list = Json::array();
  for (const Measurement& measurement : measurements)
    list.push_back(measurementJson(measurement));
  return list;
}

Measurement readOldDistance(JsonFields fields) {
  Measurement distance{Measurement::Kind::distance, PatientPlane::axial, {glm::dvec3(0.0), glm::dvec3(0.0)}};
  fields.choice("plane", *distance.plane, patientPlanes);
  fields.vector("from_mm", distance.placesMm[0], placeLimits);
  fields.vector("to_mm", distance.placesMm[1], placeLimits);
  fields.finish();
  return distance;
}

} // namespace limn
