// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/KeptPart.h"

#include "io/scenefile/SceneJson.h"
#include "scene/basics/Error.h"

#include <nlohmann/json.hpp>

#include <charconv>

namespace limn {
namespace {

int labelNamed(const JsonFields& weights, const std::string& key) {
  int value = 0;
  const auto [end, failed] = std::from_chars(key.data(), key.data() + key.size(), value);
  if (failed != std::errc() || end != key.data() + key.size())
    weights.fail(key, Message::tr("must be the number of a label"));
  return value;
}

} // namespace

KeptPart keptPartOf(const Region& region) {
  KeptPart part{region.kind, region.kind == Region::Kind::labels ? region.source : std::string(), {}};
  if (region.kind == Region::Kind::labels && region.labels)
    for (std::size_t place = 0; place < region.weights.size(); ++place)
      if (region.weights[place] != 1.0)
        part.weights[region.labels->labels()[place].value] = region.weights[place];
  return part;
}

std::vector<double> weightsOf(const std::vector<Label>& labels, const std::map<int, double>& weights,
                              const std::string& labelMap) {
  std::map<int, double> left = weights;
  std::vector<double> inOrder;
  for (const Label& label : labels) {
    const auto weight = left.find(label.value);
    inOrder.push_back(weight == left.end() ? 1.0 : weight->second);
    left.erase(label.value);
  }
  if (!left.empty())
    throw Error(Error::Kind::input, Message::tr("The scene gives a weight to label %1, which %2 does not "
                                                "have; take the weight out or choose another label map.")
                                        .arg(left.begin()->first, labelMap));
  return inOrder;
}

KeptPart readKeptPart(JsonFields& scene) {
  const nlohmann::json& value = scene.child("keep");
  KeptPart part;
  if (!value.is_object()) {
    if (value != "all" && value != "body")
      scene.fail("keep", Message::tr("must be \"all\", \"body\" or {\"labels\": FILE, \"weights\": {…}}"));
    part.kind = value == "body" ? Region::Kind::body : Region::Kind::all;
    return part;
  }
  part.kind = Region::Kind::labels;
  JsonFields fields = scene.object("keep");
  if (!fields.text("labels", part.labels) || part.labels.empty())
    fields.fail("labels", Message::tr("is missing; name the file of the label map"));
  if (fields.has("weights")) {
    JsonFields weights = fields.object("weights");
    for (const auto& [key, ignored] : fields.child("weights").items())
      weights.number(key, part.weights[labelNamed(weights, key)], fraction);
    weights.finish();
  }
  fields.finish();
  return part;
}

nlohmann::ordered_json keptPartJson(const KeptPart& part) {
  if (part.kind != Region::Kind::labels)
    return part.kind == Region::Kind::body ? "body" : "all";
  nlohmann::ordered_json weights = nlohmann::ordered_json::object();
  for (const auto& [value, weight] : part.weights)
    weights[std::to_string(value)] = weight;
  return {{"labels", part.labels}, {"weights", weights}};
}

} // namespace limn
