// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pictures/SharedVolumes.h"

#include "io/labels/LabelNames.h"

#include <algorithm>
#include <set>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> slices{"", ".dcm", ".png"};
const std::set<std::string> volumes{".nii", ".gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti", ".tif", ".dcm"};

bool isFolderOfSlices(const std::vector<fs::path>& files) {
  return files.size() > 1 && slices.contains(files.front().extension()) &&
         std::ranges::all_of(
             files, [&](const fs::path& file) { return file.extension() == files.front().extension(); });
}

void addVolumes(const fs::path& folder, std::vector<fs::path>& found) {
  std::vector<fs::path> files;
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    (entry.is_directory() ? folders : files).push_back(entry.path());
  if (isFolderOfSlices(files))
    found.push_back(folder);
  else
    std::ranges::copy_if(files, std::back_inserter(found), [](const fs::path& file) {
      return volumes.contains(file.extension()) && !isNamedLikeLabels(file);
    });
  for (const fs::path& below : folders)
    if (below.filename() != "thumbs") // pictures of the volumes beside it
      addVolumes(below, found);
}

} // namespace

std::vector<fs::path> volumesBelow(const fs::path& folder) {
  std::vector<fs::path> found;
  addVolumes(folder, found);
  std::ranges::sort(found);
  return found;
}

} // namespace limn::test
