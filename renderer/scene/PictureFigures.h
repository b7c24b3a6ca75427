// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/basics/Image.h"

namespace limn {

/// Which pixels of a picture count: those that the volume covers, alpha ≥ 1/510 (DEFINITION section 9).
bool isCovered(const glm::vec4& pixel);

/// How far the light terms of a picture overflow before they are limited (paper, section 7: "partial overflow
/// of highlights").
struct Overflow {
  double share = 0.0;         ///< of the covered pixels with a channel over 1, 0..1
  double meanOvershoot = 0.0; ///< of the largest channel of those pixels over 1
  bool operator==(const Overflow&) const = default;
};

/// Measures a picture drawn without limits (`RayCaster::renderUnlimited`).
Overflow overflowOf(const Image& unlimited);

/// What differs between two pictures, levels of 255: of all channels of the pixels that either covers.
struct PictureChange {
  double mostLevels = 0.0;
  double meanLevels = 0.0;
  bool operator==(const PictureChange&) const = default;
};

/// Of two pictures of as many pixels; none where nothing is covered.
PictureChange changeBetween(const Image& picture, const Image& other);

/// The RMS contrast of a picture: the standard deviation of the luminance (0.2126 R + 0.7152 G + 0.0722 B of
/// the display values over black, 0..1) over its covered pixels; 0 without any.
double contrastOf(const Image& image);

/// Two scenes that together measure how much of a tissue can be seen: what lies at or above the scene's
/// isovalue, through all that lies before it.
struct TissueScenes {
  Scene weights; ///< its red channel is the weight of the tissue's light in each pixel, 0..1
  Scene surface; ///< covered where a ray meets the tissue at all
};

/// Keeps everything that decides on opacity (transfer function, model, gradient opacity, crop, camera, step)
/// and makes the tissue white, the rest black, under ambient light alone.
TissueScenes tissueScenes(const Scene& scene);

/// The mean weight of the tissue over the pixels whose rays meet it, 0..1; 0 where none does.
double visibleShare(const Image& weights, const Image& surface);

/// What can be said of a picture in numbers: its contrast, the overflow of its highlights before they are
/// limited, and how much of what lies at or above the scene's isovalue can be seen through the rest.
struct PictureFigures {
  double contrast = 0.0;
  Overflow overflow;
  double visibleShare = 0.0; ///< 0..1
};

} // namespace limn
