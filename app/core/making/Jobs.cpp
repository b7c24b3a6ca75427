// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/making/Jobs.h"

#include "app/core/sources/SceneSource.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

namespace limn {
namespace {

namespace fs = std::filesystem;

bool isPlain(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) || letter == '.' || letter == '-';
}

/// A name of letters that no shell and no file system minds: "CT bone" becomes "ct-bone".
std::string plainName(const std::string& name) {
  std::string plain;
  for (const char letter : name)
    if (isPlain(letter))
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    else if (!plain.empty() && plain.back() != '-')
      plain += '-';
  while (!plain.empty() && (plain.back() == '-' || plain.back() == '.'))
    plain.pop_back();
  return plain;
}

/// The last `parts` names of a path, without the ending.
std::string lastNames(const std::string& source, int parts) {
  fs::path rest = fs::path(source).lexically_normal();
  if (rest.filename().empty())
    rest = rest.parent_path(); // "series/"
  std::string name = rest.filename().string();
  for (const char* ending : {".nii.gz", ".nii", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti", ".vtk", ".dcm",
                             ".tif", ".tiff", ".inv3", ".json", ".png", ".exr"})
    if (name.size() > std::string_view(ending).size() && name.ends_with(ending)) {
      name.erase(name.size() - std::string_view(ending).size()); // GCC 12 warns of resize
      break;
    }
  for (rest = rest.parent_path(); parts > 1 && rest.has_filename(); --parts, rest = rest.parent_path())
    name.insert(0, rest.filename().string() + "-");
  return plainName(name);
}

/// What volumes are called in the names of pictures: as much of their paths as tells them apart.
std::vector<std::string> volumeNames(const std::vector<std::string>& volumes) {
  constexpr int mostParts = 16;
  std::vector<std::string> names;
  for (int parts = 1; parts <= mostParts; ++parts) {
    names.clear();
    for (const std::string& volume : volumes)
      names.push_back(lastNames(volume, parts));
    std::vector<std::string> sorted = names;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end())
      break;
  }
  return names;
}

/// The choices of one kind: what a picture is called by each, and the words that ask for it.
struct Choice {
  std::string name;
  std::vector<std::string> words;
};

std::vector<Choice> choices(const char* option, const std::vector<std::string>& values) {
  std::vector<Choice> all;
  for (const std::string& value : values) {
    const bool isFile = fs::path(value).is_absolute();
    all.push_back({isFile ? lastNames(value, 1) : plainName(value), {option, value}});
  }
  return all.empty() ? std::vector<Choice>{{}} : all;
}

std::vector<Choice> turns(int pictures) {
  if (pictures < 1)
    return {{}};
  const std::string of = std::to_string(pictures);
  std::vector<Choice> all;
  for (int i = 0; i < pictures; ++i) {
    std::string number = std::to_string(i);
    number.insert(0, of.size() - number.size(), '0');
    std::string name = "turn-";
    name.append(number).append("-of-").append(of);
    all.push_back({name, {"--turn", std::to_string(i).append("/").append(of)}});
  }
  return all;
}

std::string shortNumber(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number);
  return text;
}

/// What holds for every picture of a sweep.
std::vector<std::string> commonWords(const Sweep& sweep) {
  std::vector<std::string> words;
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty())
      words.insert(words.end(), {option, value});
  };
  add("--size", sweep.size);
  add("--keep", sweep.keep);
  add("--tolerance", sweep.tolerance > 0.0 ? shortNumber(sweep.tolerance) : "");
  add("--step", sweep.stepVoxels > 0.0 ? shortNumber(sweep.stepVoxels) : "");
  add("--engine", sweep.engine);
  add("--threads", sweep.threads > 0 ? std::to_string(sweep.threads) : "");
  return words;
}

Job jobOf(const Sweep& sweep, const std::string& volume, const std::vector<Choice>& chosen) {
  Job job{{"render", volume}, ""};
  std::string name;
  for (const Choice& choice : chosen) {
    job.words.insert(job.words.end(), choice.words.begin(), choice.words.end());
    if (!choice.name.empty())
      name += (name.empty() ? "" : "_") + choice.name;
  }
  const std::vector<std::string> common = commonWords(sweep);
  job.words.insert(job.words.end(), common.begin(), common.end());
  job.picture = (fs::absolute(sweep.folder) / (name + "." + sweep.format)).lexically_normal().string();
  job.words.insert(job.words.end(), {"--quiet", "--skip-existing", "-o", job.picture});
  return job;
}

void requireOwnPictures(const std::vector<Job>& jobs) {
  std::map<std::string, const Job*> known;
  for (const Job& job : jobs) {
    for (const std::string& word : job.words)
      if (word.find('\n') != std::string::npos)
        throw Error(Error::Kind::usage, "A name has a line break, and a job is one line: rename it (" +
                                            word.substr(0, word.find('\n')) + "…).");
    if (const auto [first, isNew] = known.emplace(job.picture, &job); !isNew)
      throw Error(Error::Kind::usage, "Two jobs would write " + job.picture + ": one of " +
                                          first->second->words[1] + ", one of " + job.words[1] +
                                          "; name each volume, preset, model and view once.");
  }
}

} // namespace

std::vector<Job> jobsOf(const Sweep& sweep) {
  if (sweep.volumes.empty())
    throw Error(Error::Kind::usage,
                "There is nothing to draw: name a volume, or a file of them with --from.");
  std::vector<std::string> sources;
  for (const std::string& volume : sweep.volumes)
    sources.push_back(absoluteSource(volume));
  const std::vector<std::string> names = volumeNames(sources);
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < sources.size(); ++i)
    for (const Choice& preset : choices("--preset", sweep.presets))
      for (const Choice& model : choices("--model", sweep.models))
        for (const Choice& view : choices("--view", sweep.views))
          for (const Choice& turn : turns(sweep.turntable))
            jobs.push_back(jobOf(sweep, sources[i], {{names[i], {}}, preset, model, view, turn}));
  requireOwnPictures(jobs);
  return jobs;
}

std::string shellLine(const std::string& program, const std::vector<std::string>& words) {
  const auto quoted = [](const std::string& word) {
    constexpr std::string_view harmless =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=+%@";
    if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos)
      return word;
    std::string text = "'";
    for (const char letter : word)
      text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return text + "'";
  };
  std::string line = quoted(program);
  for (const std::string& word : words)
    line += " " + quoted(word);
  return line;
}

} // namespace limn
