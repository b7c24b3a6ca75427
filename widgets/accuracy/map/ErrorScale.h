// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorMap.h"

#include <QColor>
#include <QImage>

#include <array>

namespace limn {

/// The labelled errors of the scale, levels; the last stands for everything beyond.
inline constexpr std::array<double, 6> errorScaleTicks{0.0, 0.5, 1.0, 2.0, 5.0, 10.0};

/// The place of an error on the scale, 0..1: logarithmic from half a level on, linear below.
double errorScalePlace(double levels);

/// The colour at a place of the scale: from dark violet over red to light yellow, lightness rising evenly
/// (Ottosson, "A perceptual color space for image processing", 2020: Oklab), so that it is also read without
/// colour vision.
QColor errorScaleColor(double place);

/// The map in the colours of the scale, transparent where nothing is covered.
QImage errorMapImage(const ErrorMap& map);

} // namespace limn
