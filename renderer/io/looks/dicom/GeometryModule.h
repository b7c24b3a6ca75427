// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/Items.h"
#include "scene/Scene.h"

#include <array>

// The Volume Render Geometry module (PS3.3 C.11.30): from where, how wide, in which way.

// The Volume Cropping module (PS3.3 C.11.24): boxes along the volume's axes.
namespace limn::dicom {

/// What the module holds, in patient millimetres.
struct Geometry {
  Camera camera;
  double aspect = 1.0; ///< width over height of the picture
  double nearMm = 0.0; ///< what lies nearer than this or farther than that is cut away
  double farMm = 0.0;
  Projection projection = Projection::composite; ///< composite, mip or minip
  std::optional<double> stepMm;                  ///< along the ray
};

/// What of a scene goes into the module: near and far lie outside the volume (near never behind the eye).
Geometry geometryOf(const Scene& scene);

/// How a projection is written: one that the standard does not know as composite.
Projection standardProjection(Projection projection);

/// Writes the module into an object.
void putGeometry(DcmItem& object, const Geometry& geometry);

/// Throws Error (input) where it is missing or contradicts itself.
Geometry geometryIn(DcmItem& object, const std::string& name, std::vector<Message>& changes);

/// The nearest and farthest depth of the volume's corners before the eye, mm.
ValueRange depthsOf(const Camera& camera, const Grid& grid);

/// Two opposite corners of a box, patient millimetres; its edges lie along the volume's axes.
using BoxCorners = std::array<glm::dvec3, 2>;

/// Writes a crop and the flags that refer to it; `input` is the item of the input sequence.
void putCrop(DcmItem& object, DcmItem& input, const CropBox& crop, const Grid& grid);

/// The boxes that apply to the one input. Throws Error (input) for what is cut out by a segmentation or a box
/// that is missing or damaged; planes are left out with a sentence.
std::vector<BoxCorners> cropsIn(DcmItem& object, DcmItem& input, const std::string& name,
                                std::vector<Message>& changes);

/// What all boxes leave of a volume, as fractions along its axes; nothing where they leave none.
std::optional<CropBox> cropWithin(const std::vector<BoxCorners>& boxes, const Grid& grid);

} // namespace limn::dicom
