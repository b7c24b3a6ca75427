// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/MaskFolder.h"

#include "io/labels/LabelNames.h"
#include "io/reading/ReadError.h"
#include "regions/LabelsOnGrid.h"
#include "scene/regions/BodyAndLabels.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestMaskName = 200;
constexpr std::size_t mostNamed = 3;

// What a file is called by a name of its own or its folder's; empty where that may name the patient.
std::string whereHarmless(const std::string& name, const PatientLabel& patient) {
  return withoutPatient(name, patient) == name ? plainText(name, longestMaskName) : std::string();
}

std::string stemName(const fs::path& file, const PatientLabel& patient) {
  const std::string stem = volumeStem(file);
  return whereHarmless(stem.empty() ? file.stem().string() : stem, patient);
}

std::string nameWithFolder(const fs::path& file, const PatientLabel& patient) {
  const std::string structure = structureName(file, patient);
  const std::string name = structure.empty() ? stemName(file, patient) : structure;
  const std::string folder = whereHarmless(file.parent_path().filename().string(), patient);
  return name.empty() || folder.empty() ? std::string() : name + " (" + folder + ")";
}

bool isNamed(const std::vector<Label>& labels, const std::string& name) {
  return std::ranges::find(labels, name, &Label::name) != labels.end();
}

// What a mask is called among others: the first that is its alone of its structure, its whole name, and
// either with the folder that it lies in, unless a label before it has that name from its file.
std::string maskName(const fs::path& file, int value, const std::vector<fs::path>& files,
                     const std::vector<Label>& before, const PatientLabel& patient) {
  using Naming = std::string (*)(const fs::path&, const PatientLabel&);
  for (const Naming naming : {Naming(structureName), Naming(stemName), Naming(nameWithFolder)}) {
    const auto nameOf = [&](const fs::path& one) { return naming(one, patient); };
    std::string name = nameOf(file);
    if (!name.empty() && std::ranges::count(files, name, nameOf) == 1 && !isNamed(before, name))
      return name;
  }
  const std::string numbered = "Label " + std::to_string(value);
  std::string name = numbered;
  for (int n = 2; isNamed(before, name); ++n)
    name = numbered + " (" + std::to_string(n) + ")";
  return name;
}

// The files of a folder by name; hidden ones are none of the user's.
std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.'))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Message listOf(const std::vector<std::string>& names) {
  Message list;
  for (std::size_t n = 0; n < std::min(names.size(), mostNamed); ++n)
    list = list.followedBy(", ", plainText(names[n], longestMaskName));
  return names.size() > mostNamed ? Message::tr("%1 and %2 more").arg(list, names.size() - mostNamed) : list;
}

// Whether masks come by name, as those of a folder, or in the order in which they were chosen.
enum class Order { byName, asChosen };

Message overlapOf(std::size_t voxels, Order order) {
  if (voxels == 1)
    return order == Order::byName
               ? Message::tr("%1 voxel lies in two masks and belongs to the one whose name comes last: to %2 "
                             "and not to %3.")
               : Message::tr("%1 voxel lies in two masks and belongs to the one that was opened last: to %2 "
                             "and not to %3.");
  return order == Order::byName
             ? Message::tr("%1 voxels lie in two masks and belong to the one whose name comes last: to %2 "
                           "and not to %3.")
             : Message::tr("%1 voxels lie in two masks and belong to the one that was opened last: to %2 "
                           "and not to %3.");
}

// Of labels that stay in the list without a voxel; in one sentence, however many they are.
Message coveredIn(const MasksOnGrid& masks, const LabelMap& finished) {
  const std::vector<MasksOnGrid::Covered> covered = masks.coveredIn(finished);
  if (covered.empty())
    return {};
  std::vector<std::string> names;
  for (const MasksOnGrid::Covered& one : covered)
    names.push_back(one.label);
  const std::string& by = covered.front().by;
  const bool isByOne = !by.empty() && std::ranges::all_of(covered, [&](const MasksOnGrid::Covered& one) {
    return one.by == by;
  });
  if (covered.size() == 1)
    return isByOne ? Message::tr("%1 has no voxels of its own: %2, read after it, covers them.")
                         .arg(listOf(names), by)
                   : Message::tr("%1 has no voxels of its own: masks read after it cover them.")
                         .arg(listOf(names));
  return isByOne ? Message::tr("%1 labels have no voxels of their own, because %2, read after them, covers "
                               "them: %3.")
                       .arg(names.size(), by, listOf(names))
                 : Message::tr("%1 labels have no voxels of their own, because masks read after them cover "
                               "them: %2.")
                       .arg(names.size(), listOf(names));
}

Message overlapIn(const MasksOnGrid& masks, Order order) {
  const auto& largest = masks.largestOverlap();
  if (!largest)
    return {};
  if (largest->voxels == masks.overlapping())
    return overlapOf(largest->voxels, order).arg(largest->voxels, largest->winner, largest->loser);
  return (order == Order::byName
              ? Message::tr("%1 voxels lie in more than one mask and belong to the one whose name comes "
                            "last; most of them, %2, to %3 and not to %4.")
              : Message::tr("%1 voxels lie in more than one mask and belong to the one that was opened "
                            "last; most of them, %2, to %3 and not to %4."))
      .arg(masks.overlapping(), largest->voxels, largest->winner, largest->loser);
}

Message leftOutOf(const std::vector<std::string>& skipped) {
  if (skipped.empty())
    return {};
  return skipped.size() == 1 ? Message::tr("%1 is no mask and was left out.").arg(listOf(skipped))
                             : Message::tr("%1 files are no masks and were left out: %2.")
                                   .arg(skipped.size(), listOf(skipped));
}

} // namespace

bool isMaskFolder(const fs::path& path) {
  try {
    const std::vector<fs::path> files = fs::is_directory(path) ? filesIn(path) : std::vector<fs::path>();
    return std::any_of(files.begin(), files.end(),
                       [](const fs::path& file) { return !volumeStem(file).empty(); });
  } catch (const fs::filesystem_error&) {
    return false;
  }
}

namespace {

// What a mask becomes among others: as its file describes it, by a name that is still free, or called `name`.
Label labelOf(const LabelVolume& mask, int value, const std::string& name, const std::vector<Label>& taken) {
  const double own = mask.volume->range().highest;
  const auto found = std::ranges::find_if(mask.described, [&](const Label& one) { return one.value == own; });
  if (found == mask.described.end())
    return {value, name, labelColor(taken.size())};
  Label label = *found;
  label.value = value;
  if (label.name.empty() || isNamed(taken, label.name))
    label.name = name;
  return label;
}

// Masks on a grid, and of which files they are; none where no file is one.
struct ReadMasks {
  std::optional<MasksOnGrid> masks{};
  std::vector<fs::path> files{};
  std::vector<std::size_t> voxels{}; ///< of each, on the grid
  std::vector<std::string> skipped{};
};

ReadMasks readInOrder(const std::vector<fs::path>& files, Order order, const Grid& grid,
                      const Progress& progress, const PatientLabel& patient) {
  ReadMasks read;
  int value = 0;
  for (std::size_t n = 0; n < files.size(); ++n) {
    // A folder may hold whatever else; what is chosen is meant.
    const bool isVolume = order == Order::byName ? !volumeStem(files[n]).empty() : mayBeMask(files[n]);
    const auto share = [&](double done) {
      return (static_cast<double>(n) + done) / static_cast<double>(files.size());
    };
    const LabelVolume mask =
        isVolume ? readLabelVolume(files[n], part(progress, share(0.0), share(0.8))) : LabelVolume{};
    const bool isTaken = mask.volume && isMask(*mask.volume);
    // A folder's numbers hold whatever its files hold; of others those that are no masks are left out for
    // good.
    value += (order == Order::byName ? isVolume : isTaken) ? 1 : 0;
    if (!isTaken) {
      read.skipped.push_back(files[n].filename().string());
      continue;
    }
    requireNear(files[n], mask.volume->grid(), grid);
    if (!read.masks)
      read.masks.emplace(grid, files.size(), mask.volume->room());
    read.files.push_back(files[n]);
    const std::vector<Label>& taken = read.masks->labels();
    const std::string name = maskName(files[n], value, files, taken, patient);
    const Label label = order == Order::asChosen ? labelOf(mask, value, name, taken)
                                                 : Label{value, name, labelColor(taken.size())};
    read.voxels.push_back(
        read.masks->add(*mask.volume, label,
                        effortOf(part(progress, share(0.8), share(1.0)), Message::tr("Placing labels"))));
  }
  return read;
}

// Empty where they came so.
std::vector<fs::path> smallestLastOf(const ReadMasks& read) {
  std::vector<std::size_t> order(read.files.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t n) { return read.voxels[n]; });
  if (std::ranges::is_sorted(order))
    return {};
  std::vector<fs::path> files;
  for (const std::size_t n : order)
    files.push_back(read.files[n]);
  return files;
}

Region regionOf(MasksOnGrid& masks, const std::string& source) {
  const auto map = masks.finished();
  return {Region::Kind::labels, source, map, std::vector<double>(map->labels().size(), 1.0)};
}

} // namespace

Segmentation readMaskFolder(const fs::path& folder, const Grid& grid, const Progress& progress,
                            const PatientLabel& patient) {
  ReadMasks read = readInOrder(filesIn(folder), Order::byName, grid, progress, patient);
  if (!read.masks)
    failReading(folder, Message::tr("no file in it is the mask of a structure: 0, and one value inside"),
                Message::tr("open the folder that the segmentation was written to"));
  const Message remark = leftOutOf(read.skipped).followedBy(" ", overlapIn(*read.masks, Order::byName));
  const Region region = regionOf(*read.masks, sourceOf(folder));
  const Message covered = coveredIn(*read.masks, *region.labels);
  if (region.weights.size() == 1)
    failReading(folder, Message::tr("all of its masks are empty"),
                Message::tr("open the segmentation of this volume"));
  return {region, covered.followedBy(" ", remark), covered,
          covered.empty() ? std::vector<fs::path>() : smallestLastOf(read)};
}

Segmentation readMasks(const std::vector<fs::path>& files, const Grid& grid, const Progress& progress,
                       const PatientLabel& patient) {
  ReadMasks read = readInOrder(files, Order::asChosen, grid, progress, patient);
  if (!read.masks)
    failReading(files.front(),
                Message::tr("neither it nor another file that was chosen is the mask of a structure: 0, and "
                            "one value inside"),
                Message::tr("open a file of several labels by itself"));
  const Message remark = leftOutOf(read.skipped).followedBy(" ", overlapIn(*read.masks, Order::asChosen));
  Region region = regionOf(*read.masks, sourceOf(read.files.front()));
  const Message covered = coveredIn(*read.masks, *region.labels);
  if (region.weights.size() == 1)
    failReading(files.front(), Message::tr("it and the other masks that were chosen are empty"),
                Message::tr("open the segmentation of this volume"));
  if (read.files.size() == 1) // with the number that its file gives it, as it is read again
    return {readSegmentation(read.files.front(), grid, progress, patient).region, remark};
  for (std::size_t n = 1; n < read.files.size(); ++n)
    region.moreSources.push_back(sourceOf(read.files[n]));
  return {region, covered.followedBy(" ", remark), covered,
          covered.empty() ? std::vector<fs::path>() : smallestLastOf(read)};
}

bool isOfMasks(const Region& region) {
  if (region.kind != Region::Kind::labels || !region.moreSources.empty())
    return region.kind == Region::Kind::labels;
  const std::vector<Label>& labels = region.labels->labels();
  return region.isOfFile && listedLabels(region) == 2 && labels[0].value == 0 && labels[1].value > 0;
}

namespace {

// One of the masks of a region.
struct OpenMask {
  std::string source;
  std::size_t place = 0;    // among the region's labels; 0 where the mask has no voxel
  bool isDescribed = false; // by its file, whose name it has
};

std::vector<OpenMask> masksIn(const Region& region, const PatientLabel& patient) {
  const std::vector<std::string> sources = sourcesOf(region);
  const std::vector<fs::path> files(sources.begin(), sources.end());
  const std::vector<Label>& labels = region.labels->labels();
  std::vector<OpenMask> masks;
  for (std::size_t n = 0; n < sources.size(); ++n) {
    const int number = static_cast<int>(n) + 1;
    const bool isAlone = sources.size() == 1; // with the number that its file gives it
    const auto label = isAlone ? labels.begin() + 1 : std::ranges::find(labels, number, &Label::value);
    OpenMask mask{sources[n]};
    const VoxelBox box = label == labels.end()
                             ? VoxelBox{}
                             : region.labels->boxAround(static_cast<std::size_t>(label - labels.begin()));
    // Of several, those that are listed had a voxel before others took it.
    if (label != labels.end() && (!isAlone || box.lower != box.upper)) {
      mask.place = static_cast<std::size_t>(label - labels.begin());
      const std::string structure = isAlone ? structureName(files[n], patient) : std::string();
      const std::string given = !isAlone ? maskName(files[n], number, files, {labels.begin(), label}, patient)
                                : structure.empty() ? "Label " + std::to_string(label->value)
                                                    : structure;
      mask.isDescribed = label->name != given;
    }
    masks.push_back(mask);
  }
  return masks;
}

const Message placingLabels = Message::tr("Placing labels");

// How many voxels of a label are the background of another map.
std::size_t voxelsLost(const LabelMap& before, std::size_t place, const LabelMap& after,
                       const Progress& progress) {
  const VoxelBox& box = before.boxAround(place);
  std::size_t lost = 0;
  for (int z = box.lower.z; z < box.upper.z; ++z) {
    reportOrStop(progress, 1.0 * (z - box.lower.z) / (box.upper.z - box.lower.z), placingLabels);
    for (int y = box.lower.y; y < box.upper.y; ++y)
      for (int x = box.lower.x; x < box.upper.x; ++x) {
        const std::size_t voxel = voxelOffset(before.dims(), x, y, z);
        lost += before.placeAt(voxel) == place && after.placeAt(voxel) == 0;
      }
  }
  return lost;
}

// Masks of two regions on their way to become one.
class MaskJoin {
public:
  MaskJoin(const Region& open, const Region& opened, const Grid& grid, const PatientLabel& patient,
           std::shared_ptr<Room> room)
      : m_open(open), m_patient(patient), m_had(masksIn(open, patient)), m_come(masksIn(opened, patient)) {
    for (const OpenMask& mask : m_had)
      if (std::ranges::find(m_come, mask.source, &OpenMask::source) == m_come.end())
        m_stay.push_back(mask);
    for (const std::vector<OpenMask>* masks : {&m_stay, &m_come})
      for (const OpenMask& mask : *masks)
        m_files.emplace_back(mask.source);
    m_masks.emplace(grid, m_files.size(), std::move(room));
    m_weights.push_back(open.weights.front());
    takeLook(0, 0);
  }

  void addOpen(const Effort& effort) { add(m_stay, m_open, effort); }
  void addOpened(const Region& opened, const Effort& effort) { add(m_come, opened, effort); }

  Segmentation finished(const Progress& progress) {
    Region region = regionOf(*m_masks, m_files.front().string());
    region.weights = m_weights;
    for (std::size_t n = 1; n < m_files.size(); ++n)
      region.moreSources.push_back(m_files[n].string());
    region.isOfFile = m_files.size() == 1;
    const Message covered = coveredIn(*m_masks, *region.labels);
    const Message overlap = overlapIn(*m_masks, Order::asChosen);
    return {withLooks(region, m_looks),
            covered.followedBy(" ", overlap).followedBy(" ", leftToNobody(*region.labels, progress)),
            covered};
  }

private:
  void add(const std::vector<OpenMask>& masks, const Region& region, const Effort& effort) {
    std::vector<std::optional<Label>> labels(region.labels->labels().size());
    for (const OpenMask& mask : masks) {
      ++m_number;
      if (mask.place == 0)
        continue;
      const auto before = std::ranges::find(m_had, mask.source, &OpenMask::source);
      const std::size_t shown = before == m_had.end() ? 0 : before->place;
      if (shown > 0)
        takeLook(shown, m_weights.size());
      m_weights.push_back(shown > 0 ? m_open.weights[shown] : 1.0);
      labels[mask.place] = labelOf(mask, region);
      m_taken.push_back(*labels[mask.place]);
    }
    m_masks->add(*region.labels, labels, effort);
  }

  // What its file says of it stays; what follows from its number or the other files is found anew.
  Label labelOf(const OpenMask& mask, const Region& region) const {
    Label label = region.labels->labels()[mask.place];
    if (label.color == labelColor(mask.place))
      label.color = labelColor(m_taken.size());
    if (m_files.size() == 1)
      return label;
    label.value = m_number;
    if (!mask.isDescribed || isNamed(m_taken, label.name))
      label.name = maskName(mask.source, m_number, m_files, m_taken, m_patient);
    return label;
  }

  // A mask that is opened once more may be smaller now. Whether others have what it had before is known to
  // their files alone.
  Message leftToNobody(const LabelMap& joined, const Progress& progress) const {
    Message left;
    const auto count = static_cast<double>(m_had.size());
    for (std::size_t n = 0; n < m_had.size(); ++n) {
      const OpenMask& mask = m_had[n];
      const bool isOpenedAgain = std::ranges::find(m_come, mask.source, &OpenMask::source) != m_come.end();
      if (!isOpenedAgain || m_stay.empty() || mask.place == 0)
        continue;
      const std::size_t voxels =
          voxelsLost(*m_open.labels, mask.place, joined, part(progress, n / count, (n + 1) / count));
      const Message lost =
          voxels == 1 ? Message::tr("%1 voxel that %2 had before belongs to no mask now; open a mask "
                                    "that has it, too, once more.")
                      : Message::tr("%1 voxels that %2 had before belong to no mask now; open a "
                                    "mask that has them, too, once more.");
      if (voxels > 0)
        left = left.followedBy(" ", lost.arg(voxels, m_open.labels->labels()[mask.place].name));
    }
    return left;
  }

  void takeLook(std::size_t from, std::size_t to) {
    if (const std::size_t look = lookOfLabel(m_open, from); look > 0)
      m_looks[to] = m_open.looks[look - 1];
  }

  const Region& m_open;
  const PatientLabel& m_patient;
  std::vector<OpenMask> m_had, m_come;
  std::vector<OpenMask> m_stay; // of those that were open: the ones that are not opened once more
  std::vector<fs::path> m_files;
  std::optional<MasksOnGrid> m_masks;
  std::vector<Label> m_taken{{0, "Background", glm::dvec3(0.5)}};
  std::vector<double> m_weights;
  std::map<std::size_t, TransferFunction> m_looks;
  int m_number = 0; // of the file at hand
};

} // namespace

Segmentation joinedMasks(const Region& open, const Region& opened, const Grid& grid, const Progress& progress,
                         const PatientLabel& patient, std::shared_ptr<Room> room) {
  MaskJoin join(open, opened, grid, patient, std::move(room));
  join.addOpen(effortOf(part(progress, 0.0, 0.4), placingLabels));
  join.addOpened(opened, effortOf(part(progress, 0.4, 0.8), placingLabels));
  return join.finished(part(progress, 0.8, 1.0));
}

} // namespace limn
