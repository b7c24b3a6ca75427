// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/LabelsOnPlane.h"
#include "planes/PlanePixels.h"
#include "planes/Reformat.h"
#include "scene/regions/LabelColor.h"
#include "widgets/planes/PlaneContent.h"

#include <QImage>

namespace limn {

/// What of a volume is read for the picture of a slice.
struct PlaneReading {
  std::shared_ptr<const Volume> volume;
  PlaneGrid plane;
  PlaneSampling sampling;
  bool operator==(const PlaneReading&) const = default;
};

/// What is read for the picture of a slice on a plane; there is a volume.
PlaneReading readingOf(const PlaneContent& content, const PlaneGrid& plane);

/// Makes the picture of one slice, and keeps what it read: another window or tint reads no voxel again, and
/// the same slice nothing at all.
class PlanePictures {
public:
  /// The slice on a plane: grey, tinted and outlined as the content's settings ask, with labels in their
  /// colours above the line around what is kept, and what is lit above them, transparent outside of the
  /// volume; outlines are so many pixels thick. There is a volume.
  const QImage& picture(const PlaneContent& content, const PlaneGrid& plane, int outlinePixels = 1);

  /// Whether the line around what is kept was painted within so many pixels of one of the last picture.
  bool hasKeptLineNear(const glm::ivec2& pixel, int within) const;

  /// How many pixels each way had better be read as one (`coarser`) so that it takes at most `mostMs`, judged
  /// by how long the last reading took: 1 where all can be, where nothing of the kind was read yet, and where
  /// this is the slice that was read.
  int coarseness(const PlaneContent& content, const PlaneGrid& plane, double mostMs) const;

  /// Takes what somebody else has read, in `ms`, in the place of what was read before.
  void take(const PlaneReading& read, const PlaneImage& values, double ms) { keep(read, values, ms); }

  /// Lets what was read go, as another volume is shown: who is hidden meanwhile would hold it.
  void forget();

  /// How often voxels were read.
  int readings() const { return m_readings; }

private:
  // The labels of a map on a plane.
  struct OnPlane {
    std::shared_ptr<const LabelMap> map;
    PlaneGrid plane;
    PlanePlaces labels;
  };

  void keep(const PlaneReading& read, PlaneImage values, double ms);
  void weigh(const PlaneContent& content, const PlaneGrid& plane);
  void paintKeptLine(std::vector<std::uint32_t>& pixels, int outlinePixels);
  static const PlanePlaces& placesIn(OnPlane& known, const std::shared_ptr<const LabelMap>& map,
                                     const PlaneContent& content, const PlaneGrid& plane);
  void paintLabelsOver(std::vector<std::uint32_t>& pixels, const PlaneContent& content,
                       const PlaneGrid& plane, int outlinePixels);
  const PlaneLooks* looksOf(const PlaneContent& content, const PlaneGrid& plane);

  PlaneReading m_read;
  PlaneImage m_values;
  Region m_region; ///< whose weights were read
  PlaneImage m_weights;
  std::vector<std::uint8_t> m_keptLine; ///< of the picture: where it runs; empty where there is none
  Region m_looked;                      ///< of whose labels the looks were read
  PlaneLooks m_looks;   ///< of the content, or of the label alone of whose curve a point lights up
  OnPlane m_labels;     ///< of a segmentation
  ShownColors m_colors; ///< of its labels
  OnPlane m_lit;
  PlaneContent m_painted;
  QImage m_picture;
  int m_readings = 0;
  double m_msPerPixel = 0.0; ///< of the last reading
};

} // namespace limn
