// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/FigureFile.h"

#include "io/json/JsonFields.h"
#include "io/scenefile/SceneJson.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

constexpr Limits dotLimits{fewestDotsPerInch, mostDotsPerInch};
constexpr Limits textLimits{1.0, 200.0};

void readSize(JsonFields fields, FigureSettings& settings) {
  fields.choice("unit", settings.unit, figureUnits);
  fields.number("width", settings.width, positive);
  if (fields.has("height"))
    fields.number("height", settings.height.emplace(), positive);
  fields.number("dpi", settings.dotsPerInch, dotLimits);
  fields.number("panel_aspect", settings.panelAspect, positive);
  fields.finish();
}

void readMarks(JsonFields fields, FigureSettings& settings) {
  for (const FigureMark mark : figureMarks)
    fields.boolean(nameOf(mark), settings.marks[static_cast<std::size_t>(mark)]);
  fields.finish();
}

// What older files say of distances goes to `old`.
FigurePanelDocument readPanel(JsonFields fields, std::vector<Measurement>& old) {
  FigurePanelDocument panel;
  fields.text("name", panel.name);
  if (fields.has("plane"))
    fields.choice("plane", panel.plane.emplace(), patientPlanes);
  if (!fields.has("scene"))
    fields.fail("scene", Message::tr("is missing"));
  panel.scene = readScene(fields.object("scene"));
  if (JsonFields scene = fields.object("scene"); scene.has("accuracy"))
    panel.accuracy = readAccuracy(scene.object("accuracy"));
  if (fields.has("slices"))
    panel.planes = readPlanes(fields.object("slices"), old);
  fields.finish();
  return panel;
}

std::vector<FigurePanelDocument> readPanels(JsonFields& fields) {
  const nlohmann::json& list = fields.child("panels");
  if (!list.is_array() || list.empty() || list.size() > mostPanels)
    fields.fail("panels", Message::tr("must be a list of 1 to %1 panels").arg(std::to_string(mostPanels)));
  std::vector<FigurePanelDocument> panels;
  std::vector<Measurement> old;
  for (std::size_t i = 0; i < list.size(); ++i)
    panels.push_back(readPanel(JsonFields(list[i], fields.document(), "panels." + std::to_string(i)), old));
  // Each slice had the same one; now all panels of a scene have it.
  for (FigurePanelDocument& panel : panels)
    if (!old.empty() && panel.scene.measurements.empty())
      panel.scene.measurements.push_back(old.front());
  return panels;
}

Json sizeJson(const FigureSettings& settings) {
  Json json = {{"unit", nameOf(settings.unit)}, {"width", settings.width}};
  if (settings.height)
    json["height"] = *settings.height;
  json["dpi"] = settings.dotsPerInch;
  json["panel_aspect"] = settings.panelAspect;
  return json;
}

FigureSettings readSettings(JsonFields& fields) {
  FigureSettings settings;
  if (fields.has("size"))
    readSize(fields.object("size"), settings);
  fields.number("text_pt", settings.textPoints, textLimits);
  fields.choice("page", settings.page, figurePages);
  if (fields.has("marks"))
    readMarks(fields.object("marks"), settings);
  return settings;
}

Json settingsJson(const FigureSettings& settings) {
  Json json = {{"limn_figure", 1},
               {"size", sizeJson(settings)},
               {"text_pt", settings.textPoints},
               {"page", nameOf(settings.page)}};
  for (const FigureMark mark : figureMarks)
    json["marks"][nameOf(mark)] = settings.shows(mark);
  return json;
}

Json panelJson(const FigurePanelDocument& panel) {
  Json json = {{"name", panel.name}};
  if (panel.plane) {
    json["plane"] = nameOf(*panel.plane);
    json["slices"] = planesJson(panel.planes);
  }
  json["scene"] = sceneJson(panel.scene);
  if (panel.accuracy)
    json["scene"]["accuracy"] = accuracyJson(*panel.accuracy);
  return json;
}

} // namespace

bool looksLikeFigure(std::string_view text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  return json.is_object() && json.contains("limn_figure");
}

FigureDocument parseFigure(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  JsonFields fields(json, name, "");
  requireVersion(fields, "limn_figure", "figure");
  FigureDocument figure;
  figure.settings = readSettings(fields);
  if (!fields.has("panels"))
    fields.fail("panels", Message::tr("is missing"));
  figure.panels = readPanels(fields);
  fields.finish();
  return figure;
}

std::string figureToJson(const FigureDocument& figure) {
  Json json = settingsJson(figure.settings);
  for (const FigurePanelDocument& panel : figure.panels)
    json["panels"].push_back(panelJson(panel));
  return textOf(json);
}

FigureSettings parseFigureSettings(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  JsonFields fields(json, name, "");
  requireVersion(fields, "limn_figure", "figure");
  const FigureSettings settings = readSettings(fields);
  fields.finish();
  return settings;
}

std::string figureSettingsToJson(const FigureSettings& settings) {
  return textOf(settingsJson(settings));
}

} // namespace limn
