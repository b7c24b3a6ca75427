// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/LookStore.h"

#include <algorithm>

namespace limn::cpu {

void LookStore::update(const Scene& scene, const BlockBox& box, const Effort& effort) {
  const LabelLooks looks = labelLooks(scene);
  if (!looks.areAny()) {
    *this = {};
    return;
  }
  const bool isSameVolume = m_volume == scene.volume;
  const bool isSameMap = isSameVolume && m_labels == scene.keep.labels && m_looks.ofLabel == looks.ofLabel;
  const bool isSameBox = isSameMap && m_box == box;
  if (!isSameVolume || m_looks.functions != looks.functions) {
    m_looks.functions = looks.functions;
    tabulate(scene.volume->range());
  }
  if (!isSameBox) {
    m_looks.ofLabel.clear(); // should it be cancelled
    const std::shared_ptr<Room>& room = scene.volume->room();
    m_blocks = blockLooks(*scene.keep.labels, looks.ofLabel,
                          {box.upper - box.lower, glm::ivec3(blockSize), box.lower}, effort, room);
    m_looks.ofLabel = looks.ofLabel;
    if (!isSameMap)
      findVoxels(*scene.keep.labels, room, effort);
  }
  m_volume = scene.volume;
  m_labels = scene.keep.labels;
  m_box = box;
}

void LookStore::tabulate(const ValueRange& range) {
  m_tables.clear();
  m_segments.clear();
  for (const TransferFunction& function : m_looks.functions) {
    m_tables.push_back(tableOf(function, range));
    m_segments.push_back(fewSegments(m_tables.back()));
  }
  m_union = tableOf(unionOf(m_looks.functions), range);
  m_unionSegments = fewSegments(m_union);
}

void LookStore::findVoxels(const LabelMap& labels, const std::shared_ptr<Room>& room, const Effort& effort) {
  m_labels.reset(); // should it be cancelled
  m_voxels = looksOfVoxels(labels, m_looks.ofLabel, effort, room);
  m_cells = cellLooks(labels.dims(), m_voxels, effort, room);
}

LookTerms LookStore::terms(const std::function<float(double)>& unitsPer) const {
  LookTerms terms;
  if (isEmpty())
    return terms;
  terms.voxels = sourceOf(m_voxels.data(), VoxelSource::Kind::byte, m_labels->dims());
  terms.ofCells = m_cells.data();
  for (std::size_t i = 0; i < m_tables.size(); ++i)
    terms.all.push_back({&m_tables[i], &m_segments[i], unitsPer(m_looks.functions[i].unitDistanceMm)});
  terms.together = &m_union;
  terms.segmentsTogether = &m_unionSegments;
  return terms;
}

} // namespace limn::cpu
