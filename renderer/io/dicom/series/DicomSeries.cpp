// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/series/DicomSeries.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace limn {
namespace {

// Files write direction cosines with as few as four digits.
constexpr double sameDirection = 1e-3;
constexpr double sameSpacing = 1e-3;

bool haveOneOrientation(const DicomFrame& a, const DicomFrame& b) {
  if (a.axes.has_value() != b.axes.has_value() || a.positionMm.has_value() != b.positionMm.has_value())
    return false;
  return !a.axes || (glm::length((*a.axes)[0] - (*b.axes)[0]) < sameDirection &&
                     glm::length((*a.axes)[1] - (*b.axes)[1]) < sameDirection);
}

bool haveOneSpacing(const DicomFrame& a, const DicomFrame& b) {
  if (a.pixelSpacingMm.has_value() != b.pixelSpacingMm.has_value())
    return false;
  return !a.pixelSpacingMm ||
         glm::length(*a.pixelSpacingMm - *b.pixelSpacingMm) < sameSpacing * glm::length(*a.pixelSpacingMm);
}

bool makeOneVolume(const DicomSlice& a, const DicomSlice& b) {
  // Several frames without positions are a whole of their own.
  const bool isStack = a.header->frames.size() > 1 && !a.frame().positionMm;
  if (isStack && a.header != b.header)
    return false;
  const auto facts = [](const DicomHeader& h) {
    return std::tie(h.seriesInstance, h.studyInstance, h.columns, h.rows, h.format.samples,
                    h.format.photometric);
  };
  return facts(*a.header) == facts(*b.header) && a.frame().stackId == b.frame().stackId &&
         haveOneOrientation(a.frame(), b.frame()) && haveOneSpacing(a.frame(), b.frame());
}

bool canBecomeVolume(const DicomSeries& series) {
  try {
    requireSupported(*series.front().header);
    return true;
  } catch (const Error&) {
    return false;
  }
}

// Distances along the normal closer than this are one position, mm.
double sameDistanceMm(const DicomSeries& series) {
  const glm::dvec2 spacing = series.front().frame().pixelSpacingMm.value_or(glm::dvec2(1.0));
  return 0.01 * std::min({spacing.x, spacing.y, 1.0});
}

// Whether two parts of one volume found in different folders complement each other.
bool complement(const DicomSeries& a, const DicomSeries& b) {
  if (!isPlaced(a) || !isPlaced(b))
    return false;
  const double tolerance = sameDistanceMm(a);
  std::vector<double> distances;
  for (const DicomSlice& slice : a)
    distances.push_back(distanceMm(slice, a));
  std::sort(distances.begin(), distances.end());
  return std::none_of(b.begin(), b.end(), [&](const DicomSlice& slice) {
    const double distance = distanceMm(slice, a);
    const auto near = std::lower_bound(distances.begin(), distances.end(), distance - tolerance);
    return near != distances.end() && *near <= distance + tolerance;
  });
}

std::vector<DicomSeries> merged(std::vector<DicomSeries> parts) {
  std::vector<DicomSeries> whole;
  for (DicomSeries& part : parts) {
    const auto found = std::find_if(whole.begin(), whole.end(), [&](const DicomSeries& other) {
      return makeOneVolume(other.front(), part.front()) &&
             other.front().header->path.parent_path() != part.front().header->path.parent_path() &&
             complement(other, part);
    });
    if (found == whole.end())
      whole.push_back(std::move(part));
    else
      found->insert(found->end(), part.begin(), part.end());
  }
  return whole;
}

/// All slices at one position.
using Station = std::vector<DicomSlice>;

struct PhaseName {
  DicomPhase phase;
  Message name;
  bool isTime; // differs from slice to slice, so that only its order at a position means something
};

const PhaseName phaseNames[dicomPhaseCount] = {
    {DicomPhase::temporalPosition, Message::tr("temporal position"), false},
    {DicomPhase::triggerTime, Message::tr("trigger time"), true},
    {DicomPhase::cardiacDelay, Message::tr("delay after the heart beat"), true},
    {DicomPhase::echoTime, Message::tr("echo time"), false},
    {DicomPhase::diffusionBValue, Message::tr("diffusion b-value"), false},
    {DicomPhase::imageType, Message::tr("image type"), false},
    {DicomPhase::acquisitionNumber, Message::tr("acquisition number"), false},
    {DicomPhase::acquisitionTime, Message::tr("acquisition time"), true},
    {DicomPhase::contentTime, Message::tr("content time"), true}};

const std::string& phaseOf(const DicomSlice& slice, DicomPhase phase) {
  return slice.frame().phase[static_cast<std::size_t>(phase)];
}

// Numbers by size, text by its letters.
bool comesBefore(const std::string& a, const std::string& b) {
  double x = 0.0;
  double y = 0.0;
  const auto readA = std::from_chars(a.data(), a.data() + a.size(), x);
  const auto readB = std::from_chars(b.data(), b.data() + b.size(), y);
  const bool areNumbers = readA.ec == std::errc() && readB.ec == std::errc();
  return areNumbers && x != y ? x < y : a < b;
}

struct Before {
  bool operator()(const std::string& a, const std::string& b) const { return comesBefore(a, b); }
};

std::vector<Station> stationsOf(const DicomSeries& series) {
  std::vector<Station> stations;
  const double tolerance = sameDistanceMm(series);
  double last = 0.0;
  for (const DicomSlice& slice : series) {
    const double distance = distanceMm(slice, series);
    if (stations.empty() || distance - last > tolerance)
      stations.emplace_back();
    stations.back().push_back(slice);
    last = distance;
  }
  return stations;
}

bool isSettled(const std::vector<Station>& stations) {
  return std::all_of(stations.begin(), stations.end(), [](const Station& s) { return s.size() == 1; });
}

// How many positions show each value.
std::map<std::string, std::size_t, Before> coverage(const std::vector<Station>& stations, DicomPhase phase) {
  std::map<std::string, std::size_t, Before> counts;
  for (const Station& station : stations) {
    std::set<std::string> values;
    for (const DicomSlice& slice : station)
      values.insert(phaseOf(slice, phase));
    for (const std::string& value : values)
      ++counts[value];
  }
  return counts;
}

bool tellsSlicesApart(const std::vector<Station>& stations, DicomPhase phase) {
  return std::any_of(stations.begin(), stations.end(), [&](const Station& station) {
    return std::any_of(station.begin(), station.end(), [&](const DicomSlice& slice) {
      return phaseOf(slice, phase) != phaseOf(station.front(), phase);
    });
  });
}

void keepValue(Station& station, DicomPhase phase, const std::string& value) {
  const auto has = [&](const DicomSlice& slice) { return phaseOf(slice, phase) == value; };
  if (std::any_of(station.begin(), station.end(), has))
    std::erase_if(station, [&](const DicomSlice& slice) { return !has(slice); });
}

// Keeps the value that most positions show; of times, which differ from slice to slice, each position's
// first.
void settle(std::vector<Station>& stations, const PhaseName& name, std::vector<Message>& chosen) {
  const auto counts = coverage(stations, name.phase);
  const auto most = std::max_element(counts.begin(), counts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  const bool isShared = most->second == stations.size();
  for (Station& station : stations) {
    const auto first = std::min_element(station.begin(), station.end(), [&](const auto& a, const auto& b) {
      return comesBefore(phaseOf(a, name.phase), phaseOf(b, name.phase));
    });
    keepValue(station, name.phase,
              name.isTime && !isShared ? std::string(phaseOf(*first, name.phase)) : most->first);
  }
  const Message value = most->first.empty() ? Message::tr("unset") : Message(most->first);
  chosen.push_back(isShared ? Message::tr("%1 %2 of %3").arg(name.name, value, counts.size())
                            : Message::tr("the first %1 at each position").arg(name.name));
}

// Drops images found more than once (one SOP instance UID), with a warning.
DicomSeries withoutCopies(DicomSeries series, std::vector<Message>& warnings) {
  std::set<std::pair<std::string, int>> seen;
  const auto copies = std::erase_if(series, [&](const DicomSlice& slice) {
    return !slice.header->sopInstance.empty() &&
           !seen.insert({slice.header->sopInstance, slice.frameIndex}).second;
  });
  if (copies > 0)
    warnings.push_back((copies == 1
                            ? Message::tr("%1 image is a copy of another of the series and left out.")
                            : Message::tr("%1 images are copies of another of the series and left out."))
                           .arg(copies));
  return series;
}

// Leaves one slice at each position of a placed, sorted series: of several phases (temporal position,
// trigger time, echo …) one is kept, with a warning. Returns them sorted.
DicomSeries onePhase(const DicomSeries& series, std::vector<Message>& warnings) {
  std::vector<Station> stations = stationsOf(series);
  const auto repeated = static_cast<std::size_t>(
      std::count_if(stations.begin(), stations.end(), [](const Station& s) { return s.size() > 1; }));
  std::size_t images = 0;
  for (const Station& station : stations)
    images += station.size();
  const std::size_t leftOut = images - stations.size();

  std::vector<Message> chosen;
  for (const PhaseName& name : phaseNames)
    if (!isSettled(stations) && tellsSlicesApart(stations, name.phase))
      settle(stations, name, chosen);
  if (!isSettled(stations))
    chosen.push_back(Message::tr("the lowest image number at each position"));

  if (leftOut > 0) {
    Message shown = chosen.front();
    for (std::size_t i = 1; i < chosen.size(); ++i)
      shown = shown.followedBy(", ", chosen[i]);
    warnings.push_back(
        (2 * repeated >= stations.size()
             ? Message::tr("The series holds several phases (%1 images at %2 positions); shown is: %3.")
             : Message::tr("The series repeats some positions (%1 images at %2 positions); shown is: %3."))
            .arg(images, stations.size(), shown));
  }
  DicomSeries result;
  for (const Station& station : stations)
    result.push_back(*std::min_element(station.begin(), station.end(), [](const auto& a, const auto& b) {
      return a.header->instanceNumber.value_or(0.0) < b.header->instanceNumber.value_or(0.0);
    }));
  return result;
}

} // namespace

std::vector<DicomSeries> seriesOf(const std::vector<DicomHeader>& headers) {
  std::vector<DicomSeries> parts;
  for (const DicomHeader& header : headers)
    for (std::size_t i = 0; i < header.frames.size(); ++i) {
      const DicomSlice slice{&header, static_cast<int>(i)};
      // Files of a series mostly follow each other, so look at the newest part first.
      const auto found = std::find_if(parts.rbegin(), parts.rend(), [&](const DicomSeries& part) {
        return makeOneVolume(part.front(), slice) &&
               part.front().header->path.parent_path() == header.path.parent_path();
      });
      if (found == parts.rend())
        parts.push_back({slice});
      else
        found->push_back(slice);
    }
  std::vector<DicomSeries> all = merged(std::move(parts));
  const auto rank = [](const DicomSeries& series) {
    const DicomHeader& first = *series.front().header;
    const double voxels =
        static_cast<double>(first.columns) * first.rows * static_cast<double>(series.size());
    return std::tuple(!canBecomeVolume(series), -voxels, first.seriesNumber.value_or(0.0));
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const DicomSeries& a, const DicomSeries& b) { return rank(a) < rank(b); });
  return all;
}

SeriesSummary summaryOf(const DicomSeries& series, int number) {
  const DicomHeader& first = *series.front().header;
  return {.number = number,
          .description = first.seriesDescription,
          .modality = first.modality,
          .dims = {first.columns, first.rows, static_cast<int>(series.size())},
          .thicknessMm = series.front().frame().thicknessMm,
          .date = first.patient.studyDate,
          .folder = {}};
}

bool isPlaced(const DicomSeries& series) {
  return std::all_of(series.begin(), series.end(), [](const DicomSlice& slice) {
    return slice.frame().positionMm.has_value() && slice.frame().axes.has_value();
  });
}

double distanceMm(const DicomSlice& slice, const DicomSeries& series) {
  const auto& axes = *series.front().frame().axes;
  return glm::dot(*slice.frame().positionMm, glm::cross(axes[0], axes[1]));
}

DicomSeries sorted(DicomSeries series) {
  const bool usePosition = isPlaced(series);
  const DicomSeries reference = series;
  const auto key = [&](const DicomSlice& slice) {
    return std::tuple(usePosition ? distanceMm(slice, reference) : 0.0,
                      slice.header->instanceNumber.value_or(std::numeric_limits<double>::max()),
                      std::cref(slice.header->path.native()), slice.frameIndex);
  };
  std::stable_sort(series.begin(), series.end(), [&](const DicomSlice& a, const DicomSlice& b) {
    const auto left = key(a);
    const auto right = key(b);
    return std::tie(std::get<0>(left), std::get<1>(left), std::get<2>(left).get(), std::get<3>(left)) <
           std::tie(std::get<0>(right), std::get<1>(right), std::get<2>(right).get(), std::get<3>(right));
  });
  return series;
}

DicomSeries shownOf(const DicomSeries& series, std::vector<Message>& warnings) {
  DicomSeries shown = withoutCopies(sorted(series), warnings);
  return isPlaced(shown) ? onePhase(shown, warnings) : shown;
}

} // namespace limn
