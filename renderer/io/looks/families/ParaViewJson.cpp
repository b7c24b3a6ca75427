// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps as JSON: ParaView's, with opacity those of vtk.js and VolView; Tomviz' list.
#include "io/json/JsonFields.h"
#include "io/looks/curves/CurvedSegments.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/VtkProperty.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace limn {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t colorWidth = 4;   // value, red, green, blue
constexpr std::size_t bentWidth = 4;    // value, opacity, midpoint, sharpness
constexpr std::size_t opacityWidth = 2; // value, opacity

bool isParaViewJson(std::string_view text) {
  const std::string_view start = trimmed(text);
  return (start.starts_with('[') || start.starts_with('{')) &&
         (text.find("\"RGBPoints\"") != std::string_view::npos ||
          text.find("\"IndexedColors\"") != std::string_view::npos ||
          text.find("\"colorSpace\"") != std::string_view::npos);
}

/// One colour map of a file.
class ParaViewMap {
public:
  ParaViewMap(const json& item, const std::string& file, std::size_t index)
      : m_fields(item, file, "[" + std::to_string(index) + "]"), m_file(file), m_index(index) {
    m_fields.has("Name") ? m_fields.text("Name", m_name) : m_fields.text("name", m_name);
  }

  const std::string& name() const { return m_name; }

  bool isCategorical() {
    for (const char* key : {"IndexedColors", "IndexedLookup"})
      if (m_fields.has(key) && !m_fields.child(key).empty() && m_fields.child(key) != 0 &&
          m_fields.child(key) != false)
        return true;
    return false;
  }

  ReadLook look(const std::optional<LookTarget>& target);

private:
  std::vector<double> flatNumbers(const std::string& key, std::size_t width);
  std::vector<BentPoint> colors();
  std::vector<BentPoint> opacities(const std::vector<BentPoint>& colors, std::vector<Message>& changes);
  SegmentRule colorRule(std::vector<Message>& changes);
  bool flag(const std::string& key);
  bool namesValues();

  JsonFields m_fields;
  const std::string& m_file;
  std::size_t m_index;
  std::string m_name;
};

// The numbers of a list, so many for each point; none where there is no such list.
std::vector<double> ParaViewMap::flatNumbers(const std::string& key, std::size_t width) {
  std::vector<double> list;
  if (!m_fields.has(key) || m_fields.child(key).is_null())
    return list;
  const json& items = m_fields.child(key);
  if (!items.is_array() || items.size() % width != 0)
    m_fields.fail(key, Message::tr("must be a list with %1 numbers for each point").arg(width));
  requirePointCount(std::max<std::size_t>(1, items.size() / width), m_file);
  for (const json& item : items) {
    if (!item.is_number())
      m_fields.fail(key, Message::tr("must be a list with %1 numbers for each point").arg(width));
    list.push_back(item.get<double>());
  }
  return list;
}

std::vector<BentPoint> ParaViewMap::colors() {
  const std::vector<double> list =
      flatNumbers(m_fields.has("RGBPoints") ? "RGBPoints" : "colors", colorWidth);
  std::vector<BentPoint> points;
  for (std::size_t i = 0; i < list.size(); i += colorWidth)
    points.push_back({{list[i], {list[i + 1], list[i + 2], list[i + 3]}, 0.0}});
  return points;
}

std::vector<BentPoint> ParaViewMap::opacities(const std::vector<BentPoint>& colors,
                                              std::vector<Message>& changes) {
  const std::vector<double> bent = flatNumbers("Points", bentWidth);
  const std::vector<double> straight = flatNumbers("OpacityPoints", opacityWidth);
  std::vector<BentPoint> ofBent, ofStraight;
  for (std::size_t i = 0; i < bent.size(); i += bentWidth)
    ofBent.push_back({{bent[i], glm::dvec3(1.0), bent[i + 1]}, bent[i + 2], bent[i + 3]});
  for (std::size_t i = 0; i < straight.size(); i += opacityWidth)
    ofStraight.push_back({{straight[i], glm::dvec3(1.0), straight[i + 1]}});
  if (!ofBent.empty() && !ofStraight.empty() &&
      !std::equal(ofBent.begin(), ofBent.end(), ofStraight.begin(), ofStraight.end(),
                  [](const BentPoint& a, const BentPoint& b) { return a.point == b.point; }))
    tell(changes,
         Message::tr("Its opacities for ParaView and for VolView differ; those for ParaView were taken."));
  if (!ofBent.empty())
    return ofBent;
  if (!ofStraight.empty() || colors.empty())
    return ofStraight;
  tell(changes, Message::tr("It has colours alone; its opacity became a ramp from 0 to 1 over them."));
  const auto [low, high] =
      std::minmax_element(colors.begin(), colors.end(), [](const BentPoint& a, const BentPoint& b) {
        return a.point.value < b.point.value;
      });
  return {{{low->point.value, glm::dvec3(1.0), 0.0}}, {{high->point.value, glm::dvec3(1.0), 1.0}}};
}

bool ParaViewMap::flag(const std::string& key) {
  // Settings of ParaView are numbers, those of VolView true or false.
  return m_fields.has(key) && m_fields.child(key) != false && m_fields.child(key) != 0 &&
         !m_fields.child(key).is_null();
}

// Annotations, which a legend shows.
bool ParaViewMap::namesValues() {
  return std::ranges::any_of(
      std::array{"Annotations", "AnnotatedValues", "ActiveAnnotatedValues"}, [this](const char* key) {
        return m_fields.has(key) && m_fields.child(key).is_array() && !m_fields.child(key).empty();
      });
}

SegmentRule ParaViewMap::colorRule(std::vector<Message>& changes) {
  std::string space = "RGB";
  m_fields.has("ColorSpace") ? m_fields.text("ColorSpace", space) : m_fields.text("colorSpace", space);
  SegmentRule rule;
  rule.isLogarithmic = flag("UseLogScale");
  constexpr std::array spaces{
      std::pair{"rgb", ColorSpace::rgb}, std::pair{"hsv", ColorSpace::hsv}, std::pair{"lab", ColorSpace::lab},
      std::pair{"diverging", ColorSpace::diverging}, std::pair{"step", ColorSpace::step}};
  const std::string wanted = lowerCase(space);
  const auto found =
      std::find_if(spaces.begin(), spaces.end(), [&](const auto& entry) { return wanted == entry.first; });
  if (found != spaces.end())
    rule.space = found->second;
  if (rule.space == ColorSpace::hsv && flag("HSVWrap"))
    rule.space = ColorSpace::wrappedHsv;
  if (wanted == "lab/ciede2000")
    rule.space = ColorSpace::lab;
  const bool isKnown = found != spaces.end() || wanted == "lab/ciede2000";
  if (!isKnown || wanted == "lab/ciede2000")
    tell(
        changes,
        Message::tr("Its colour space \"%1\" became %2.").arg(plainText(space, 40), isKnown ? "Lab" : "RGB"));
  else if (rule.space != ColorSpace::rgb)
    tell(changes,
         Message::tr("Colours between points in the colour space %1 became points in RGB.").arg(space));
  if (rule.isLogarithmic)
    tell(changes, Message::tr("Its logarithmic scale became a linear one with points in between."));
  return rule;
}

bool isOverUnitRange(const TransferFunction& function) {
  return function.points.front().value >= 0.0 && function.points.back().value <= 1.0;
}

ReadLook ParaViewMap::look(const std::optional<LookTarget>& target) {
  ReadLook read;
  const std::vector<BentPoint> colorPoints = colors();
  const std::vector<BentPoint> opacityPoints = opacities(colorPoints, read.changes);
  const SegmentRule rule = colorRule(read.changes);
  const SegmentRule opacityRule{ColorSpace::rgb, rule.isLogarithmic};
  read.preset.transferFunction = merged(
      straightened(checkedCurve(opacityPoints, m_file, read.changes), opacityRule, m_file, read.changes),
      straightened(checkedCurve(colorPoints, m_file, read.changes), rule, m_file, read.changes),
      read.changes);
  if (!flag("AbsoluteRange") && isOverUnitRange(read.preset.transferFunction))
    read.preset.transferFunction = stretchedOver(read.preset.transferFunction, target, read.changes);
  if (m_fields.has("NanColor"))
    tell(read.changes,
         Message::tr("Its colour of values that are no number was left out: Limn has none such."));
  if (namesValues())
    tell(read.changes, Message::tr("Its names of single values were left out: Limn's curves have none."));
  tell(read.changes, oneMillimetreTaken);
  read.preset.name = m_name.empty() ? lookNameOf(m_file, m_index) : plainText(m_name, 200);
  read.preset.modality = modalityIn(read.preset.name);
  return read;
}

std::vector<ReadLook> readParaViewJson(std::string_view text, const std::string& name,
                                       const std::optional<LookTarget>& target) {
  json document = parsedJson(text, name);
  if (!document.is_array())
    document = json::array({std::move(document)});
  std::vector<ReadLook> looks;
  std::vector<Message> passedOver;
  for (const json& item : document) {
    ParaViewMap map(item, name, looks.size() + passedOver.size());
    if (map.isCategorical())
      passedOver.push_back(
          Message::tr("\"%1\" was passed over: it names colours for single values, which is no curve.")
              .arg(plainText(map.name(), 80)));
    else
      looks.push_back(map.look(target));
  }
  if (looks.empty())
    failReading(name,
                passedOver.empty()
                    ? Message::tr("it holds no colour map")
                    : Message::tr("its indexed colours belong to single values, which is no curve"),
                Message::tr("choose a colour map over a range of values"));
  // What is said of the file is said with each of its looks: whoever takes one alone is told, too.
  for (ReadLook& look : looks)
    for (const Message& sentence : passedOver)
      tell(look.changes, sentence);
  return looks;
}

WrittenLook writeParaViewJson(const Preset& preset, const std::optional<LookTarget>&) {
  WrittenLook written;
  tellLostModel(preset.shading, written.changes);
  TransferFunction function = overOneMillimetre(preset.transferFunction, written.changes);
  if (function.points.empty())
    function.points = {{}}; // as transparent
  ordered_json colors = ordered_json::array(), bent = ordered_json::array(), straight = ordered_json::array();
  for (const ControlPoint& point : function.points) {
    for (const double number : {point.value, point.color.r, point.color.g, point.color.b})
      colors.push_back(number);
    for (const double number : {point.value, point.opacity, 0.5, 0.0})
      bent.push_back(number);
    for (const double number : {point.value, point.opacity})
      straight.push_back(number);
  }
  if (preset.shading)
    tell(written.changes, Message::tr("Its light was left out: such files hold curves alone."));
  if (preset.gradientOpacity)
    tell(written.changes, Message::tr("Its gradient opacity was left out: such files hold curves alone."));
  tellLostParts(preset, written.changes);
  const ordered_json map{{"Name", preset.name},
                         {"ColorSpace", "RGB"},
                         {"RGBPoints", colors},
                         {"Points", bent},
                         {"OpacityPoints", straight},
                         {"AbsoluteRange", true},
                         {"EffectiveRange", {function.points.front().value, function.points.back().value}}};
  written.text = textOf(ordered_json::array({map}));
  return written;
}

} // namespace

LookFormat paraViewJsonFormat() {
  return {Message::tr("ParaView, vtk.js or VolView colour map"),
          {".paraview.json", ".volview.json"},
          isParaViewJson,
          readParaViewJson,
          writeParaViewJson};
}

} // namespace limn
