// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SessionFile.h"

#include "io/json/JsonFields.h"
#include "io/scenefile/SceneJson.h"
#include "scene/light/Shading.h"

#include <nlohmann/json.hpp>

#include <cinttypes>
#include <cstdio>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;
using Panel = SessionDocument::Panel;

constexpr int mostLabels = 65535;
constexpr Words<Panel, 4> panelWords{{"none", "properties", "effects", "accuracy"}};

void readComparison(JsonFields fields, SessionDocument& session) {
  fields.choice("layout", session.layout, compareLayouts);
  fields.boolean("layout_is_asked", session.layoutIsAsked);
  fields.choice("left", session.leftModel, shadingModels);
  fields.choice("right", session.rightModel, shadingModels);
  if (fields.has("own_model"))
    fields.choice("own_model", session.ownModel.emplace(), shadingModels);
  fields.number("wipe", session.wipe, fraction);
  const auto look = [&](const char* key, std::optional<Preset>& preset) {
    if (!fields.has(key))
      return;
    JsonFields its = fields.object(key);
    preset = readPreset(its);
  };
  look("snapshot", session.snapshot);
  look("look", session.comparedLook);
  look("look_from", session.comparedFrom);
  fields.finish();
}

void readWindow(JsonFields fields, SessionDocument& session) {
  fields.choice("panel", session.panel, panelWords);
  fields.text("preset", session.preset);
  if (fields.has("changed_preset")) {
    JsonFields its = fields.object("changed_preset");
    session.changedPreset = readPreset(its);
  }
  fields.boolean("crop_box", session.cropBoxIsShown);
  fields.boolean("gradient_curve", session.gradientCurveIsShown);
  if (int place = 0; fields.integer("label_in_hand", place, 0, mostLabels))
    session.labelInHand = place;
  fields.finish();
}

CropBox readCropBefore(JsonFields fields) {
  CropBox crop;
  fields.vector("lower", crop.lower, fraction);
  fields.vector("upper", crop.upper, fraction);
  if (!glm::all(glm::lessThan(crop.lower, crop.upper)))
    fields.fail("lower", Message::tr("must be smaller than the upper ends on every axis"));
  fields.finish();
  return crop;
}

CutOpening readOpening(JsonFields fields) {
  CutOpening opening;
  if (fields.has("corner")) {
    JsonFields corner = fields.object("corner");
    std::array<bool, 3>& ends = opening.corner.emplace();
    corner.boolean("x_upper", ends[0]);
    corner.boolean("y_upper", ends[1]);
    corner.boolean("z_upper", ends[2]);
    corner.finish();
  } else {
    fields.integer("axis", opening.axis, 0, 2);
    fields.boolean("upper", opening.isUpper);
    if (fields.has("crop_before"))
      opening.before = readCropBefore(fields.object("crop_before"));
  }
  fields.finish();
  return opening;
}

Json openingJson(const CutOpening& opening) {
  if (const auto& corner = opening.corner)
    return {{"corner", {{"x_upper", (*corner)[0]}, {"y_upper", (*corner)[1]}, {"z_upper", (*corner)[2]}}}};
  const glm::dvec3& lower = opening.before.lower;
  const glm::dvec3& upper = opening.before.upper;
  return {{"axis", opening.axis},
          {"upper", opening.isUpper},
          {"crop_before", {{"lower", {lower.x, lower.y, lower.z}}, {"upper", {upper.x, upper.y, upper.z}}}}};
}

VolumeTraits readTraits(JsonFields fields) {
  constexpr int mostVoxels = 1 << 20; // along one axis
  VolumeTraits traits;
  fields.integer("x", traits.voxels.x, 1, mostVoxels);
  fields.integer("y", traits.voxels.y, 1, mostVoxels);
  fields.integer("z", traits.voxels.z, 1, mostVoxels);
  fields.boolean("hounsfield", traits.isHounsfield);
  fields.finish();
  return traits;
}

Json traitsJson(const VolumeTraits& traits) {
  return {{"x", traits.voxels.x},
          {"y", traits.voxels.y},
          {"z", traits.voxels.z},
          {"hounsfield", traits.isHounsfield}};
}

void readVolumeOptions(JsonFields& fields, SessionDocument& session) {
  if (fields.has("series"))
    fields.integer("series", session.series.emplace(), 1, 100000);
  if (fields.has("spacing_mm"))
    fields.vector("spacing_mm", session.spacingMm.emplace(), positive);
  if (fields.has("volume_traits"))
    session.traits = readTraits(fields.object("volume_traits"));
}

} // namespace

bool looksLikeSession(std::string_view text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  return json.is_object() && json.contains("limn_session");
}

SessionDocument parseSession(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  JsonFields fields(json, name, "");
  requireVersion(fields, "limn_session", Message::tr("session"));
  SessionDocument session;
  if (!fields.has("scene"))
    fields.fail("scene", Message::tr("is missing"));
  session.scene = readScene(fields.object("scene"));
  readVolumeOptions(fields, session);
  if (fields.has("compare"))
    readComparison(fields.object("compare"), session);
  if (fields.has("slices"))
    session.planes = readPlanes(fields.object("slices"), session.scene.measurements);
  if (fields.has("window"))
    readWindow(fields.object("window"), session);
  if (fields.has("cut_open"))
    session.opening = readOpening(fields.object("cut_open"));
  fields.text("label", session.label);
  fields.text("saved_as", session.savedAs);
  fields.text("saved_digest", session.savedDigest);
  fields.boolean("unsaved", session.isUnsaved);
  fields.finish();
  return session;
}

SessionDocument sessionIn(std::string_view text, const std::filesystem::path& path) {
  SessionDocument session = parseSession(text, path.filename().string());
  session.scene = located(std::move(session.scene), path);
  return session;
}

SessionDocument readSessionFile(const std::filesystem::path& path) {
  return sessionIn(readTextFile(path), path);
}

// FNV-1a over the bytes: nobody makes files that are meant to deceive it.
std::string digestOf(std::string_view text) {
  std::uint64_t digest = 0xcbf29ce484222325u;
  for (const char byte : text)
    digest = (digest ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  char hex[17];
  std::snprintf(hex, sizeof hex, "%016" PRIx64, digest);
  return hex;
}

std::string sessionToJson(const SessionDocument& session) {
  Json json = {{"limn_session", 1}, {"scene", sceneJson(session.scene)}};
  if (session.series)
    json["series"] = *session.series;
  if (const auto& spacing = session.spacingMm)
    json["spacing_mm"] = {spacing->x, spacing->y, spacing->z};
  if (session.traits)
    json["volume_traits"] = traitsJson(*session.traits);
  json["compare"] = {{"layout", nameOf(session.layout)},
                     {"layout_is_asked", session.layoutIsAsked},
                     {"left", nameOf(session.leftModel)},
                     {"right", nameOf(session.rightModel)},
                     {"wipe", session.wipe}};
  if (session.ownModel)
    json["compare"]["own_model"] = nameOf(*session.ownModel);
  if (session.snapshot)
    json["compare"]["snapshot"] = presetJson(*session.snapshot);
  if (session.comparedLook)
    json["compare"]["look"] = presetJson(*session.comparedLook);
  if (session.comparedFrom)
    json["compare"]["look_from"] = presetJson(*session.comparedFrom);
  if (session.planes != PlaneSettings{})
    json["slices"] = planesJson(session.planes);
  json["window"] = {{"panel", panelWords.of(session.panel)},
                    {"preset", session.preset},
                    {"crop_box", session.cropBoxIsShown},
                    {"gradient_curve", session.gradientCurveIsShown}};
  if (session.labelInHand)
    json["window"]["label_in_hand"] = *session.labelInHand;
  if (session.changedPreset)
    json["window"]["changed_preset"] = presetJson(*session.changedPreset);
  if (session.opening)
    json["cut_open"] = openingJson(*session.opening);
  if (!session.label.empty())
    json["label"] = session.label;
  if (!session.savedAs.empty())
    json["saved_as"] = session.savedAs;
  if (!session.savedDigest.empty())
    json["saved_digest"] = session.savedDigest;
  if (session.isUnsaved)
    json["unsaved"] = true;
  return textOf(json);
}

} // namespace limn
