// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/families/Families.h"

#include "io/ImageFile.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"
#include "io/scenefile/FigureFile.h"
#include "io/scenefile/SessionFile.h"

#include <algorithm>

// The looks of what Limn saved itself: scenes, sessions, and the pictures and figures that carry them.
namespace limn {
namespace {

const std::vector<std::string> pictureEndings{".png", ".tif", ".tiff", ".exr", ".jpg", ".jpeg", ".pdf"};

// Told by its first key before it is parsed: other programs' looks may be long.
bool isSaved(std::string_view text) {
  const auto names = [&](std::string_view key) { return text.find(key) != std::string_view::npos; };
  return (names("\"limn_session\"") && looksLikeSession(text)) ||
         (names("\"limn_scene\"") && looksLikeScene(text)) ||
         (names("\"limn_figure\"") && looksLikeFigure(text));
}

// What a preset has no place for, as far as the scene has it.
std::vector<Message> leftBehind(const SceneDocument& document) {
  std::vector<Message> sentences{
      Message::tr("Curve, projection and light were taken over; its view, quality and background were not.")};
  if (document.scene.fog.mode != Fog::Mode::none)
    sentences.push_back(Message::tr("Its fog was left out."));
  const KeptPart& keep = document.keep;
  if (!keep.looks.empty() || std::ranges::any_of(keep.cuts, pieceWithLook))
    sentences.push_back(Message::tr("The curves that single labels and pieces had were left out."));
  const bool isFaded = std::ranges::any_of(keep.weights, [](const auto& of) { return of.second < 1.0; });
  if (document.scene.crop != CropBox{} || keep.kind == Region::Kind::body || keep.hidesTable || isFaded ||
      std::ranges::any_of(keep.cuts, takesAway))
    sentences.push_back(Message::tr("What was cropped, cut or hidden there was left out."));
  if (!document.measurements.empty())
    sentences.push_back(Message::tr("Its measurements were left out."));
  return sentences;
}

ReadLook lookOfScene(const SceneDocument& document, const std::string& file, const std::string& called) {
  if (!document.hasTransferFunction)
    failReading(file, Message::tr("it leaves the curve to its volume"),
                Message::tr("open it and export the look that is shown"));
  return {presetOf(document.scene, called), leftBehind(document)};
}

// The preset in use, or the one that the look was made from.
std::string nameIn(const SessionDocument& session, const std::string& file) {
  const std::string name = session.changedPreset ? session.changedPreset->name : session.preset;
  return name.empty() ? lookNameOf(file) : plainText(name, 200);
}

// Each look once: panels commonly show one from several sides.
std::vector<ReadLook> looksOf(const FigureDocument& figure, const std::string& file) {
  std::vector<ReadLook> looks;
  for (const FigurePanelDocument& panel : figure.panels) {
    if (panel.plane)
      continue;
    ReadLook look = lookOfScene(panel.scene, file, lookNameOf(file, looks.size()));
    const bool isKnown = std::ranges::any_of(looks, [&](ReadLook known) {
      known.preset.name = look.preset.name;
      return known.preset == look.preset;
    });
    if (!isKnown)
      looks.push_back(std::move(look));
  }
  if (looks.empty())
    failReading(file, Message::tr("the figure shows slices alone"),
                Message::tr("choose a figure with a picture"));
  return looks;
}

std::vector<ReadLook> readSaved(std::string_view text, const std::string& name,
                                const std::optional<LookTarget>&) {
  if (looksLikeFigure(text))
    return looksOf(parseFigure(text, name), name);
  if (!looksLikeSession(text))
    return {lookOfScene(parseScene(text, name), name, lookNameOf(name))};
  const SessionDocument session = parseSession(text, name);
  return {lookOfScene(session.scene, name, nameIn(session, name))};
}

} // namespace

LookFormat limnSceneFormat() {
  std::vector<std::string> endings{".limn.json"};
  endings.insert(endings.end(), pictureEndings.begin(), pictureEndings.end());
  return {
      Message::tr("picture, figure, scene or session of Limn"), endings, isSaved, readSaved, nullptr, true};
}

std::string lookText(const std::filesystem::path& path) {
  const std::string ending = lowerCase(path.extension().string());
  if (std::ranges::find(pictureEndings, ending) == pictureEndings.end())
    return readTextFile(path);
  std::string description = readImageDescription(path);
  if (!isSaved(description))
    failReading(path.filename(), Message::tr("it is no picture that Limn saved with its look"),
                Message::tr("choose one that Limn saved of a volume, or a look"));
  return description;
}

} // namespace limn
