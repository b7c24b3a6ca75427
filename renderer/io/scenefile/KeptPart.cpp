// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/KeptPart.h"

#include "io/scenefile/SceneJson.h"
#include "scene/basics/Error.h"
#include "scene/regions/BodyAndLabels.h"

#include <nlohmann/json.hpp>

#include <charconv>

namespace limn {
namespace {

constexpr std::size_t mostCorners = 100000; // a line drawn for minutes has some thousands
constexpr int mostGrown = 100;

constexpr Words<bool, 2> removeWords{{"outside", "inside"}};
constexpr Words<ConnectedPiece::Fate, 3> pieceWords{{"hide", "only", "look"}};

int labelNamed(const JsonFields& fields, const std::string& key) {
  int value = 0;
  const auto [end, failed] = std::from_chars(key.data(), key.data() + key.size(), value);
  if (failed != std::errc() || end != key.data() + key.size())
    fields.fail(key, Message::tr("must be the number of a label"));
  return value;
}

} // namespace

KeptPart keptPartOf(const Region& region) {
  KeptPart part{region.kind, region.kind == Region::Kind::labels ? region.source : "", {}, region.cuts};
  if (region.kind != Region::Kind::labels || !region.labels)
    return part;
  part.hidesTable = hidesTable(region);
  part.moreLabels = region.moreSources;
  for (std::size_t place = 0; place < listedLabels(region); ++place) {
    const int value = region.labels->labels()[place].value;
    if (region.weights[place] != 1.0)
      part.weights[value] = region.weights[place];
    if (const std::size_t look = lookOfLabel(region, place); look > 0)
      part.looks[value] = region.looks[look - 1];
  }
  return part;
}

Region withLooksOf(const Region& region, const std::map<int, TransferFunction>& looks,
                   const std::string& labelMap) {
  std::map<int, TransferFunction> left = looks;
  std::map<std::size_t, TransferFunction> ofPlaces;
  const std::size_t labels = region.labels ? listedLabels(region) : 0;
  for (std::size_t place = 0; place < labels; ++place)
    if (const auto look = left.find(region.labels->labels()[place].value); look != left.end()) {
      ofPlaces[place] = look->second;
      left.erase(look);
    }
  if (!left.empty())
    throw Error(Error::Kind::input, Message::tr("The scene gives a look to label %1, which %2 does not have; "
                                                "take the look out or choose another label map.")
                                        .arg(left.begin()->first, labelMap));
  return withLooks(region, ofPlaces);
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

namespace {

// One label map, or a list of masks.
void readPaths(JsonFields& fields, KeptPart& part) {
  if (!fields.has("labels") || !fields.child("labels").is_array()) {
    if (!fields.text("labels", part.labels) || part.labels.empty())
      fields.fail("labels", Message::tr("is missing, which names the file of the label map"));
    return;
  }
  for (const nlohmann::json& path : fields.child("labels")) {
    if (!path.is_string() || path.get<std::string>().empty())
      fields.fail("labels", Message::tr("must name a file, or be a list of the files of masks"));
    part.moreLabels.push_back(path.get<std::string>());
  }
  if (part.moreLabels.empty())
    fields.fail("labels", Message::tr("must name a file, or be a list of the files of masks"));
  part.labels = part.moreLabels.front();
  part.moreLabels.erase(part.moreLabels.begin());
}

void readLabelsPart(JsonFields fields, KeptPart& part) {
  part.kind = Region::Kind::labels;
  readPaths(fields, part);
  if (fields.has("weights")) {
    JsonFields weights = fields.object("weights");
    for (const auto& [key, ignored] : fields.child("weights").items())
      weights.number(key, part.weights[labelNamed(weights, key)], fraction);
    weights.finish();
  }
  if (fields.has("looks")) {
    JsonFields looks = fields.object("looks");
    for (const auto& [key, ignored] : fields.child("looks").items()) {
      const int label = labelNamed(looks, key);
      JsonFields look = looks.object(key);
      if (!look.has("points"))
        look.fail("points", Message::tr("is missing: a look is a list of control points"));
      part.looks[label] = readTransferFunction(look, looks.pathOf(key));
    }
    looks.finish();
  }
  fields.finish();
}

std::vector<glm::dvec2> readPolygon(JsonFields& fields) {
  std::vector<glm::dvec2> polygon;
  const nlohmann::json& corners = fields.child("polygon");
  const bool isList = corners.is_array() && corners.size() >= 3 && corners.size() <= mostCorners;
  for (const nlohmann::json& corner : corners) {
    const bool isPlace =
        isList && corner.is_array() && corner.size() == 2 && corner[0].is_number() && corner[1].is_number();
    if (!isPlace)
      fields.fail("polygon", Message::tr("must be a list of 3 to %1 places [x, y]").arg(mostCorners));
    polygon.emplace_back(corner[0].get<double>(), corner[1].get<double>());
  }
  if (!isList)
    fields.fail("polygon", Message::tr("must be a list of 3 to %1 places [x, y]").arg(mostCorners));
  return polygon;
}

Scissors readScissors(JsonFields fields) {
  Scissors scissors;
  if (!fields.has("camera"))
    fields.fail("camera", Message::tr("is missing, under which the line was drawn"));
  scissors.camera = readCamera(fields.object("camera"));
  fields.number("aspect", scissors.aspect, positive);
  scissors.polygon = readPolygon(fields);
  fields.choice("remove", scissors.removesInside, removeWords);
  if (fields.has("depth_mm") && !fields.child("depth_mm").is_null()) {
    glm::dvec2 depth(0.0);
    fields.pair("depth_mm", depth.x, depth.y, notNegative);
    scissors.depthMm = depth;
  }
  fields.finish();
  return scissors;
}

ConnectedPiece readPiece(JsonFields fields) {
  ConnectedPiece piece;
  if (!fields.vector("seed_mm", piece.seedMm))
    fields.fail("seed_mm", Message::tr("is missing, which is a place of the piece"));
  if (!fields.has("range"))
    fields.fail("range", Message::tr("is missing, which has the lowest and the highest value of the piece"));
  if (fields.pair("range", piece.range.x, piece.range.y, anyNumber) && piece.range.x > piece.range.y)
    fields.fail("range", Message::tr("must name the smaller number first"));
  fields.integer("grow_voxels", piece.growVoxels, 0, mostGrown);
  if (double reach = 0.0; fields.number("reach_mm", reach, positive))
    piece.reachMm = reach;
  fields.choice("do", piece.fate, pieceWords);
  const bool hasLook = fields.has("look");
  if (hasLook != (piece.fate == ConnectedPiece::Fate::ownLook))
    fields.fail("look", hasLook ? Message::tr("belongs to pieces with \"do\": \"look\" alone")
                                : Message::tr("is missing, which is the piece's own list of control points"));
  if (hasLook)
    piece.look = readTransferFunction(fields.object("look"), fields.pathOf("look"));
  fields.finish();
  return piece;
}

Cut readCut(JsonFields fields) {
  Cut cut;
  if (fields.has("scissors"))
    cut.how = readScissors(fields.object("scissors"));
  else if (fields.has("piece"))
    cut.how = readPiece(fields.object("piece"));
  else
    fields.fail("scissors",
                Message::tr("is missing, and so are piece and labels, of which an entry has one"));
  fields.boolean("on", cut.isOn);
  fields.text("name", cut.name);
  fields.finish();
  return cut;
}

// The list of what is kept and of cuts, in order.
KeptPart readEntries(JsonFields& scene, const nlohmann::json& entries) {
  KeptPart part;
  for (std::size_t n = 0; n < entries.size(); ++n) {
    const nlohmann::json& entry = entries[n];
    const bool isLabels = entry.is_object() && entry.contains("labels");
    if (entry == "all")
      continue;
    const bool isBody = entry == "body";
    const bool hasBody = part.kind == Region::Kind::body || part.hidesTable;
    if ((isLabels && part.kind == Region::Kind::labels) || (isBody && hasBody))
      scene.fail("keep",
                 Message::tr("names the body or a segmentation twice, and each can stand there once"));
    if (isBody && part.kind == Region::Kind::labels)
      part.hidesTable = true;
    else if (isBody)
      part.kind = Region::Kind::body;
    else if (isLabels && hasBody)
      part.hidesTable = true;
    if (isBody)
      continue;
    if (isLabels)
      readLabelsPart(JsonFields(entry, scene.document(), placeIn("keep", n)), part);
    else if (entry.is_object())
      part.cuts.push_back(readCut(JsonFields(entry, scene.document(), placeIn("keep", n))));
    else
      scene.fail("keep", Message::tr("has an entry that is neither a part nor \"all\" or \"body\""));
  }
  return part;
}

nlohmann::ordered_json cutJson(const Cut& cut) {
  nlohmann::ordered_json json;
  if (const auto* scissors = std::get_if<Scissors>(&cut.how)) {
    nlohmann::ordered_json polygon = nlohmann::ordered_json::array();
    for (const glm::dvec2& corner : scissors->polygon)
      polygon.push_back({corner.x, corner.y});
    nlohmann::ordered_json depth;
    if (scissors->depthMm)
      depth = {scissors->depthMm->x, scissors->depthMm->y};
    json["scissors"] = {{"camera", cameraJson(scissors->camera)},
                        {"aspect", scissors->aspect},
                        {"polygon", polygon},
                        {"remove", removeWords.of(scissors->removesInside)},
                        {"depth_mm", depth}};
  } else {
    const auto& piece = std::get<ConnectedPiece>(cut.how);
    json["piece"] = {{"seed_mm", {piece.seedMm.x, piece.seedMm.y, piece.seedMm.z}},
                     {"range", {piece.range.x, piece.range.y}},
                     {"grow_voxels", piece.growVoxels},
                     {"do", pieceWords.of(piece.fate)}};
    if (piece.reachMm)
      json["piece"]["reach_mm"] = *piece.reachMm;
    if (piece.fate == ConnectedPiece::Fate::ownLook)
      json["piece"]["look"] = functionJson(piece.look);
  }
  if (!cut.isOn)
    json["on"] = false;
  if (!cut.name.empty())
    json["name"] = cut.name;
  return json;
}

// What is kept before the cuts.
nlohmann::ordered_json baseJson(const KeptPart& part) {
  if (part.kind != Region::Kind::labels)
    return part.kind == Region::Kind::body ? "body" : "all";
  nlohmann::ordered_json weights = nlohmann::ordered_json::object();
  for (const auto& [value, weight] : part.weights)
    weights[std::to_string(value)] = weight;
  nlohmann::ordered_json json{{"labels", part.labels}, {"weights", weights}};
  if (!part.moreLabels.empty()) {
    json["labels"] = nlohmann::ordered_json::array({part.labels});
    for (const std::string& path : part.moreLabels)
      json["labels"].push_back(path);
  }
  if (part.looks.empty())
    return json;
  nlohmann::ordered_json looks = nlohmann::ordered_json::object();
  for (const auto& [value, look] : part.looks)
    looks[std::to_string(value)] = functionJson(look);
  json["looks"] = looks;
  return json;
}

} // namespace

KeptPart readKeptPart(JsonFields& scene) {
  const nlohmann::json& value = scene.child("keep");
  KeptPart part;
  if (value.is_array())
    return readEntries(scene, value);
  if (value.is_object()) {
    readLabelsPart(scene.object("keep"), part);
  } else {
    if (value != "all" && value != "body")
      scene.fail("keep", Message::tr("must be \"all\", \"body\", {\"labels\": FILE, \"weights\": {…}} or a "
                                     "list of these and of cuts"));
    part.kind = value == "body" ? Region::Kind::body : Region::Kind::all;
  }
  return part;
}

nlohmann::ordered_json keptPartJson(const KeptPart& part) {
  nlohmann::ordered_json base = baseJson(part);
  if (part.cuts.empty() && !part.hidesTable)
    return base;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  if (part.hidesTable)
    list.push_back("body");
  if (part.kind != Region::Kind::all)
    list.push_back(base);
  for (const Cut& cut : part.cuts)
    list.push_back(cutJson(cut));
  return list;
}

} // namespace limn
