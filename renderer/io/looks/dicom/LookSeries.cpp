// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/DicomLook.h"

#include "io/reading/ReadError.h"

#include <algorithm>
#include <set>

namespace limn {
namespace {

std::size_t countHeld(const std::set<std::string>& wanted, const SeriesImages& series) {
  std::set<std::string> held;
  for (const DicomReference& image : series.images)
    if (wanted.contains(image.sopInstance))
      held.insert(image.sopInstance);
  return held.size();
}

// Of a look of several phases one is shown: the others have to be there all the same.
std::size_t countMissing(const std::set<std::string>& wanted, const SeriesImages& series) {
  std::set<std::string> there(series.leftOut.begin(), series.leftOut.end());
  for (const DicomReference& image : series.images)
    there.insert(image.sopInstance);
  return static_cast<std::size_t>(
      std::ranges::count_if(wanted, [&](const std::string& image) { return !there.contains(image); }));
}

std::set<std::string> instancesOf(const DicomLook& look) {
  std::set<std::string> instances;
  for (const DicomReference& image : look.images)
    instances.insert(image.sopInstance);
  return instances;
}

} // namespace

const SeriesImages& seriesOf(const DicomLook& look, const std::vector<SeriesImages>& all,
                             const std::string& name, const std::filesystem::path& folder) {
  const std::set<std::string> wanted = instancesOf(look);
  const auto best = std::ranges::max_element(
      all, {}, [&](const SeriesImages& series) { return countHeld(wanted, series); });
  const std::size_t held = best == all.end() ? 0 : countHeld(wanted, *best);
  const std::string place = folder.filename().string();
  if (held == 0)
    failReading(name,
                Message::tr("it belongs to another series: none of its %1 images is in %2")
                    .arg(wanted.size())
                    .arg(place),
                Message::tr("name the folder of its series (--volume PATH)"));
  if (const std::size_t missing = countMissing(wanted, *best); missing > 0)
    failReading(name,
                Message::tr("%1 of the %2 images that it belongs to are missing in %3")
                    .arg(missing)
                    .arg(wanted.size())
                    .arg(place),
                Message::tr("fetch the whole series again"));
  return *best;
}

bool belongsToOne(const DicomLook& look, const std::vector<SeriesImages>& all) {
  const std::set<std::string> wanted = instancesOf(look);
  return std::ranges::any_of(all,
                             [&](const SeriesImages& series) { return countMissing(wanted, series) == 0; });
}

} // namespace limn
