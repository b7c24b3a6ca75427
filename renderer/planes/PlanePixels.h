// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/Reformat.h"
#include "scene/function/TransferFunction.h"

#include <cstdint>
#include <optional>

namespace limn {

/// The grey of a value, 0 black to 1 white: `(value - centre)/width + 1/2` within 0..1, which is DICOM's
/// LINEAR_EXACT (PS3.3 C.11.2.1.3.2).
double greyOf(const GreyWindow& window, double value);

/// The way through tissue, mm, whose opacity is how strongly a slice is tinted: a whole centimetre, so that
/// tissue shows that a curve makes only faintly opaque.
inline constexpr double tintPathMm = 10.0;

/// The most that a tint covers of the grey below, so that its structure still shows.
inline constexpr double strongestTint = 0.7;

/// The looks of labels on a slice.
struct PlaneLooks {
  LabelLooks looks;
  PlaneShares shares;
};

/// What colours a slice beside its grey.
struct PlaneTint {
  const TransferFunction& function;
  const PlaneImage* weights = nullptr; ///< of the kept region: a factor of the opacity; null: all is kept
  /// Of the function: the tint is its share of the values (shareOfPoint) in the colour of emphasis instead.
  std::optional<std::size_t> emphasisedPoint = std::nullopt;
  /// Where labels have looks of their own: these in the place of function and weights, the first being the
  /// function.
  const PlaneLooks* looks = nullptr;
  std::size_t emphasisedLook = 0; ///< of these: whose point is emphasised, while the others show nothing
};

/// The pixels of a slice as 0xAARRGGBB: grey by the window, with the colours of the tint above it, as opaque
/// as `tintPathMm` of that tissue but at most `strongestTint`; 0 (transparent) outside the volume. Between
/// voxels of different looks their extinctions are mixed by their shares, as in pictures.
std::vector<std::uint32_t> planePixels(const PlaneImage& image, const GreyWindow& window,
                                       const std::optional<PlaneTint>& tint, const Effort& effort = {});

/// Where a kept region ends: pixels inside it (weight ≥ ½) with one in the volume and not kept at most
/// `thickness` pixels beside, above or below.
std::vector<std::uint8_t> outlineOf(const PlaneImage& weights, int thickness = 1);

} // namespace limn
