// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SweepFile.h"

#include "io/json/JsonFields.h"
#include "io/scenefile/SceneFile.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr int mostPicturesOfATurn = 9999;

void readTexts(JsonFields& fields, const std::string& key, std::vector<std::string>& texts) {
  if (!fields.has(key))
    return;
  const nlohmann::json& list = fields.child(key);
  if (!list.is_array())
    fields.fail(key, Message::tr("must be a list of texts"));
  for (const nlohmann::json& text : list) {
    if (!text.is_string())
      fields.fail(key, Message::tr("must be a list of texts"));
    texts.push_back(text.get<std::string>());
  }
}

// What is built in, such as phantom:2, has no file.
std::string besideFile(const std::string& name, const fs::path& folder) {
  const fs::path beside = folder / name;
  std::error_code unknown;
  return fs::exists(beside, unknown) ? beside.string() : name;
}

} // namespace

Sweep parseSweep(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  JsonFields fields(json, name, "");
  requireVersion(fields, "limn_sweep", Message::tr("sweep"));
  Sweep sweep;
  readTexts(fields, "volumes", sweep.volumes);
  readTexts(fields, "presets", sweep.presets);
  readTexts(fields, "models", sweep.models);
  readTexts(fields, "views", sweep.views);
  fields.integer("turntable", sweep.turntable, 0, mostPicturesOfATurn);
  fields.text("size", sweep.size);
  fields.text("keep", sweep.keep);
  fields.number("tolerance_levels", sweep.tolerance, {0.01, 255.0});
  fields.number("step_voxels", sweep.stepVoxels, {1e-4, 1e4});
  fields.text("engine", sweep.engine);
  fields.integer("threads", sweep.threads, 1, 4096);
  fields.text("format", sweep.format);
  fields.text("output", sweep.folder);
  fields.finish();
  return sweep;
}

Sweep readSweepFile(const fs::path& path) {
  Sweep sweep = parseSweep(readTextFile(path), path.string());
  const fs::path folder = fs::absolute(path).parent_path();
  for (std::vector<std::string>* names : {&sweep.volumes, &sweep.presets})
    for (std::string& name : *names)
      name = besideFile(name, folder);
  if (!sweep.folder.empty())
    sweep.folder = (folder / sweep.folder).lexically_normal().string();
  return sweep;
}

} // namespace limn
